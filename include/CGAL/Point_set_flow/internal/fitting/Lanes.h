// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_FITTING_LANES_H
#define CGAL_POINT_SET_FLOW_INTERNAL_FITTING_LANES_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/Core_kernel.h>

#include <Eigen/Core>

#include <boost/config.hpp>

#include <array>
#include <cmath>
#include <cstddef>

// Where Eigen has packets of four floats and two doubles, which it converts into each other
#if defined(EIGEN_VECTORIZE_SSE) ||                                                                \
    (defined(EIGEN_VECTORIZE_NEON) && EIGEN_ARCH_ARM64 && EIGEN_VERSION_AT_LEAST(3, 4, 0))
#define CGAL_POINT_SET_FLOW_HAS_PACKETS
#endif

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// One number for each of four neighbors, computed at once: one register on any x86-64 or ARM processor.
typedef Eigen::Array<float, 4, 1> Lanes;

/// Vectors of four neighbors
struct Lanes_3 {
  Lanes x, y, z;

  // inlined, as all that follows, or registers would pass through memory
  BOOST_FORCEINLINE Lanes operator*(const Lanes_3& v) const { return x * v.x + y * v.y + z * v.z; }
  BOOST_FORCEINLINE Lanes squared_length() const { return *this * *this; }
};

inline Lanes_3 same_lanes(const Vector_3& v)
{
  return {Lanes::Constant(float(v.x())), Lanes::Constant(float(v.y())),
          Lanes::Constant(float(v.z()))};
}

/// The numbers of four neighbors
typedef std::array<std::size_t, 4> Lane_numbers;

#ifdef CGAL_POINT_SET_FLOW_HAS_PACKETS
#if defined(__GNUC__) // packets have attributes, which templates need not know
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wignored-attributes"
#endif

typedef Eigen::internal::Packet4f Packet_4;

BOOST_FORCEINLINE Packet_4 packet(const Lanes& lanes)
{
  return Eigen::internal::pload<Packet_4>(lanes.data());
}

BOOST_FORCEINLINE Lanes lanes(const Packet_4& packet)
{
  Lanes result;
  Eigen::internal::pstore(result.data(), packet);
  return result;
}

/// The vectors from a point to four others, times `scale`: differences and products are taken in double, so that
/// the lanes hold all their digits wherever the points are.
BOOST_FORCEINLINE Lanes_3 differences(const Point_3* points, const Point_3& from,
                                      const Lane_numbers& to, double scale)
{
  using namespace Eigen::internal;
  static_assert(sizeof(Point_3) == 3 * sizeof(double), "points are three doubles");
  const double* const p = &*from.cartesian_begin();
  const Packet2d xy = ploadu<Packet2d>(p), yz = ploadu<Packet2d>(p + 1);
  const Packet2d scales = pset1<Packet2d>(scale);
  const auto row = [&](std::size_t l) {
    const double* const q = &*points[to[l]].cartesian_begin();
    return pcast<Packet2d, Packet_4>(pmul(psub(ploadu<Packet2d>(q), xy), scales),
                                     pmul(psub(ploadu<Packet2d>(q + 1), yz), scales));
  };
  // no loop, which would keep the rows in memory
  PacketBlock<Packet_4, 4> block = {{row(0), row(1), row(2), row(3)}};
  ptranspose(block); // x, y, y, z of each
  return {lanes(block.packet[0]), lanes(block.packet[1]), lanes(block.packet[3])};
}

/// The first three floats of four elements
/// \pre the elements are four floats each
template <typename Element>
BOOST_FORCEINLINE Lanes_3 vectors(const Element* elements, const Lane_numbers& of)
{
  using namespace Eigen::internal;
  static_assert(sizeof(Element) == 4 * sizeof(float), "elements are four floats");
  const auto row = [&](std::size_t l) { return ploadu<Packet_4>(&elements[of[l]].x); };
  PacketBlock<Packet_4, 4> block = {{row(0), row(1), row(2), row(3)}};
  ptranspose(block);
  return {lanes(block.packet[0]), lanes(block.packet[1]), lanes(block.packet[2])};
}

/// `x` with the other sign where `sign` is negative
BOOST_FORCEINLINE Lanes flipped(const Lanes& x, const Lanes& sign)
{
  using namespace Eigen::internal;
  return lanes(pxor(packet(x), pand(packet(sign), pset1<Packet_4>(-0.f))));
}

#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif
#else

inline Lanes_3 differences(const Point_3* points, const Point_3& from, const Lane_numbers& to,
                           double scale)
{
  Lanes_3 d;
  for (std::size_t l = 0; l < 4; ++l) {
    const Point_3& p = points[to[l]];
    d.x[Eigen::Index(l)] = float((p.x() - from.x()) * scale);
    d.y[Eigen::Index(l)] = float((p.y() - from.y()) * scale);
    d.z[Eigen::Index(l)] = float((p.z() - from.z()) * scale);
  }
  return d;
}

template <typename Element>
Lanes_3 vectors(const Element* elements, const Lane_numbers& of)
{
  Lanes_3 v;
  for (std::size_t l = 0; l < 4; ++l) {
    const Element& element = elements[of[l]];
    v.x[Eigen::Index(l)] = element.x;
    v.y[Eigen::Index(l)] = element.y;
    v.z[Eigen::Index(l)] = element.z;
  }
  return v;
}

inline Lanes flipped(const Lanes& x, const Lanes& sign)
{
  Lanes result;
  for (Eigen::Index l = 0; l < 4; ++l)
    result[l] = std::signbit(sign[l]) ? -x[l] : x[l];
  return result;
}

#endif

/// A weight from its exponent: \f$(1 - x/32)^{32}\f$, and 0 from 32 on. It is close to
/// \f$e^{-x}\f$, at a tenth of the cost.
BOOST_FORCEINLINE Lanes bell(const Lanes& x)
{
  Lanes b = (1.f - x * (1.f / 32.f)).max(0.f);
  b *= b;
  b *= b;
  b *= b;
  b *= b;
  return b * b;
}

/// The sum in double: those of many lanes lose no digits
BOOST_FORCEINLINE double sum(const Lanes& x)
{
  return (double(x[0]) + double(x[1])) + (double(x[2]) + double(x[3]));
}

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_FITTING_LANES_H
