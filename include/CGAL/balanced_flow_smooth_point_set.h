// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BALANCED_FLOW_SMOOTH_POINT_SET_H
#define CGAL_BALANCED_FLOW_SMOOTH_POINT_SET_H

#include <CGAL/Point_set_flow/internal/smooth_point_set.h>

#include <optional>
#include <type_traits>

namespace CGAL {

/**
   \ingroup PkgPointSetFlowFunctions

   smooths a point set by the *dynamic balanced flow* of Xiao, Miao, Liu and Peng
   \cgalCite{xmlp-dbffpsg}. It is given by equation (9), table 1 and section 3.2 of the paper.

   In each iteration every point moves along its normal with the speed of its directional
   curvature, slowed down where the surface has features that the noise does not explain, and is
   drawn back there to the reference surface. The reference is the input, and every
   `update_period` iterations what the points have become.

   The directional curvature and the normals are those of `Point_set_flow::Tangent_plane_curvature`,
   which keeps sharp features and does not shrink curved surfaces. How strong the noise is, what
   neighborhoods suit it, and where the surface is thin, is found in the data. The estimator of the
   paper itself is `Point_set_flow::Covariance_curvature`, for the parameter `curvature`; the other
   flows of the paper can be chosen with the parameter `flow`.

   The function can replace `CGAL::jet_smooth_point_set()` and
   `CGAL::bilateral_smooth_point_set()`. Normals are not needed.

   The result
   - does not depend on the order of the points, and is the same to the last bit with
     `Sequential_tag` and `Parallel_tag`;
   - follows the data when these are moved, turned or scaled;
   - is written when all is computed: after an exception, or when the callback has cancelled the
     run, all points and normals are what they were.

   Exact duplicates move as one point. With the flows of this package, points that start at the
   reference do not move if they lie with all their neighbors in a plane, in particular if there are
   three points or fewer, or if they have no neighbors within `neighbor_radius`. Points without
   noise, or with less than a tenth of their spacing, hardly move. Neighbors are found once, in the
   reference.

   \tparam ConcurrencyTag enables sequential versus parallel algorithm. Possible values are
   `Sequential_tag`, `Parallel_tag`, and `Parallel_if_available_tag`. `Parallel_tag` needs the
   executable to be linked against TBB.
   \tparam PointRange is a model of `Range` with forward iterators. The value type of its iterator
   is the key type of the named parameter `point_map`.

   \param points input point range; may be empty
   \param k number of neighbors of each point; the more, the smoother the result. Where there are
   not as many points, all are neighbors. Without it (see the other overload) the number suits the
   noise, which is usually better.
   \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones
   listed below. Those of this package, from `flow` on, must come first.

   \pre `k >= 2`

   \cgalNamedParamsBegin
     \cgalParamNBegin{point_map}
       \cgalParamDescription{a property map associating points to the elements of the point set `points`}
       \cgalParamType{a model of `ReadWritePropertyMap` whose key type is the value type of the
                      iterator of `PointRange` and whose value type is `geom_traits::Point_3`}
       \cgalParamDefault{`CGAL::Identity_property_map<geom_traits::Point_3>`}
     \cgalParamNEnd

     \cgalParamNBegin{normal_map}
       \cgalParamDescription{a property map associating normals to the elements of the point set `points`.
                             The unit normals of the smoothed points are written there, on the side
                             of the given ones where these are not zero, else on any side. Points with less than
                             two neighbors keep the direction of the given ones.}
       \cgalParamType{a model of `ReadWritePropertyMap` whose key type is the value type of the
                      iterator of `PointRange` and whose value type is `geom_traits::Vector_3`}
       \cgalParamDefault{Normals are not written. A `Point_set_3` uses its own, if it has any.}
     \cgalParamNEnd

     \cgalParamNBegin{neighbor_radius}
       \cgalParamDescription{the spherical neighborhood radius, in the unit of the data}
       \cgalParamType{floating scalar value, not negative}
       \cgalParamDefault{`0` (no limit)}
       \cgalParamExtra{If provided, the neighbors of a point are the *nearest* `k` of those within
                       this distance, and there may be fewer.}
     \cgalParamNEnd

     \cgalParamNBegin{number_of_iterations}
       \cgalParamDescription{the number of steps of the flow; after `0` the points are where they start}
       \cgalParamType{unsigned int}
       \cgalParamDefault{At most what suits the estimator: `5`, and `12` for `Covariance_curvature`. Points around
                         which there is no noise do not move, and the flow stops when nothing moves.}
     \cgalParamNEnd

     \cgalParamNBegin{sharpness_angle}
       \cgalParamDescription{the angle in degrees between the normals of two planes from which on their
                             crease is a feature. From it and the median of the measured surface
                             variation, which stands for the noise, \f$K\f$ is chosen. With the default
                             estimator, which keeps creases by its weights, it only decides where
                             the forcing term holds on to detail.}
       \cgalParamType{floating scalar value}
       \cgalParamDefault{`60`, and `30` for `Covariance_curvature`}
       \cgalParamExtra{The larger the value is, the smoother the result will be. The range of
                       possible values is `(0, 180]`. Not used if `feature_threshold` is given.}
     \cgalParamNEnd

     \cgalParamNBegin{point_is_constrained_map}
       \cgalParamDescription{a property map telling which points must not move. They take part as neighbors.}
       \cgalParamType{a model of `ReadablePropertyMap` whose key type is the value type of the
                      iterator of `PointRange` and whose value type is convertible to `bool`}
       \cgalParamDefault{All points may move.}
     \cgalParamNEnd

     \cgalParamNBegin{callback}
       \cgalParamDescription{a mechanism to get feedback on the advancement of the algorithm
                             while it's running and to interrupt it if needed}
       \cgalParamType{an instance of `std::function<bool(double)>`.}
       \cgalParamDefault{unused}
       \cgalParamExtra{It is called regularly when the algorithm is running: the current advancement
                       (between 0. and 1.) is passed as parameter. If it returns `true`, then the
                       algorithm continues its execution normally; if it returns `false`, the
                       algorithm is stopped, all points and normals are left unchanged and the
                       function returns `NaN`.}
       \cgalParamExtra{The callback will be copied and therefore needs to be lightweight. It is
                       always called from the thread that called the function, and may throw.}
     \cgalParamNEnd

     \cgalParamNBegin{geom_traits}
       \cgalParamDescription{an instance of a geometric traits class}
       \cgalParamType{a model of `Kernel`}
       \cgalParamDefault{a \cgal Kernel deduced from the point type, using `CGAL::Kernel_traits`}
     \cgalParamNEnd

     \cgalParamNBegin{flow}
       \cgalParamDescription{the flow, one step of which each iteration makes}
       \cgalParamType{a model of `PointSetFlow`}
       \cgalParamDefault{`Point_set_flow::Balanced_flow`}
     \cgalParamNEnd

     \cgalParamNBegin{curvature}
       \cgalParamDescription{the estimator of normals and curvature}
       \cgalParamType{a model of `PointSetCurvature`}
       \cgalParamDefault{`Point_set_flow::Tangent_plane_curvature`}
     \cgalParamNEnd

     \cgalParamNBegin{feature_threshold}
       \cgalParamDescription{the constant \f$K\f$ of the diffusivity \f$g(x) = 1 / (1 + K x^2)\f$, without unit.
                             Features are where the surface variation is larger than \f$1/\sqrt K\f$;
                             `0` makes the flow isotropic.}
       \cgalParamType{floating scalar value, not negative}
       \cgalParamDefault{chosen from `sharpness_angle`}
     \cgalParamNEnd

     \cgalParamNBegin{filter_width}
       \cgalParamDescription{the width \f$\sigma\f$ of the Gaussians of the prefilter and of equation (3), in multiples
                             of the neighborhood radius, which is the distance of the farthest neighbor}
       \cgalParamType{floating scalar value, not negative}
       \cgalParamDefault{`0.6`, and `0.3` for `Covariance_curvature`; wider if `k` is smaller than suits the noise}
     \cgalParamNEnd

     \cgalParamNBegin{step_length}
       \cgalParamDescription{the step \f$s\f$ of Table 1, without unit: of 1, a point moves by its whole
                             directional curvature}
       \cgalParamType{floating scalar value, not negative}
       \cgalParamDefault{`0.75`}
       \cgalParamExtra{Flows with a forcing term need a step below 2 to be stable.}
     \cgalParamNEnd

     \cgalParamNBegin{update_period}
       \cgalParamDescription{the number \f$L\f$ of iterations after which the reference is replaced by what the
                             points have become, section 3.2 of the paper; `0` for never}
       \cgalParamType{unsigned int}
       \cgalParamDefault{`4`}
     \cgalParamNEnd

     \cgalParamNBegin{initial_point_map}
       \cgalParamDescription{a property map with the points from which the flow starts, \f$\chi\f$ of equation (7b).
                             The points of `point_map` are then only the reference \f$I\f$; the result is
                             written to `point_map`. Constrained points start, and stay, there.}
       \cgalParamType{a model of `ReadablePropertyMap` whose key type is the value type of the
                      iterator of `PointRange` and whose value type is `geom_traits::Point_3`}
       \cgalParamDefault{The flow starts at the reference.}
     \cgalParamNEnd

     \cgalParamNBegin{feature_strength_map}
       \cgalParamDescription{a property map that receives how much of a feature each point is: \f$1 - g\f$ of the
                             surface variation of the result, 0 on flat parts and 1/2 at a crease of
                             `sharpness_angle`}
       \cgalParamType{a model of `ReadWritePropertyMap` whose key type is the value type of the
                      iterator of `PointRange` and whose value type is a floating point number}
       \cgalParamDefault{not computed}
     \cgalParamNEnd

     \cgalParamNBegin{block_size}
       \cgalParamDescription{the number of points that are smoothed at a time. A larger point set is cut into
                             blocks along a space-filling curve; each is smoothed with a halo of the points
                             that have a say in the result, which is the same, to the last bit, as in one piece.}
       \cgalParamType{unsigned int, positive}
       \cgalParamDefault{`4194304`}
       \cgalParamExtra{Bounds the memory for the neighbors and all else that is kept for a point in the
                       flow. The halo costs time: a tenth for blocks of the default size, a third for
                       250,000 points.}
     \cgalParamNEnd
   \cgalNamedParamsEnd

   \return the mean distance that the distinct points moved in the last iteration, in the unit of
   the data: a criterion of convergence. `0` for an empty range, `NaN` when cancelled.

   \throws std::invalid_argument if a coordinate is not finite or a parameter is out of its range;
   the message names the argument, its index and its value
   \throws std::overflow_error if a point would become not finite, with steps that are too long
   \throws std::length_error if there are more than \f$2^{32}-1\f$ points

   Complexity: \f$O(n \log n + n k)\f$ time for the neighbors and \f$O(nk)\f$ for each iteration;
   \f$O(nk)\f$ memory, 4 bytes for each neighbor.

   \sa `CGAL::jet_smooth_point_set()`
   \sa `CGAL::bilateral_smooth_point_set()`
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

   smooths a point set as above, with numbers of neighbors that are chosen from the data: from the
   spacing and from the noise around each point, and fewer where two sheets of the surface are close
   to each other.
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
