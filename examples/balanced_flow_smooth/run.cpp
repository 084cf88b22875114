// SPDX-License-Identifier: GPL-3.0-or-later
#include "run.h"

#include "Interrupt.h"
#include "Progress_bar.h"
#include "Scene.h"
#include "find_sides.h"
#include "point_files/point_file_io.h"
#include "point_files/write_point_files.h"
#include "smooth_in_blocks.h"

#include <CGAL/Real_timer.h>

#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <iostream>
#include <memory>
#include <utility>
#include <vector>

namespace balanced_flow_smooth {

namespace {

/// The format of an output, as far as it is known before the input is read; else null
const point_files::Format* early_output_format(const Job& job, const Settings& settings)
{
  if (settings.output_format || job.keeps_format)
    return settings.output_format;
  return &point_files::format_of(job.output);
}

std::unique_ptr<point_files::Point_file> read(const std::filesystem::path& input,
                                              const Settings& settings)
{
  const Nothing_at_stake nothing_at_stake;
  return point_files::read_point_file(
      input, settings.input_format,
      {settings.normals, settings.columns, settings.invalid, settings.zeros_are_invalid});
}

/// Tells what is in a file.
void describe(const point_files::Point_file& file, File_report& report)
{
  report.format = file.format->name;
  report.points = file.points.size() - file.invalid.size();
  report.invalid_points = file.invalid.size();
  report.drops_invalid = file.drops_invalid;
  report.scans = file.scans.empty() ? 1 : std::size_t(file.scans.back()) + 1;
  report.unknown_normals = std::size_t(std::count_if(file.normals.begin(), file.normals.end(),
                                                     [](const auto& n) { return !is_known(n); }));
  report.roles = file.roles;
  report.roles_source = file.roles_source;
}

/// The files of a scene, and what they become
class Files {
  const Settings& m_settings;
  std::vector<const point_files::Format*> m_output_formats;

public:
  Point_files all;

  Files(const Settings& settings, std::vector<File_report>& reports) : m_settings(settings)
  {
    for (const File_report& report : reports) {
      m_output_formats.push_back(early_output_format(report.job, settings));
      if (!settings.dry_run)
        point_files::check_output(report.job.output, m_output_formats.back());
    }
    for (std::size_t f = 0; f < reports.size(); ++f)
      add(reports[f], m_output_formats[f]);
    if (settings.together)
      warn_of_distant_files(all);
  }

  void warn(std::vector<File_report>& reports)
  {
    for (std::size_t f = 0; f < all.size(); ++f) {
      if (!m_settings.dry_run)
        point_files::warn_of_losses(*all[f], *m_output_formats[f]);
      reports[f].warnings = all[f]->warnings;
      for (const std::string& warning : reports[f].warnings)
        if (!m_settings.quiet)
          std::cerr << "warning: "
                    << (m_settings.together ? reports[f].job.input.string() + ": " : "") << warning
                    << std::endl;
    }
  }

  /// \return whether they are written: they are not after Ctrl-C
  bool write(const std::vector<File_report>& reports) const
  {
    std::vector<point_files::Output> outputs;
    for (std::size_t f = 0; f < all.size(); ++f)
      outputs.push_back({reports[f].job.output, *all[f], *m_output_formats[f]});
    return point_files::write_point_files(outputs, [] { return interrupt != 0; });
  }

private:
  void add(File_report& report, const point_files::Format*& output_format)
  {
    point_files::Point_file& file = *all.emplace_back(read(report.job.input, m_settings));
    describe(file, report);
    if (!output_format)
      output_format = file.format;
    report.output_format = output_format->name;
    if (m_settings.normals)
      point_files::request_normals(file, *output_format);
    report.normals = !file.normals.empty();
  }
};

/// Smooths a file that may be larger than the memory.
/// \return whether it is done: it is not after Ctrl-C
bool run_in_blocks(const Settings& settings, Scene_report& report)
{
  CGAL::Real_timer timer;
  timer.start();
  Progress_bar progress(!settings.quiet && isatty(STDERR_FILENO));
  if (!balanced_flow_blocks::smooth_in_blocks(settings, report, std::ref(progress)))
    return false;
  report.seconds = timer.time();
  return true;
}

} // namespace

bool run(const Settings& settings, Scene_report& report)
{
  if (!settings.memory.empty())
    return run_in_blocks(settings, report);
  Files files(settings, report.files);
  CGAL::Real_timer timer;
  timer.start();
  Scene scene(files.all);
  Progress_bar progress(!settings.quiet && isatty(STDERR_FILENO));
  const bool has_views = !scene.cloud.views.empty();
  const double share_of_sides = has_views ? .3 : 0.;
  if (has_views)
    report.sided_points = find_sides(scene.cloud, settings.smoothing, [&](double share) {
      return progress(share_of_sides * share);
    });
  const auto callback = [&](double share) {
    return progress(share_of_sides + (1. - share_of_sides) * share);
  };
  Smoothing_report smoothing;
  if (interrupt == 0) {
    if (settings.dry_run)
      smoothing = analyze(scene.cloud, settings.smoothing, callback);
    else
      smooth(scene.cloud, {0, scene.cloud.points.size()}, settings.smoothing, callback, smoothing);
  }
  if (interrupt != 0)
    return false;
  if (settings.dry_run)
    files.warn(report.files);
  else {
    scene.give_back(settings.smoothing, report.files);
    files.warn(report.files);
    if (!files.write(report.files))
      return false;
  }
  report.smoothing = smoothing;
  report.seconds = timer.time();
  return true;
}

} // namespace balanced_flow_smooth
