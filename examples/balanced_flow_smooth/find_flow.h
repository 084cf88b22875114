// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_SMOOTH_FIND_FLOW_H
#define BALANCED_FLOW_SMOOTH_FIND_FLOW_H

#include <CGAL/Point_set_flow/Any_flow.h>

#include <stdexcept>
#include <string>

namespace balanced_flow_smooth {

/// The flow of a name, as one type. Throws `std::invalid_argument` if there is none.
inline CGAL::Point_set_flow::Any_flow find_flow(const std::string& name)
{
  namespace flows = CGAL::Point_set_flow;
  if (name == "balanced")
    return flows::Balanced_flow();
  if (name == "volume-preserving")
    return flows::Volume_preserving_flow();
  if (name == "well-posed")
    return flows::Well_posed_anisotropic_flow();
  if (name == "anisotropic")
    return flows::Anisotropic_flow();
  if (name == "curvature")
    return flows::Curvature_flow();
  throw std::invalid_argument("flow is '" + name +
                              "', but must be 'balanced', 'volume-preserving', 'well-posed', "
                              "'anisotropic' or 'curvature'");
}

} // namespace balanced_flow_smooth

#endif // BALANCED_FLOW_SMOOTH_FIND_FLOW_H
