// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_FLOW_BLOCK_RUNS_H
#define CGAL_POINT_SET_FLOW_INTERNAL_FLOW_BLOCK_RUNS_H

#include <CGAL/Point_set_flow/internal/flow/Flow_run.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// What became of the sites of a buffer.
struct Flow_result {
  Array<Point_3> points;
  Array<Vector_3> normals; ///< empty if they are not wanted; null vectors where there is no plane
  Array<double> feature_strength; ///< empty if it is not wanted
  Array<double> radii;            ///< of the neighborhoods; empty if they are not wanted
  double moved = 0.;              ///< the mean distance in the last step

  template <typename T>
  static void append(Array<T>& to, Array<T>&& of_piece, const Piece& piece)
  {
    if (piece.core.empty())
      to = std::move(of_piece);
    else
      for (const std::uint32_t i : piece.core)
        to.push_back(of_piece[i]);
  }
};

struct Wanted_outputs {
  bool normals, feature_strength, radii;
};

/// The flow on a point set: in one piece, or block by block if there are more points than `block`.
/// \param buffer is emptied if it makes one piece
template <typename ConcurrencyTag, typename Flow, typename Curvature>
Flow_result run_pieces(ConcurrencyTag tag, Point_buffer& buffer, const Flow& flow,
                       const Curvature& curvature, const Options& options, double unit,
                       const Wanted_outputs& wanted, Progress& progress)
{
  const std::size_t n = buffer.size();
  std::optional<Neighbor_tree> tree(std::in_place, tag, buffer.reference, progress);
  progress.advance(work::tree);
  const Flow_plan<Flow, Curvature> plan(tag, buffer, *tree, curvature, options, unit, progress);
  Flow_result result;
  std::vector<double> moved; // sums over the same points, however these are cut

  const auto run_piece = [&](Piece piece) {
    const double share = double(piece.core_size()) / double(n);
    Flow_run<ConcurrencyTag, Flow, Curvature> run(plan, piece, flow, curvature, unit, progress,
                                                  share);
    run();
    for (std::size_t i = 0; i < piece.core_size(); ++i) {
      if (i % block_size == 0)
        moved.push_back(0.);
      moved.back() += run.moved(piece.core_place(i));
    }
    if (wanted.normals)
      Flow_result::append(result.normals, run.find_normals(), piece);
    if (wanted.feature_strength)
      Flow_result::append(result.feature_strength, run.find_feature_strength(), piece);
    if (wanted.radii)
      Flow_result::append(result.radii, piece.graph.take_radii(), piece);
    Flow_result::append(result.points, std::move(piece.points), piece);
  };

  if (n <= options.block_size) {
    Piece all = take_all(tag, buffer, *tree, plan.search, progress, work::graph);
    tree.reset();
    run_piece(std::move(all));
  }
  else {
    Piece_cutter cut(buffer, *tree, plan.search);
    const std::size_t step = (options.block_size + block_size - 1) / block_size * block_size;
    for (std::size_t begin = 0; begin < n; begin += step) {
      std::vector<std::uint32_t> core((std::min)(step, n - begin));
      std::iota(core.begin(), core.end(), static_cast<std::uint32_t>(begin));
      run_piece(cut(tag, core, plan.number_of_rings(), progress,
                    work::graph * double(core.size()) / double(n)));
    }
  }
  result.moved = std::accumulate(moved.begin(), moved.end(), 0.) / double(n);
  return result;
}

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_FLOW_BLOCK_RUNS_H
