// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_FITTING_LEARNED_NETWORK_H
#define CGAL_POINT_SET_FLOW_INTERNAL_FITTING_LEARNED_NETWORK_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/internal/fitting/Lane_vectors.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// `Size` numbers, four at a time: the sizes of layers need not suit wider lanes.
template <std::size_t Size>
struct Layer : std::array<Four, Size / 4> {
  static_assert(Size % 4 == 0, "all are full");

  Layer() { this->fill(Four::Zero()); }
  explicit Layer(const float* numbers)
  {
    for (std::size_t i = 0; i < this->size(); ++i)
      (*this)[i] = Eigen::Map<const Four>(numbers + 4 * i);
  }
  /// Adds the product of a matrix, which is stored column by column, and a vector.
  template <std::size_t Columns>
  void add_product(const float* matrix, const float* vector)
  {
    for (std::size_t c = 0; c < Columns; ++c)
      unroll<Size / 4>([&](std::size_t i) {
        (*this)[i] += Eigen::Map<const Four>(matrix + c * Size + 4 * i) * vector[c];
      });
  }
};

/// A small network with trained weights, from the numbers of a neighborhood to an odd and an even one.
///
/// One layer works on each edge. From it come gates, and the means of the odd numbers of the edges weighted by
/// them: learned weights in place of Gaussians. A second layer combines these. If all normals are turned,
/// the odd output changes its sign, and both are bitwise identical otherwise: each layer works on the sum
/// of its even and odd inputs and on their difference. What the two results have in common is even, and
/// their difference is odd.
///
/// \tparam Input a `Network_input`
template <typename Input>
class Learned_network {
  static constexpr std::size_t hidden = 16, gates = 4, head = 20;
  static constexpr std::size_t edge_even = Input::edge_even, edge_odd = Input::edge_odd,
                               point_even = Input::point_even, point_odd = Input::point_odd;
  static constexpr std::size_t values = edge_odd + 1; ///< the last one is the mean of the first two
  static constexpr std::size_t odd_inputs = gates * values + point_odd;
  static constexpr std::size_t head_even = hidden + point_even + gates,
                               head_odd = hidden + odd_inputs;

  const float* m_end; // of the weights that have a name already
  // in the order in which they are stored, column by column but for the factors
  const float* const m_edge_even;
  const float* const m_edge_bias;
  const float* const m_edge_odd;
  const float* const m_point_even;
  const float* const m_point_odd;
  const float* const m_gate;
  const float* const m_gate_bias;
  const float* const m_head_even;
  const float* const m_head_bias;
  const float* const m_head_odd;
  const float* const m_factor;
  const float* const m_factor_bias;
  const float* const m_rest;
  const float* const m_even;
  const float* const m_even_bias;

  const float* take(std::size_t n)
  {
    m_end += n;
    return m_end - n;
  }

  /// What is left of the edges: means over the neighbors
  struct Means {
    std::array<float, head_even> even;
    std::array<float, head_odd> odd;
  };

  typedef typename Input::Edge_lanes Edge_lanes;
  typedef std::array<Edge_lanes, gates> Gate_lanes;
  static constexpr float few = .001f; // against division by 0
  /// hidden units that share reads and writes of the gates, if there are registers for them
  static constexpr std::size_t at_once = lane_width == 8 ? 2 : 1; // divides 4

public:
  struct Output {
    float odd, even;
  };

  explicit Learned_network(const float* weights)
      : m_end(weights), m_edge_even(take(hidden * edge_even)), m_edge_bias(take(hidden)),
        m_edge_odd(take(hidden * edge_odd)), m_point_even(take(hidden * point_even)),
        m_point_odd(take(hidden * point_odd)), m_gate(take(gates * hidden)),
        m_gate_bias(take(gates)), m_head_even(take(head * head_even)), m_head_bias(take(head)),
        m_head_odd(take(head * head_odd)), m_factor(take(odd_inputs * head)),
        m_factor_bias(take(odd_inputs)), m_rest(take(head)), m_even(take(head)),
        m_even_bias(take(1))
  {}

  [[gnu::flatten]] Output operator()(const Input& x) const
  {
    const Means means = over_edges(x);
    const float* const odd_means = means.odd.data() + hidden;
    Layer<head> e(m_head_bias), o, factors;
    e.template add_product<head_even>(m_head_even, means.even.data());
    o.template add_product<head_odd>(m_head_odd, means.odd.data());
    factors.template add_product<odd_inputs>(m_factor, odd_means);
    const Layer<head> rest(m_rest), to_even(m_even);
    Four odd = Four::Zero(), even = Four::Zero();
    for (std::size_t i = 0; i < e.size(); ++i) {
      const Four p = (e[i] + o[i]).max(0.f), m = (e[i] - o[i]).max(0.f);
      odd += factors[i] * (p + m) + rest[i] * (p - m);
      even += to_even[i] * (p + m);
    }
    float biased = odd.sum();
    for (std::size_t i = 0; i < odd_inputs; ++i)
      biased += m_factor_bias[i] * odd_means[i];
    return {biased, even.sum() + *m_even_bias};
  }

private:
  /// Some weights, each in all lanes
  template <std::size_t Size>
  static std::array<Lanes, Size> same_lanes(const float* weights, std::size_t stride)
  {
    std::array<Lanes, Size> lanes;
    unroll<Size>([&](std::size_t i) { lanes[i].setConstant(weights[i * stride]); });
    return lanes;
  }

