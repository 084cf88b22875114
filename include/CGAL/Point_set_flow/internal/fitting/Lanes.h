// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_FITTING_LANES_H
#define CGAL_POINT_SET_FLOW_INTERNAL_FITTING_LANES_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/Core_kernel.h>

#include <Eigen/Core>

#include <boost/config.hpp>

#include <array>
#include <cstddef>
#include <utility>

// Where Eigen has packets of four floats and two doubles, which it converts into each other
#if defined(EIGEN_VECTORIZE_SSE) ||                                                                \
    (defined(EIGEN_VECTORIZE_NEON) && EIGEN_ARCH_ARM64 && EIGEN_VERSION_AT_LEAST(3, 4, 0))
#define CGAL_POINT_SET_FLOW_HAS_PACKETS
#endif

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// How many neighbors are computed at once: as many as one register of the target holds, four on any x86-64 or ARM
/// processor, eight with AVX. Sixteen would leave too many of the last lanes without a neighbor.
#if defined(CGAL_POINT_SET_FLOW_HAS_PACKETS) && defined(EIGEN_VECTORIZE_AVX)
constexpr std::size_t lane_width = 8;
#else
constexpr std::size_t lane_width = 4;
#endif

/// One number for each of these neighbors
typedef Eigen::Array<float, int(lane_width), 1> Lanes;

/// The numbers of these neighbors
typedef std::array<std::size_t, lane_width> Lane_numbers;

/// Vectors of these neighbors
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

/// Calls `visit(0)` to `visit(Count - 1)`, in a row: compilers would keep lanes of a loop in memory.
template <typename Visit, std::size_t... Index>
BOOST_FORCEINLINE void unroll(const Visit& visit, std::index_sequence<Index...>)
{
  (visit(Index), ...);
}
template <std::size_t Count, typename Visit>
BOOST_FORCEINLINE void unroll(const Visit& visit)
{
  unroll(visit, std::make_index_sequence<Count>());
}

/// `number(l)` of each lane `l`
template <typename Number, std::size_t... Lane>
BOOST_FORCEINLINE Lane_numbers lane_numbers(const Number& number, std::index_sequence<Lane...>)
{
  return {{number(Lane)...}};
}
template <typename Number>
BOOST_FORCEINLINE Lane_numbers lane_numbers(const Number& number)
{
  return lane_numbers(number, std::make_index_sequence<lane_width>());
}

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

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_FITTING_LANES_H
