// SPDX-License-Identifier: GPL-3.0-or-later
// A block of a point set, with its halo: bitwise the same as in the whole, or refused.
#define BOOST_TEST_MODULE blocks
#include <boost/test/unit_test.hpp>

#include "pieces.h"
#include "random_clouds.h"
#include "shapes.h"

#include <CGAL/Point_set_flow/Covariance_curvature.h>
#include <CGAL/Point_set_flow/smooth_block.h>
#include <CGAL/balanced_flow_smooth_point_set.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace np = CGAL::parameters;
using namespace CGAL::Point_set_flow;
using namespace pieces;
typedef CGAL::Sequential_tag Sequential;

namespace {

/// Where the results go
struct Result {
  Points points;
  Normals normals;
  std::vector<double> strength;

  explicit Result(const Cloud& cloud)
      : points(cloud.points),
        normals(cloud.normals.empty() ? Normals(cloud.points.size(), CGAL::NULL_VECTOR)
                                      : cloud.normals),
        strength(cloud.points.size(), -1.)
  {}

  bool operator==(const Result& other) const
  {
    return points == other.points && normals == other.normals && strength == other.strength;
  }
};

/// Smooths with what the cloud has: calls `run(named parameters)`.
template <typename Run>
auto with_maps(const Cloud& cloud, Result& result, const Run& run)
{
  const auto with_scans = [&](const auto& own) {
    const auto all = own.feature_strength_map(CGAL::make_property_map(result.strength));
    const auto maps = [&](const auto& some) {
      return some.number_of_relaxation_steps(cloud.relaxation_steps)
          .point_map(CGAL::make_property_map(result.points))
          .normal_map(CGAL::make_property_map(result.normals));
    };
    if (cloud.constrained.empty())
      return run(maps(all));
    return run(maps(all).point_is_constrained_map(CGAL::make_property_map(cloud.constrained)));
  };
  const auto with_noise = [&](const auto& own) {
    if (cloud.scans.empty())
      return with_scans(own);
    return with_scans(own.scan_map(CGAL::make_property_map(cloud.scans)));
  };
  if (cloud.noise.empty())
    return with_noise(np::update_period(4));
  return with_noise(np::noise(CGAL::make_property_map(cloud.noise)));
}

Result in_one_piece(const Cloud& cloud)
{
  Result result(cloud);
  Indices all(cloud.points.size());
  std::iota(all.begin(), all.end(), std::size_t(0));
  with_maps(cloud, result, [&](const auto& parameters) {
    return CGAL::balanced_flow_smooth_point_set<Sequential>(all, parameters);
  });
  return result;
}

/// Smooths each piece with what it needs of the others.
/// \param largest_halo receives the largest number of points that were at hand
Result piece_by_piece(const Cloud& cloud, std::size_t size, std::size_t& largest_halo)
{
  Result result(cloud);
  Pieces pieces(cloud.points, size);
  const Coordinate_frame frame = find_coordinate_frame<Sequential>(cloud.points);
  largest_halo = 0;
  for (std::size_t block = 0; block < pieces.pieces.size(); ++block) {
    pieces.read_none();
    pieces.pieces[block].is_read = true;
    Block_status status = Block_status::HALO_TOO_SMALL;
    for (int trial = 0; status == Block_status::HALO_TOO_SMALL; ++trial) {
      BOOST_REQUIRE(trial < 100);
      Indices points = pieces.pieces[block].points;
      for (std::size_t other = 0; other < pieces.pieces.size(); ++other)
        if (other != block && pieces.pieces[other].is_read)
          points.insert(points.end(), pieces.pieces[other].points.begin(),
                        pieces.pieces[other].points.end());
      // what is not at hand must not be looked at: the maps have other values there
      Cloud excerpt = cloud;
      Result local(cloud);
      std::vector<char> is_there(cloud.points.size());
      for (const std::size_t i : points)
        is_there[i] = 1;
      for (std::size_t i = 0; i < is_there.size(); ++i)
        if (!is_there[i])
          local.points[i] = shapes::Point_3(std::nan(""), 0., 0.);
      status = with_maps(excerpt, local, [&](const auto& parameters) {
        return smooth_block<Sequential>(points, pieces.pieces[block].points.size(), frame, pieces,
                                        parameters);
      });
      largest_halo = (std::max)(largest_halo, points.size());
      for (std::size_t j = 0; j < points.size(); ++j) {
        const std::size_t i = points[j];
        if (status != Block_status::SMOOTHED || j >= pieces.pieces[block].points.size()) {
          BOOST_REQUIRE((local.points[i] == cloud.points[i])); // not written
          BOOST_REQUIRE(local.strength[i] == -1.);
          continue;
        }
        result.points[i] = local.points[i];
        result.normals[i] = local.normals[i];
        result.strength[i] = local.strength[i];
      }
    }
  }
  return result;
}

const std::vector<Cloud> all_clouds = clouds();

} // namespace

