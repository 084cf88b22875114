// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_ANY_FLOW_H
#define CGAL_POINT_SET_FLOW_ANY_FLOW_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/flows.h>
#include <CGAL/Point_set_flow/internal/flow/model_traits.h>

#include <functional>
#include <type_traits>

namespace CGAL {
namespace Point_set_flow {

/// \ingroup PkgPointSetFlowFlows
/// Any flow, chosen at run time. It keeps what the model says of itself, `Uses_prefilter`,
/// `Stays_in_neighborhood` and `Is_correctable`, so that the result is that of the model. A `std::function` would not.
///
/// \cgalModels{PointSetFlow}
class Any_flow {
  std::function<Vector_3(const Flow_point_3&, const Diffusivity&)> m_flow;
  bool m_uses_prefilter, m_stays_in_neighborhood, m_is_correctable;

public:
  /// constructs a flow that behaves as `flow`, which is copied
  /// \tparam Flow a model of `PointSetFlow`
  template <typename Flow
#ifndef DOXYGEN_RUNNING
            ,
            std::enable_if_t<!std::is_same<Flow, Any_flow>::value, int> = 0
#endif
            >
  Any_flow(const Flow& flow)
      : m_flow(flow), m_uses_prefilter(internal::uses_prefilter(flow)),
        m_stays_in_neighborhood(internal::stays_in_neighborhood(flow)),
        m_is_correctable(internal::is_correctable(flow))
  {}

  /// whether the model needs the prefilter
  bool uses_prefilter() const { return m_uses_prefilter; }
  /// whether the model keeps points in their neighborhoods
  bool stays_in_neighborhood() const { return m_stays_in_neighborhood; }

  /// whether an estimator may correct the result of the model
  bool is_correctable() const { return m_is_correctable; }

  /// the right hand side of the model
  Vector_3 operator()(const Flow_point_3& u, const Diffusivity& g) const { return m_flow(u, g); }
};

} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_ANY_FLOW_H
