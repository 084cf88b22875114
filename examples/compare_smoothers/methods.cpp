// SPDX-License-Identifier: GPL-3.0-or-later
#include "methods.h"

#include <CGAL/Point_set_flow/flows.h>

namespace comparison {

std::vector<Named_method> all_methods()
{
  using namespace CGAL::Point_set_flow;
  // clang-format off
  return {
    {"none", "none", [](const Points& p) { return Smoothed{p, {}}; }},
    {"jet", "jet, k=24", [](const Points& p) { return jet(p, 24); }},
    {"bilateral", "bilateral, k=24, 3 times", [](const Points& p) { return bilateral(p, 24, 3); }},
    {"wlop", "WLOP", [](const Points& p) { return wlop(p); }},
    {"curvature", "curvature flow (4)", [](const Points& p) { return paper_flow(p, Curvature_flow()); }},
    {"anisotropic", "anisotropic flow (5)", [](const Points& p) { return paper_flow(p, Anisotropic_flow()); }},
    {"well-posed", "well-posed flow (6)", [](const Points& p) { return paper_flow(p, Well_posed_anisotropic_flow()); }},
    {"volume-preserving", "volume-preserving flow (7)", [](const Points& p) { return paper_flow(p, Volume_preserving_flow()); }},
    {"balanced", "balanced flow (9)", [](const Points& p) { return paper_flow(p, Balanced_flow()); }},
    {"ours", "this package, defaults", [](const Points& p) { return point_set_flow(p); }}};
  // clang-format on
}

} // namespace comparison
