// SPDX-License-Identifier: GPL-3.0-or-later
// The list of this package's named parameters, to be included several times: no include guard.
CGAL_BALANCED_FLOW_NAMED_PARAMETER(flow)
CGAL_BALANCED_FLOW_NAMED_PARAMETER(curvature)
CGAL_BALANCED_FLOW_NAMED_PARAMETER(feature_threshold)
CGAL_BALANCED_FLOW_NAMED_PARAMETER(filter_width)
CGAL_BALANCED_FLOW_NAMED_PARAMETER(step_length)
CGAL_BALANCED_FLOW_NAMED_PARAMETER(update_period)
CGAL_BALANCED_FLOW_NAMED_PARAMETER(initial_point_map)
