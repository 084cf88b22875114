// SPDX-License-Identifier: GPL-3.0-or-later
#include "smooth_one.h"

#include "Block_result.h"
#include "Excerpt.h"
#include "Experience.h"
#include "memory_use.h"
#include "point_files/Temporary_file.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace balanced_flow_blocks {

namespace {

/// Smooths the pages of a block, in parts if so many points do not fit into memory.
class Smoothing {
  const Manifest& m_manifest;
  const Progress& m_progress;
  const double m_pages; // of the block
  std::size_t m_first = 0;
  Experience m_experience;

public:
  Records result;
  Report_sum report;
  Effort effort;

  Smoothing(const Manifest& manifest, std::size_t block, const Progress& progress)
      : m_manifest(manifest), m_progress(progress),
        m_pages(double(manifest.blocks[block].page_count)),
        m_first(manifest.blocks[block].first_page),
        m_experience(Experience::before(manifest, block)), result(manifest.writes_normals)
  {}

  void operator()(std::size_t first, std::size_t last)
  {
    if (smooth_at_once(first, last))
      return;
    const std::size_t middle = first + (last - first) / 2;
    (*this)(first, middle);
    (*this)(middle, last);
  }

private:
  /// \return whether there was enough memory
  bool smooth_at_once(std::size_t first, std::size_t last)
  {
    Excerpt excerpt(m_manifest);
    for (std::size_t page = first; page < last; ++page)
      excerpt.read(page);
    const double usual = usual_spacing(first, last);
    for (std::size_t page = first; page < last; ++page)
      excerpt.require_near(m_manifest.pages[page].box,
                           m_experience.halo_width *
                               (std::min)(m_manifest.pages[page].spacing(), 2. * usual));
    const std::size_t block_size = excerpt.points.size();
    const auto share = [&](double done) {
      return (double(first - m_first) + done * double(last - first)) / m_pages;
    };
    for (int trial = 0;; ++trial) {
      const std::uint64_t at_hand = excerpt.points.size() + excerpt.number_of_required_points();
      if (at_hand > points_at_hand(m_manifest.memory, m_experience.most_neighbors,
                                   m_manifest.has_normals) &&
          last - first > 1)
        return false;
      excerpt.read_required();
      effort.points_at_hand = (std::max)(effort.points_at_hand, excerpt.points.size());
      ++effort.trials;
      const Progress progress = m_progress.part(share(0.), share(1.));
      std::optional<Interrupted> interrupted;
      Smoothing_report found;
      balanced_flow_smooth::Cloud cloud{excerpt.points, excerpt.normals, {}, excerpt.scans};
      const bool is_done = balanced_flow_smooth::smooth_block(
          cloud, block_size, m_manifest.frame, excerpt, m_manifest.settings.smoothing,
          [&](double done) {
            try {
              progress(done);
            }
            catch (const Interrupted& e) {
              interrupted = e;
            }
            return !interrupted;
          },
          found);
      if (interrupted)
        throw *interrupted;
      if (is_done) {
        report.add(found);
        m_experience.set_neighbors(found.most_neighbors);
        effort.halo_width = m_experience.halo_width;
        keep(excerpt, cloud, block_size);
        return true;
      }
      if (trial == 0)
        m_experience.widen();
    }
  }

  /// The median over pages: the boxes of some are large because of points far away.
  double usual_spacing(std::size_t first, std::size_t last) const
  {
    std::vector<double> spacings;
    for (std::size_t page = first; page < last; ++page)
      spacings.push_back(m_manifest.pages[page].spacing());
    const auto middle = spacings.begin() + std::ptrdiff_t(spacings.size() / 2);
    std::nth_element(spacings.begin(), middle, spacings.end());
    return *middle;
  }

  void keep(const Excerpt& excerpt, const balanced_flow_smooth::Cloud& cloud, std::size_t count)
  {
    const std::size_t before = result.size();
    result.resize(before + count);
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t d = 0; d < 3; ++d) {
        result.set_value(before + i, d, cloud.points[i][int(d)]);
        if (m_manifest.writes_normals)
          result.set_value(before + i, d + 3, cloud.normals[i][int(d)]);
      }
      result.set_number(before + i, excerpt.numbers[i]);
    }
  }
};

} // namespace

void smooth_one(const Manifest& manifest, std::size_t block, const Progress& progress)
{
  if (block >= manifest.blocks.size())
    throw std::runtime_error("there is no block " + std::to_string(block) +
                             ": their numbers are 0 to " +
                             std::to_string(manifest.blocks.size() - 1));
  if (Block_result::exists(manifest, block))
    return;
  const std::filesystem::path result = manifest.result_file(block);
  point_files::remove_abandoned(result.parent_path(),
                                [&](const std::string& name) { return name == result.filename(); });
  const Block& pages = manifest.blocks[block];
  Smoothing smoothing(manifest, block, progress);
  smoothing(pages.first_page, pages.first_page + pages.page_count);
  Block_result::write(manifest, block, smoothing.result, smoothing.report.report(),
                      smoothing.effort);
}

} // namespace balanced_flow_blocks
