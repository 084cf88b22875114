// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SCALE_SPACE_RECONSTRUCTION_3_BALANCED_FLOW_SMOOTHER_H
#define CGAL_SCALE_SPACE_RECONSTRUCTION_3_BALANCED_FLOW_SMOOTHER_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Iterator_range.h>
#include <CGAL/balanced_flow_smooth_point_set.h>
#include <CGAL/tags.h>

#include <optional>

namespace CGAL {
namespace Scale_space_reconstruction_3 {

/**
   \ingroup PkgPointSetFlowFunctions

   %Smoother for scale space reconstruction based on `CGAL::balanced_flow_smooth_point_set()`.

   The noise is estimated anew in each iteration of
   `CGAL::Scale_space_surface_reconstruction_3::increase_scale()`. The first iteration leaves little
   of it, so the points hardly move in the following ones, while `Jet_smoother` continues to flatten
   the shape: one or two iterations suffice.

   \cgalModels{CGAL::Scale_space_reconstruction_3::Smoother}

   \tparam Geom_traits geometric traits class. It must be a model of
   `DelaunayTriangulationTraits_3`. It must have a `RealEmbeddable` field number type. Generally,
   `Exact_predicates_inexact_constructions_kernel` is preferred.
   \tparam ConcurrencyTag indicates whether to use concurrent processing. It can be omitted: if TBB
   is available and `CGAL_LINKED_WITH_TBB` is defined then `Parallel_tag` is used. Otherwise,
   `Sequential_tag` is used. The result is bitwise identical.

   \sa `CGAL::balanced_flow_smooth_point_set()`
*/
template <typename Geom_traits,
#ifdef DOXYGEN_RUNNING
          typename ConcurrencyTag>
#else
          typename ConcurrencyTag = CGAL::Parallel_if_available_tag>
#endif
class Balanced_flow_smoother {
public:
  typedef typename Geom_traits::FT FT;         ///< defines the field number type.
  typedef typename Geom_traits::Point_3 Point; ///< defines the point type.

private:
  std::optional<unsigned int> m_k;

public:
  /// Constructs a smoother that chooses the number of neighbors of each point from the data.
  Balanced_flow_smoother() {}

  /**
     Constructs a smoother.

     \param k number of neighbors used, at least 2; otherwise smoothing throws
     `std::invalid_argument`
  */
  Balanced_flow_smoother(unsigned int k) : m_k(k) {}

  /// \cond SKIP_IN_MANUAL
  template <typename ForwardIterator>
  void operator()(ForwardIterator begin, ForwardIterator end) const
  {
    Iterator_range<ForwardIterator> points(begin, end);
    if (m_k)
      balanced_flow_smooth_point_set<ConcurrencyTag>(points, *m_k);
    else
      balanced_flow_smooth_point_set<ConcurrencyTag>(points);
  }
  /// \endcond
};

} // namespace Scale_space_reconstruction_3
} // namespace CGAL

#endif // CGAL_SCALE_SPACE_RECONSTRUCTION_3_BALANCED_FLOW_SMOOTHER_H
