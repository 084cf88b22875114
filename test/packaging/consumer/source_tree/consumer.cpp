// SPDX-License-Identifier: GPL-3.0-or-later
// Little to compile: the other consumers run the function.
#include <CGAL/Point_set_flow/flows.h>

#ifndef CGAL_EIGEN3_ENABLED
#error "the target PointSetFlow::point_set_flow does not pass on CGAL's"
#endif

int main() { return sizeof(CGAL::Point_set_flow::Balanced_flow) > 0 ? 0 : 1; }