  Means over_edges(const Input& x) const
  {
    Means means;
    Gate_lanes in_gates;
    for (std::size_t c = 0; c < gates; ++c)
      for (std::size_t g = 0; g < x.groups(); ++g)
        in_gates[c][g].setConstant(m_gate_bias[c]);
    add_hidden(x, in_gates, means);
    for (std::size_t i = 0; i < point_even; ++i)
      means.even[hidden + i] = x.of_point_even[i];
    for (std::size_t i = 0; i < point_odd; ++i)
      means.odd[hidden + gates * values + i] = x.of_point_odd[i];
    Four totals;
    for (std::size_t c = 0; c < gates; ++c)
      totals[Eigen::Index(c)] = weigh(x, in_gates[c], means.odd.data() + hidden + c * values);
    const Four logarithms = (totals / float(x.size) + few).log();
    for (std::size_t c = 0; c < gates; ++c)
      means.even[hidden + point_even + c] = logarithms[Eigen::Index(c)];
    return means;
  }

  /// The first layer: its means over the neighbors, and what gets into the gates
  void add_hidden(const Input& x, Gate_lanes& in_gates, Means& means) const
  {
    Layer<hidden> even(m_edge_bias), odd;
    even.template add_product<point_even>(m_point_even, x.of_point_even.data());
    odd.template add_product<point_odd>(m_point_odd, x.of_point_odd.data());
    Layer<hidden> sums_p, sums_m;
    for (std::size_t h = 0; h < hidden; h += at_once) {
      const auto of_point_even = same_lanes<at_once>(even[h / 4].data() + h % 4, 1),
                 of_point_odd = same_lanes<at_once>(odd[h / 4].data() + h % 4, 1);
      std::array<std::array<Lanes, edge_even>, at_once> of_even;
      std::array<std::array<Lanes, edge_odd>, at_once> of_odd;
      std::array<std::array<Lanes, gates>, at_once> of_gates;
      std::array<Lanes, at_once> sum_p, sum_m;
      unroll<at_once>([&](std::size_t i) {
        of_even[i] = same_lanes<edge_even>(m_edge_even + h + i, hidden);
        of_odd[i] = same_lanes<edge_odd>(m_edge_odd + h + i, hidden);
        of_gates[i] = same_lanes<gates>(m_gate + (h + i) * gates, 1);
        sum_p[i].setZero();
        sum_m[i].setZero();
      });
      for (std::size_t g = 0; g < x.groups(); ++g) {
        std::array<Lanes, at_once> both;
        unroll<at_once>([&](std::size_t i) {
          Lanes e = of_point_even[i], o = of_point_odd[i];
          unroll<edge_even>([&](std::size_t f) { e += x.even[f][g] * of_even[i][f]; });
          unroll<edge_odd>([&](std::size_t f) { o += x.odd[f][g] * of_odd[i][f]; });
          const Lanes p = (e + o).max(0.f), m = (e - o).max(0.f);
          both[i] = p + m;
          sum_p[i] += p;
          sum_m[i] += m;
        });
        unroll<gates>([&](std::size_t c) {
          unroll<at_once>([&](std::size_t i) { in_gates[c][g] += both[i] * of_gates[i][c]; });
        });
      }
      unroll<at_once>([&](std::size_t i) {
        const std::size_t k = h + i;
        sums_p[k / 4][Eigen::Index(k % 4)] = sum_p[i].sum();
        sums_m[k / 4][Eigen::Index(k % 4)] = sum_m[i].sum();
      });
    }
    const float inverse = 1.f / float(x.size), pads = float(x.pads());
    for (std::size_t i = 0; i < even.size(); ++i) {
      // what misses was counted, too: its numbers are 0
      const Four p = sums_p[i] - (even[i] + odd[i]).max(0.f) * pads,
                 m = sums_m[i] - (even[i] - odd[i]).max(0.f) * pads;
      Eigen::Map<Four>(means.even.data() + 4 * i) = (p + m) * inverse;
      Eigen::Map<Four>(means.odd.data() + 4 * i) = (p - m) * inverse;
    }
  }

  /// Weighted means of the odd numbers, the distances along both normals among them
  /// \return the sum of the weights
  static float weigh(const Input& x, const Edge_lanes& in_gate, float* means)
  {
    Lanes weights = Lanes::Zero();
    std::array<Lanes, edge_odd> weighted;
    unroll<edge_odd>([&](std::size_t f) { weighted[f].setZero(); });
    for (std::size_t g = 0; g < x.groups(); ++g) {
      const Lanes& gate = in_gate[g];
      const Lanes weight = (gate + roots(gate * gate + 1.f)) * x.mask[g];
      weights += weight;
      unroll<edge_odd>([&](std::size_t f) { weighted[f] += weight * x.odd[f][g]; });
    }
    const float total = .5f * weights.sum(), inverse = .5f / (total + few);
    for (std::size_t f = 0; f < edge_odd; ++f)
      means[f] = weighted[f].sum() * inverse;
    means[edge_odd] = .5f * (means[0] + means[1]);
    return total;
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_FITTING_LEARNED_NETWORK_H