BOOST_AUTO_TEST_CASE(blocks_are_bitwise_identical_to_one_piece)
{
  for (const Cloud& cloud : all_clouds) {
    const Result whole = in_one_piece(cloud);
    BOOST_TEST((whole.points != cloud.points));
    for (const std::size_t size : {1000u, 3000u}) {
      std::size_t largest_halo = 0;
      const Result in_pieces = piece_by_piece(cloud, size, largest_halo);
      BOOST_TEST((in_pieces == whole), "a cloud " << cloud.name << ", in pieces of " << size);
      if (cloud.constrained.empty()) // boxes with points far away meet all others
        BOOST_TEST(largest_halo < cloud.points.size());
      BOOST_TEST_MESSAGE("a cloud " << cloud.name << " of " << cloud.points.size()
                                    << ", in pieces of " << size << ": at most " << largest_halo
                                    << " points at hand");
    }
  }
}

BOOST_AUTO_TEST_CASE(a_missing_point_is_noticed_unless_nothing_depends_on_it)
{
  int refused = 0, accepted = 0;
  for (const Cloud& cloud : all_clouds) {
    const Result whole = in_one_piece(cloud);
    const Coordinate_frame frame = find_coordinate_frame<Sequential>(cloud.points);
    const std::size_t n = cloud.points.size(), block_size = 500;
    Indices order(n); // along the strip; the block is at its beginning
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
      return cloud.points[i].x() < cloud.points[j].x();
    });
    for (const std::size_t left_out : {520u, 1500u, 3500u, 5000u, 8000u, 14000u}) {
      Indices points = order;
      const All_but_one halo_before{cloud.points[order[left_out]]};
      points.erase(points.begin() + std::ptrdiff_t(left_out));
      Result result(cloud);
      All_but_one halo = halo_before;
      const Block_status status = with_maps(cloud, result, [&](const auto& parameters) {
        return smooth_block<Sequential>(points, block_size, frame, halo, parameters);
      });
      if (status == Block_status::HALO_TOO_SMALL) {
        ++refused;
        BOOST_TEST(halo.is_required);
        BOOST_TEST((result == Result(cloud)));
        continue;
      }
      ++accepted;
      for (std::size_t j = 0; j < block_size; ++j)
        BOOST_REQUIRE((result.points[points[j]] == whole.points[points[j]]));
    }
  }
  BOOST_TEST(refused >= int(all_clouds.size()));
  BOOST_TEST(accepted >= int(all_clouds.size()));
}

// All kinds of small clouds: whatever the shape, nothing is wrong.
BOOST_AUTO_TEST_CASE(blocks_of_random_clouds_are_bitwise_identical)
{
  for (unsigned int seed = 1; seed <= 60; ++seed) {
    const random_clouds::Cloud random(seed);
    if (random.points.empty())
      continue;
    Cloud cloud(random.kind, random.points);
    cloud.relaxation_steps = seed % 3;
    const Result whole = in_one_piece(cloud);
    std::size_t largest_halo = 0;
    BOOST_TEST((piece_by_piece(cloud, 60, largest_halo) == whole),
               "seed " << seed << ": " << cloud.name);
  }
}

BOOST_AUTO_TEST_CASE(arguments_are_checked_and_blocks_can_be_canceled)
{
  const Cloud& cloud = all_clouds.front();
  Points points(cloud.points.begin(), cloud.points.begin() + 400), before = points;
  Pieces pieces(points, points.size()); // one, which is read
  pieces.pieces[0].is_read = true;
  const Coordinate_frame frame = find_coordinate_frame<Sequential>(points);
  BOOST_CHECK_EXCEPTION(smooth_block<Sequential>(points, 401, frame, pieces), std::invalid_argument,
                        [](const std::invalid_argument& e) {
                          return std::string(e.what()) ==
                                 "CGAL::Point_set_flow::smooth_block: block_size is 401, but there "
                                 "are only 400 points";
                        });
  BOOST_TEST((smooth_block<Sequential>(points, 0, frame, pieces) == Block_status::SMOOTHED));
  BOOST_TEST((points == before));
  for (int calls : {0, 5, 40}) {
    const std::function<bool(double)> no = [&](double) { return calls-- > 0; };
    BOOST_TEST((smooth_block<Sequential>(points, 400, frame, pieces, np::callback(no)) ==
                Block_status::CANCELED));
    BOOST_TEST((points == before));
  }
  Points whole = points;
  CGAL::balanced_flow_smooth_point_set<Sequential>(whole, 30);
  Smoothing_report report;
  BOOST_TEST(
      (smooth_block<Sequential>(points, 300, frame, pieces, 30,
                                np::smoothing_report(std::ref(report))) == Block_status::SMOOTHED));
  BOOST_TEST(std::equal(points.begin(), points.begin() + 300, whole.begin()));
  BOOST_TEST(std::equal(points.begin() + 300, points.end(), before.begin() + 300));
  BOOST_TEST(report.number_of_points == 300u);
  BOOST_TEST(report.number_of_moved_points + report.number_of_points_without_noise +
                 report.number_of_isolated_points + report.number_of_points_at_rest ==
             300u);
}
