// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_FITTING_LEARNED_NETWORK_H
#define CGAL_POINT_SET_FLOW_INTERNAL_FITTING_LEARNED_NETWORK_H

#include <CGAL/license/Point_set_flow.h>

#include <Eigen/Core>

#include <cmath>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

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
  typedef typename Input::Edge_lanes Edge_lanes;
  static constexpr int hidden = 16, gates = 4, head = 20;
  static constexpr int values = Input::edge_odd + 1, odd_inputs = gates * values + Input::point_odd;
  static constexpr int head_even = hidden + Input::point_even + gates,
                       head_odd = hidden + odd_inputs;

  template <int Rows, int Columns>
  using Weights = Eigen::Map<
      const Eigen::Matrix<float, Rows, Columns, Columns == 1 ? Eigen::ColMajor : Eigen::RowMajor>>;

  const float* m_end; // of the weights that have a name already
  // in the order in which they are stored
  const Weights<hidden, Input::edge_even> m_edge_even;
  const Weights<hidden, 1> m_edge_bias;
  const Weights<hidden, Input::edge_odd> m_edge_odd;
  const Weights<hidden, Input::point_even> m_point_even;
  const Weights<hidden, Input::point_odd> m_point_odd;
  const Weights<gates, hidden> m_gate;
  const Weights<gates, 1> m_gate_bias;
  const Weights<head, head_even> m_head_even;
  const Weights<head, 1> m_head_bias;
  const Weights<head, head_odd> m_head_odd;
  const Weights<odd_inputs, head> m_factor;
  const Weights<odd_inputs, 1> m_factor_bias;
  const Weights<head, 1> m_rest;
  const Weights<head, 1> m_even;
  const Weights<1, 1> m_even_bias;

  const float* take(int n)
  {
    m_end += n;
    return m_end - n;
  }

  /// What is left of the edges: means over the neighbors
  struct Means {
    Eigen::Matrix<float, head_even, 1> even;
    Eigen::Matrix<float, head_odd, 1> odd;
  };

public:
  struct Output {
    float odd, even;
  };

  explicit Learned_network(const float* weights)
      : m_end(weights), m_edge_even(take(hidden * Input::edge_even)), m_edge_bias(take(hidden)),
        m_edge_odd(take(hidden * Input::edge_odd)), m_point_even(take(hidden * Input::point_even)),
        m_point_odd(take(hidden * Input::point_odd)), m_gate(take(gates * hidden)),
        m_gate_bias(take(gates)), m_head_even(take(head * head_even)), m_head_bias(take(head)),
        m_head_odd(take(head * head_odd)), m_factor(take(odd_inputs * head)),
        m_factor_bias(take(odd_inputs)), m_rest(take(head)), m_even(take(head)),
        m_even_bias(take(1))
  {}

  [[gnu::flatten]] Output operator()(const Input& x) const
  {
    const Means means = over_edges(x);
    const Eigen::Matrix<float, head, 1> e = m_head_even * means.even + m_head_bias;
    const Eigen::Matrix<float, head, 1> o = m_head_odd * means.odd;
    const Eigen::Matrix<float, head, 1> p = (e + o).cwiseMax(0.f), m = (e - o).cwiseMax(0.f);
    const Eigen::Matrix<float, odd_inputs, 1> factors = m_factor * (p + m) + m_factor_bias;
    return {factors.dot(means.odd.template tail<odd_inputs>()) + m_rest.dot(p - m),
            m_even.dot(p + m) + m_even_bias[0]};
  }

private:
  Means over_edges(const Input& x) const
  {
    Means means;
    const float inverse = 1.f / float(x.size);
    const Eigen::Matrix<float, hidden, 1> even = m_edge_bias + m_point_even * x.of_point_even,
                                          odd = m_point_odd * x.of_point_odd;
    Edge_lanes in_gates[gates];
    for (int c = 0; c < gates; ++c)
      in_gates[c].setConstant(m_gate_bias[c]);
    for (int h = 0; h < hidden; ++h) {
      Edge_lanes e = Edge_lanes::Constant(even[h]), o = Edge_lanes::Constant(odd[h]);
      for (int f = 0; f < Input::edge_even; ++f)
        e += m_edge_even(h, f) * x.even[f];
      for (int f = 0; f < Input::edge_odd; ++f)
        o += m_edge_odd(h, f) * x.odd[f];
      const Edge_lanes p = (e + o).max(0.f), m = (e - o).max(0.f), sum = p + m;
      means.even[h] = (sum * x.mask).sum() * inverse;
      means.odd[h] = ((p - m) * x.mask).sum() * inverse;
      for (int c = 0; c < gates; ++c)
        in_gates[c] += m_gate(c, h) * sum;
    }
    means.even.template segment<Input::point_even>(hidden) = x.of_point_even;
    weigh(x, in_gates, means);
    return means;
  }

  /// Weighted means of the odd numbers, the distances along both normals among them
  static void weigh(const Input& x, const Edge_lanes (&in_gates)[gates], Means& means)
  {
    const float few = .001f;
    const Edge_lanes both = .5f * (x.odd[0] + x.odd[1]);
    for (int c = 0; c < gates; ++c) {
      const Edge_lanes& g = in_gates[c];
      const Edge_lanes weight = .5f * (g + (g.square() + 1.f).sqrt()) * x.mask;
      const float sum = weight.sum(), factor = 1.f / (sum + few);
      float* const to = &means.odd[hidden + c * values];
      for (int f = 0; f < Input::edge_odd; ++f)
        to[f] = (weight * x.odd[f]).sum() * factor;
      to[Input::edge_odd] = (weight * both).sum() * factor;
      means.even[hidden + Input::point_even + c] = std::log(sum / float(x.size) + few);
    }
    means.odd.template tail<Input::point_odd>() = x.of_point_odd;
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_FITTING_LEARNED_NETWORK_H
