// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_FITTING_LANE_VECTORS_H
#define CGAL_POINT_SET_FLOW_INTERNAL_FITTING_LANE_VECTORS_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/Compact_vector_3.h>
#include <CGAL/Point_set_flow/internal/fitting/Lanes.h>

#include <boost/config.hpp>

#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// One number for each of four lanes
typedef Eigen::Array<float, 4, 1> Four;

#ifdef CGAL_POINT_SET_FLOW_HAS_PACKETS
#if defined(__GNUC__) // packets have attributes, which templates need not know
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wignored-attributes"
#endif

typedef Eigen::internal::Packet2d Packet_2; // doubles
typedef Eigen::internal::Packet4f Packet_4;
typedef Eigen::internal::find_best_packet<float, int(lane_width)>::type Lane_packet;

/// Vectors of four neighbors
struct Packets_3 {
  Packet_4 x, y, z;
};

BOOST_FORCEINLINE Lane_packet packet(const Lanes& lanes)
{
  return Eigen::internal::ploadu<Lane_packet>(lanes.data());
}

BOOST_FORCEINLINE Lanes lanes(const Lane_packet& packet)
{
  Lanes result;
  Eigen::internal::pstoreu(result.data(), packet);
  return result;
}

/// The vectors that `four(i)` returns for the four lanes from `i` on
template <typename Get_four>
BOOST_FORCEINLINE Lanes_3 in_fours(const Get_four& four)
{
#ifdef EIGEN_VECTORIZE_AVX
  // not through memory, from which stores of halves cannot be forwarded to loads of both
  const auto joined = [](const Packet_4& low, const Packet_4& high) {
    return lanes(_mm256_insertf128_ps(_mm256_castps128_ps256(low), high, 1));
  };
  const Packets_3 low = four(0), high = four(4);
  return {joined(low.x, high.x), joined(low.y, high.y), joined(low.z, high.z)};
#else
  const Packets_3 all = four(0);
  return {lanes(all.x), lanes(all.y), lanes(all.z)};
#endif
}

/// The vectors from a point to others, times `scale`: differences and products are taken in double, so that
/// the lanes hold all their digits wherever the points are.
BOOST_FORCEINLINE Lanes_3 differences(const Point_3* points, const Point_3& from,
                                      const Lane_numbers& to, double scale)
{
  using namespace Eigen::internal;
  static_assert(sizeof(Point_3) == 3 * sizeof(double), "points are three doubles");
  const double* const p = &*from.cartesian_begin();
  const Packet_2 x = pset1<Packet_2>(p[0]), y = pset1<Packet_2>(p[1]), z = pset1<Packet_2>(p[2]);
  const Packet_2 scales = pset1<Packet_2>(scale);
  typedef PacketBlock<Packet_2, 2> Columns;
  const auto columns = [&](std::size_t l, int first) { // two coordinates of two points
    const auto row = [&](std::size_t number) {
      return ploadu<Packet_2>(&*points[number].cartesian_begin() + first);
    };
    Columns block = {{row(to[l]), row(to[l + 1])}};
    ptranspose(block);
    return block;
  };
  const auto narrowed = [&](const Packet_2& low, const Packet_2& high, const Packet_2& origin) {
    return pcast<Packet_2, Packet_4>(pmul(psub(low, origin), scales),
                                     pmul(psub(high, origin), scales));
  };
  return in_fours([&](std::size_t i) -> Packets_3 {
    const Columns xy = columns(i, 0), yz = columns(i, 1);
    const Columns high_xy = columns(i + 2, 0), high_yz = columns(i + 2, 1);
    return {narrowed(xy.packet[0], high_xy.packet[0], x),
            narrowed(xy.packet[1], high_xy.packet[1], y),
            narrowed(yz.packet[1], high_yz.packet[1], z)};
  });
}

/// Some of many vectors
/// \pre after the last of all, four bytes can be read
BOOST_FORCEINLINE Lanes_3 vectors(const Compact_vector_3* all, const Lane_numbers& of)
{
  using namespace Eigen::internal;
  const auto row = [&](std::size_t l) { return ploadu<Packet_4>(&all[of[l]].x); };
  return in_fours([&](std::size_t i) -> Packets_3 {
    // no loop, which would keep the rows in memory
    PacketBlock<Packet_4, 4> block = {{row(i), row(i + 1), row(i + 2), row(i + 3)}};
    ptranspose(block);
    return {block.packet[0], block.packet[1], block.packet[2]};
  });
}

/// `x` with the other sign where `sign` is negative
BOOST_FORCEINLINE Lanes flipped(const Lanes& x, const Lanes& sign)
{
  using namespace Eigen::internal;
  return lanes(pxor(packet(x), pand(packet(sign), pset1<Lane_packet>(-0.f))));
}

/// Square roots, correctly rounded. Those of Eigen begin with an approximation that is not the same on all processors.
BOOST_FORCEINLINE Lanes roots(const Lanes& x)
{
#if defined(EIGEN_VECTORIZE_AVX)
  return lanes(_mm256_sqrt_ps(packet(x)));
#elif defined(EIGEN_VECTORIZE_SSE)
  return lanes(_mm_sqrt_ps(packet(x)));
#else
  return x.sqrt();
#endif
}

/// The sums of each of four, not in double
BOOST_FORCEINLINE Four sums(const Lanes& a, const Lanes& b, const Lanes& c, const Lanes& d)
{
  using namespace Eigen::internal;
  const auto half = [](const Lanes& x) -> Packet_4 {
#ifdef EIGEN_VECTORIZE_AVX
    const Lane_packet p = packet(x);
    return padd(_mm256_castps256_ps128(p), _mm256_extractf128_ps(p, 1));
#else
    return packet(x);
#endif
  };
  PacketBlock<Packet_4, 4> block = {{half(a), half(b), half(c), half(d)}};
  ptranspose(block);
  Four result;
  pstoreu(result.data(),
          padd(padd(block.packet[0], block.packet[1]), padd(block.packet[2], block.packet[3])));
  return result;
}

#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif
#else

inline Lanes_3 differences(const Point_3* points, const Point_3& from, const Lane_numbers& to,
                           double scale)
{
  Lanes_3 d;
  for (std::size_t l = 0; l < lane_width; ++l) {
    const Point_3& p = points[to[l]];
    d.x[Eigen::Index(l)] = float((p.x() - from.x()) * scale);
    d.y[Eigen::Index(l)] = float((p.y() - from.y()) * scale);
    d.z[Eigen::Index(l)] = float((p.z() - from.z()) * scale);
  }
  return d;
}

inline Lanes_3 vectors(const Compact_vector_3* all, const Lane_numbers& of)
{
  Lanes_3 v;
  for (std::size_t l = 0; l < lane_width; ++l) {
    const Compact_vector_3& vector = all[of[l]];
    v.x[Eigen::Index(l)] = vector.x;
    v.y[Eigen::Index(l)] = vector.y;
    v.z[Eigen::Index(l)] = vector.z;
  }
  return v;
}

inline Lanes roots(const Lanes& x) { return x.sqrt(); }

inline Lanes flipped(const Lanes& x, const Lanes& sign)
{
  Lanes result;
  for (Eigen::Index l = 0; l < Eigen::Index(lane_width); ++l)
    result[l] = std::signbit(sign[l]) ? -x[l] : x[l];
  return result;
}

inline Four sums(const Lanes& a, const Lanes& b, const Lanes& c, const Lanes& d)
{
  return {a.sum(), b.sum(), c.sum(), d.sum()};
}

#endif

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_FITTING_LANE_VECTORS_H
