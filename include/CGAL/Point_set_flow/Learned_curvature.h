// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_LEARNED_CURVATURE_H
#define CGAL_POINT_SET_FLOW_LEARNED_CURVATURE_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/Tangent_plane_curvature.h>
#include <CGAL/Point_set_flow/internal/fitting/Correction_input.h>
#include <CGAL/Point_set_flow/internal/fitting/Learned_network.h>
#include <CGAL/Point_set_flow/internal/fitting/Same_side.h>
#include <CGAL/Point_set_flow/internal/fitting/Sheet_gate.h>
#include <CGAL/Point_set_flow/internal/fitting/Sheet_input.h>
#include <CGAL/Point_set_flow/internal/fitting/learned_weights.h>

#include <algorithm>

namespace CGAL {
namespace Point_set_flow {

/// \ingroup PkgPointSetFlowCurvature
/// `Tangent_plane_curvature` with two additions that are learned from examples: noisy points on meshes and on
/// generated surfaces.
///
/// - Before the first step it finds out where the neighbors of a point are those of two sheets, as on the
///   sides of a thin wall, and on which one the point is. Neighbors on the other sheet have no weight from then on.
/// - After the last step it corrects the result. From the residuals, what the flow took off the points around,
///   it tells what was detail, and from the tangent planes what noise is left.
///
/// Both are small networks of a few thousand weights, which are part of the package. Their inputs follow
/// translation, rotation and scaling, and the movement that they return is exactly odd in the normal, whose
/// orientation thus does not matter. No point is corrected by more than twice the rms residual around it, or four
/// times the noise.
///
/// \cgalModels{PointSetCurvature}
class Learned_curvature : public Tangent_plane_curvature {
public:
  /// rounds of `find_sheets()`
  static constexpr unsigned int number_of_sheet_rounds = internal::number_of_sheet_rounds;
  /// rounds of `correction()`
  static constexpr unsigned int number_of_corrections = internal::number_of_correction_rounds;

  /// Whether the neighbors are those of two sheets.
  /// \param neighborhood, round the first round is 0
  /// \pre `neighborhood.has_sheets()`
  Sheet_evidence find_sheets(const Neighborhood_3& neighborhood, unsigned int round) const
  {
    typedef internal::Sheet_input Input;
    Sheet_evidence found = neighborhood.sheets();
    const float least = -4.f, hardly = -3.f; // the outputs are between -4 and 4
    if (round > 0 && found.two_sheets < hardly)
      return found;
    if (round == 0 && (!(neighborhood.deviation() > 0.) ||
                       internal::Sheet_gate(neighborhood)(internal::sheet_gate_weights) < 0.)) {
      found.two_sheets = least;
      return found;
    }
    const internal::Learned_network<Input> network(internal::sheet_weights[round]);
    const auto output = network(Input(neighborhood));
    found.two_sheets = Input::squashed(output.even);
    found.side = Input::squashed(output.odd);
    return found;
  }

  /// How far a point should move along its normal, a length.
  /// \param neighborhood, round the first round is 0
  /// \pre `neighborhood.has_residuals()`
  double correction(const Neighborhood_3& neighborhood, unsigned int round) const
  {
    if (!neighborhood.is_sided())
      return correction_of_sheet(neighborhood, round);
    const internal::Same_side same(neighborhood);
    return same.neighborhood().size() >= 2 ? correction_of_sheet(same.neighborhood(), round) : 0.;
  }

private:
  static double correction_of_sheet(const Neighborhood_3& neighborhood, unsigned int round)
  {
    typedef internal::Correction_input Input;
    const internal::Learned_network<Input> network(internal::correction_weights[round]);
    const Input input(neighborhood);
    const double most = (std::min)(2. * input.unit, 4. * neighborhood.noise());
    return (std::min)((std::max)(double(network(input).odd) * input.unit, -most), most);
  }
};

} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_LEARNED_CURVATURE_H
