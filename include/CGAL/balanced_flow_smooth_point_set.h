// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BALANCED_FLOW_SMOOTH_POINT_SET_H
#define CGAL_BALANCED_FLOW_SMOOTH_POINT_SET_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/internal/smooth_point_set.h>

#include <optional>
#include <type_traits>

namespace CGAL {

/**
   \ingroup PkgPointSetFlowFunctions

   denoises a point set by the *dynamic balanced flow* of Xiao, Miao, Liu and Peng
   \cgalCite{xmlp-dbffpsg}, given by equation (9), table 1 and section 3.2 of the paper.

   In each iteration every point moves along its normal with the speed of its directional curvature,
   slowed down at features that the noise does not explain, and is drawn back there to the
   reference: the input, replaced by the points every `update_period` steps.

   The directional curvature and the normals are those of `Point_set_flow::Learned_curvature`, which
   preserves sharp features and thin walls and does not shrink curved surfaces. The noise (unless given), the
   spacing, the neighborhood sizes and \f$K\f$ that suit them, and where the surface is thin are
   found around each point. The function can replace `CGAL::jet_smooth_point_set()` and
   `CGAL::bilateral_smooth_point_set()`; normals are not needed.

   The result
   - does not depend on the order of the points, and is bitwise identical with all concurrency tags;
   - depends at each point on the points around it only, not on statistics of the whole point set;
   - is equivariant under translation, rotation and scaling of the data;
   - is written only after everything has been computed: after an exception, or when the callback
     has canceled the run, all points and normals are unchanged.

   Exact duplicates move as one point. With the flows of this package, points that start at the
   reference do not move if they lie in a plane with all their neighbors, unless they are relaxed.
   Points far from all others do not move either: those whose neighborhood radius is more than four
   times that of each of their neighbors. Neighbors are found once, in the reference. All
   computations are done in `double`.

   \tparam ConcurrencyTag enables sequential versus parallel algorithm. Possible values are
   `Sequential_tag`, `Parallel_tag`, and `Parallel_if_available_tag`. `Parallel_tag` needs the
   executable to be linked against TBB.
   \tparam PointRange is a model of `Range` with forward iterators. The value type of its iterator
   is the key type of the named parameter `point_map`.

   \param points input point range; may be empty
   \param k number of neighbors of each point, at least 2; the more, the smoother the result. If
   fewer points exist, all others are used. If omitted, it suits the noise.
   \param np an optional sequence of \ref bgl_namedparameters "Named Parameters"; (*) marks those of
   this package

   <b>Everyday parameters</b>
   \cgalNamedParamsBegin
     \cgalParamNBegin{point_map}
       \cgalParamDescription{a property map associating points to the elements of `points`}
       \cgalParamType{a model of `ReadWritePropertyMap` whose key type is the value type of the
         iterator of `PointRange` and whose value type is `geom_traits::Point_3`}
       \cgalParamDefault{`CGAL::Identity_property_map<geom_traits::Point_3>`}
     \cgalParamNEnd
     \cgalParamNBegin{normal_map}
       \cgalParamDescription{a property map associating normals to the elements of `points`. The
         given normals tell on which side of the surface a point was measured: layers on the same
         side are one surface scanned twice and come together, those on opposite sides are a thin
         wall and stay apart. The map receives the unit normals of the smoothed points, oriented as
         the given ones; with fewer than two neighbors it keeps these.}
       \cgalParamType{a model of `ReadWritePropertyMap` whose key type is the value type of the
         iterator of `PointRange` and whose value type is `geom_traits::Vector_3`}
       \cgalParamDefault{Normals are neither used nor written; a `Point_set_3` uses its own.}
       \cgalParamExtra{Given normals need not be accurate, and their orientation is trusted only
         where it is consistent: random orientations are recognized. Null vectors say nothing.}
     \cgalParamNEnd
     \cgalParamNBegin{scan_map}
       \cgalParamDescription{(*) a property map with the number of the scan of each point. Where no
         normals tell the sides, layers of different scans are registration error and come
         together.}
       \cgalParamType{a model of `ReadablePropertyMap` whose key type is the value type of the
         iterator of `PointRange` and whose value type is an integer, converted to 32 bits}
       \cgalParamDefault{The points are taken for those of one scan.}
     \cgalParamNEnd
     \cgalParamNBegin{noise}
       \cgalParamDescription{(*) the standard deviation of the noise along the normals}
       \cgalParamType{floating scalar value, or a model of `ReadablePropertyMap` with the value type
         of the iterator of `PointRange` as key type and values convertible to `double`}
       \cgalParamDefault{estimated around each point}
       \cgalParamExtra{Not negative, in the unit of the data; duplicates get their mean. By default,
         points do not move where it is 0. `Covariance_curvature` uses it for `k` and \f$K\f$ only.}
     \cgalParamNEnd
     \cgalParamNBegin{neighbor_radius}
       \cgalParamDescription{the spherical neighborhood radius: only points within it are neighbors}
       \cgalParamType{floating scalar value, not negative}
       \cgalParamDefault{`0` (no limit)}
     \cgalParamNEnd
     \cgalParamNBegin{point_is_constrained_map}
       \cgalParamDescription{tells which points must not move; they still serve as neighbors}
       \cgalParamType{a model of `ReadablePropertyMap` whose key type is the value type of the
         iterator of `PointRange` and whose value type is convertible to `bool`}
       \cgalParamDefault{All points may move.}
     \cgalParamNEnd
     \cgalParamNBegin{callback}
       \cgalParamDescription{a mechanism to get feedback on the advancement of the algorithm and to
         interrupt it}
       \cgalParamType{an instance of `std::function<bool(double)>`.}
       \cgalParamDefault{unused}
       \cgalParamExtra{It is called regularly, with the current advancement (between 0. and 1.). If
         it returns `false`, the function leaves all points and normals unchanged and returns `NaN`.
         It is copied, always called from the thread that called the function, and may throw.}
     \cgalParamNEnd
     \cgalParamNBegin{geom_traits}
       \cgalParamDescription{an instance of a geometric traits class; only its types are used}
       \cgalParamType{a model of `Kernel`}
       \cgalParamDefault{a \cgal Kernel deduced from the point type, using `CGAL::Kernel_traits`}
     \cgalParamNEnd
     \cgalParamNBegin{number_of_relaxation_steps}
       \cgalParamDescription{the number of steps that then spread the points along the surface; 3 to
         5 do most of it. They move by up to a spacing, with their attributes, also without noise.}
       \cgalParamType{unsigned int}
       \cgalParamDefault{`0`: points move along their normals only}
     \cgalParamNEnd
     \cgalParamNBegin{feature_strength_map}
       \cgalParamDescription{(*) a property map that receives the feature strength: \f$1 - g\f$ of
         the variation of the result, 0 on flat parts, 1/2 at a crease of `sharpness_angle`}
       \cgalParamType{a model of `ReadWritePropertyMap` whose key type is the value type of the
         iterator of `PointRange` and whose value type is a floating point number}
       \cgalParamDefault{not computed}
     \cgalParamNEnd
     \cgalParamNBegin{smoothing_report}
       \cgalParamDescription{(*) receives what was found, used and done}
       \cgalParamType{`std::reference_wrapper<Point_set_flow::Smoothing_report>`, by `std::ref`}
       \cgalParamDefault{unused}
     \cgalParamNEnd
   \cgalNamedParamsEnd

   <b>Parameters of the paper</b>
   \cgalNamedParamsBegin
     \cgalParamNBegin{number_of_iterations}
       \cgalParamDescription{the number of steps of the flow; with `0` points stay at the start}
       \cgalParamType{unsigned int}
       \cgalParamDefault{`5`, and `12` for `Covariance_curvature`}
     \cgalParamNEnd
     \cgalParamNBegin{flow}
       \cgalParamDescription{(*) the flow, one step of which each iteration makes}
       \cgalParamType{a model of `PointSetFlow`}
       \cgalParamDefault{`Point_set_flow::Balanced_flow`}
     \cgalParamNEnd
     \cgalParamNBegin{curvature}
       \cgalParamDescription{(*) the estimator; the paper's is
         `Point_set_flow::Covariance_curvature`}
       \cgalParamType{a model of `PointSetCurvature`}
       \cgalParamDefault{`Point_set_flow::Learned_curvature`}
     \cgalParamNEnd
     \cgalParamNBegin{sharpness_angle}
       \cgalParamDescription{the angle in degrees between the normals of two planes from which on
         their crease is a feature. \f$K\f$ is chosen from it and, for estimators that do not use
         the noise, from the surface variation that the noise around the point causes on a plane.}
       \cgalParamType{floating scalar value in `(0, 180]`}
       \cgalParamDefault{`60`, and `30` for `Covariance_curvature`}
       \cgalParamExtra{The larger, the smoother the result. By default it decides only where the
         forcing term keeps detail. `CGAL::bilateral_smooth_point_set()` has `[0, 90]` and `30`.}
     \cgalParamNEnd
     \cgalParamNBegin{feature_threshold}
       \cgalParamDescription{(*) the constant \f$K\f$ of the diffusivity \f$g(x) = 1/(1 + K x^2)\f$:
         features vary by more than \f$1/\sqrt K\f$; `0` makes the flow isotropic}
       \cgalParamType{floating scalar value, not negative}
       \cgalParamDefault{chosen from `sharpness_angle`}
     \cgalParamNEnd
     \cgalParamNBegin{filter_width}
       \cgalParamDescription{(*) the width \f$\sigma\f$ of all Gaussians, in neighborhood radii}
       \cgalParamType{floating scalar value, not negative}
       \cgalParamDefault{`0.6`, wider where `k` is too small for the noise; `0.3` for
         `Covariance_curvature`}
     \cgalParamNEnd
     \cgalParamNBegin{step_length}
       \cgalParamDescription{(*) the step \f$s\f$ of Table 1: with 1, a point moves by its whole
         directional curvature}
       \cgalParamType{floating scalar value, not negative}
       \cgalParamDefault{`0.75`}
       \cgalParamExtra{Flows with a forcing term need a step below 2 to be stable.}
     \cgalParamNEnd
     \cgalParamNBegin{update_period}
       \cgalParamDescription{(*) the number \f$L\f$ of iterations after which the reference is
         replaced by the current points, section 3.2 of the paper; `0` for never}
       \cgalParamType{unsigned int}
       \cgalParamDefault{`4`}
     \cgalParamNEnd
     \cgalParamNBegin{initial_point_map}
       \cgalParamDescription{(*) a property map with the points from which the flow starts,
         \f$\chi\f$ of equation (7b). Those of `point_map`, which receives the result, are then only
         the reference \f$I\f$; constrained points stay there.}
       \cgalParamType{a model of `ReadablePropertyMap` whose key type is the value type of the
         iterator of `PointRange` and whose value type is `geom_traits::Point_3`}
       \cgalParamDefault{The flow starts at the reference.}
     \cgalParamNEnd
   \cgalNamedParamsEnd

   <b>Memory</b>
   \cgalNamedParamsBegin
     \cgalParamNBegin{block_size}
       \cgalParamDescription{(*) the number of points that are smoothed at a time. A larger point
         set is cut into blocks, each smoothed with its halo; the result is bitwise identical.}
       \cgalParamType{unsigned int, positive}
       \cgalParamDefault{`4194304`}
       \cgalParamExtra{Bounds the memory of the flow. Halos cost a tenth of the time.}
     \cgalParamNEnd
   \cgalNamedParamsEnd

   \return the mean distance that the distinct points moved in the last iteration, in the unit of
   the data: a criterion of convergence. `0` for an empty range, `NaN` when canceled.

   \throws std::invalid_argument if a coordinate is not finite or a parameter is out of its range;
   the message names the argument, its index and its value
   \throws std::overflow_error if a point would become not finite, with steps that are too long
   \throws std::length_error if there are more than \f$2^{32}-1\f$ points

   Complexity: \f$O(n \log n + n k)\f$ for analysis, which looks at 96 neighbors of one point
   in about 18, and for neighbors; \f$O(nk)\f$ for each iteration; 4 bytes for each neighbor.
*/
template <typename ConcurrencyTag, typename PointRange,
          typename NamedParameters = parameters::Default_named_parameters>
double balanced_flow_smooth_point_set(PointRange& points, unsigned int k,
                                      const NamedParameters& np = parameters::default_values())
{
  return Point_set_flow::internal::smooth_point_set<ConcurrencyTag>(points, k, np);
}

/**
   \ingroup PkgPointSetFlowFunctions

   denoises a point set as above, with numbers of neighbors that suit spacing and noise around each
   point: fewer where two sheets of the surface are close, more where the points lie in lines.
*/
template <
    typename ConcurrencyTag, typename PointRange,
    typename NamedParameters = parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
    ,
    std::enable_if_t<Point_set_flow::internal::Is_named_parameters<NamedParameters>::value, int> = 0
#endif
    >
double balanced_flow_smooth_point_set(PointRange& points,
                                      const NamedParameters& np = parameters::default_values())
{
  return Point_set_flow::internal::smooth_point_set<ConcurrencyTag>(points, std::nullopt, np);
}

} // namespace CGAL

#endif // CGAL_BALANCED_FLOW_SMOOTH_POINT_SET_H
