// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_FLOWS_H
#define CGAL_POINT_SET_FLOW_FLOWS_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/Core_kernel.h>
#include <CGAL/Point_set_flow/Diffusivity.h>
#include <CGAL/tags.h>

namespace CGAL {
namespace Point_set_flow {

/// \ingroup PkgPointSetFlowFlows
/// What a flow sees of one point \f$u\f$ at one time. Lengths are in the unit of the data.
struct Flow_point_3 {
  /// \f$n\f$, the unit normal; its orientation is arbitrary, \f$\bar\kappa n\f$ is the same for both
  Vector_3 normal;
  /// \f$\bar\kappa\f$, equations (3) and (4), a length: how far the surface is from being balanced at
  /// the point, positive if the point lies on the side of the normal
  double directional_curvature;
  /// \f$|\bar\kappa|\f$ without unit: the surface variation, equation (2), of the current surface; with an
  /// estimator that uses the surface estimate, as the default does, what the noise does not explain
  double variation;
  /// \f$|\kappa_H(G_\sigma \times u)|\f$: the surface variation of the prefiltered surface; with an
  /// estimator that uses the surface estimate there is no prefilter, and this is equal to `variation`
  double filtered_variation;
  /// \f$I - u\f$, the vector from the point back to its reference point
  Vector_3 forcing;
};

/// \addtogroup PkgPointSetFlowFlows
///
/// `Uses_prefilter` says whether a flow needs `Flow_point_3::filtered_variation`; without it,
/// or with an estimator that uses the surface estimate, the prefilter is not run. `Stays_in_neighborhood` says whether the flow, with an estimator that says so,
/// too, keeps points from moving farther than their farthest neighbors.
/// @{

/// Equation (4), isotropic: \f$-\bar\kappa n\f$.
/// \cgalModels{PointSetFlow}
struct Curvature_flow {
  /// `filtered_variation` is not used
  typedef Tag_false Uses_prefilter;
  /// the right hand side
  Vector_3 operator()(const Flow_point_3& u, const Diffusivity&) const
  {
    return -u.directional_curvature * u.normal;
  }
};

/// Equation (5), anisotropic, the diffusivity taken from the noisy surface itself:
/// \f$-g(|\bar\kappa|)\,\bar\kappa n\f$.
/// \cgalModels{PointSetFlow}
struct Anisotropic_flow {
  /// `filtered_variation` is not used
  typedef Tag_false Uses_prefilter;
  /// the right hand side
  Vector_3 operator()(const Flow_point_3& u, const Diffusivity& g) const
  {
    return -(g(u.variation) * u.directional_curvature) * u.normal;
  }
};

/// Equation (6), the diffusivity taken from the prefiltered surface:
/// \f$-g(|\kappa_H(G_\sigma \times u)|)\,\bar\kappa n\f$.
/// \cgalModels{PointSetFlow}
struct Well_posed_anisotropic_flow {
  /// `filtered_variation` is used
  typedef Tag_true Uses_prefilter;
  /// the right hand side
  Vector_3 operator()(const Flow_point_3& u, const Diffusivity& g) const
  {
    return -(g(u.filtered_variation) * u.directional_curvature) * u.normal;
  }
};

/// Equation (7a), with the forcing term: \f$-g\,\bar\kappa n + (I - u)\f$. The start of equation
/// (7b) is given by the named parameter `initial_point_map`.
/// \cgalModels{PointSetFlow}
struct Volume_preserving_flow {
  /// `filtered_variation` is used
  typedef Tag_true Uses_prefilter;
  /// the right hand side
  Vector_3 operator()(const Flow_point_3& u, const Diffusivity& g) const
  {
    return -(g(u.filtered_variation) * u.directional_curvature) * u.normal + u.forcing;
  }
};

/// Equation (9) and Table 1, the forcing term moderated: \f$-g\,\bar\kappa n + (1-g)(I - u)\f$.
/// \cgalModels{PointSetFlow}
struct Balanced_flow {
  /// `filtered_variation` is used
  typedef Tag_true Uses_prefilter;
  /// an estimator may correct the result
  typedef Tag_true Is_correctable;
  /// points move no farther than their farthest neighbors
  typedef Tag_true Stays_in_neighborhood;
  /// the right hand side
  Vector_3 operator()(const Flow_point_3& u, const Diffusivity& diffusivity) const
  {
    const double g = diffusivity(u.filtered_variation);
    return -(g * u.directional_curvature) * u.normal + (1. - g) * u.forcing;
  }
};

/// @}

} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_FLOWS_H
