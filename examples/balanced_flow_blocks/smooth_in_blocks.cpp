// SPDX-License-Identifier: GPL-3.0-or-later
#include "smooth_in_blocks.h"

#include "join.h"
#include "memory_use.h"
#include "plan.h"
#include "run.h"

#include <stdlib.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <system_error>

namespace balanced_flow_blocks {

namespace {

/// A new directory for the time of a scope
class Scratch_directory {
  std::filesystem::path m_path;

public:
  Scratch_directory()
  {
    std::string name = std::filesystem::temp_directory_path() / "balanced-flow-smooth.XXXXXX";
    if (!::mkdtemp(name.data()))
      throw std::runtime_error("no temporary directory " + name +
                               " can be made: " + std::generic_category().message(errno));
    m_path = name;
  }
  ~Scratch_directory()
  {
    std::error_code ignored;
    std::filesystem::remove_all(m_path, ignored);
  }
  Scratch_directory(const Scratch_directory&) = delete;
  Scratch_directory& operator=(const Scratch_directory&) = delete;

  const std::filesystem::path& path() const { return m_path; }
};

} // namespace

bool smooth_in_blocks(const balanced_flow_smooth::Settings& settings,
                      balanced_flow_smooth::Scene_report& scene,
                      const std::function<bool(double)>& callback)
{
  const Progress progress(callback);
  balanced_flow_smooth::File_report& report = scene.files.front();
  try {
    const Scratch_directory directory;
    Plan_request request =
        request_of(settings, directory.path(), {{report.job.input, report.job.output}});
    request.may_replace_inputs = true; // the command line was checked
    const Manifest manifest = plan(request, progress.part(0., .1));
    smooth_all(manifest, settings.processes, progress.part(.1, .95));
    scene.smoothing = join(manifest, progress.part(.95, 1.));
    report.format = report.output_format = manifest.inputs.front().format;
    report.invalid_points = manifest.inputs.front().invalid;
    report.points = manifest.number_of_points - report.invalid_points;
    report.normals = manifest.writes_normals;
    report.scans = (std::max)(manifest.scans.size(), std::size_t(1));
    scene.sided_points = manifest.sided_points;
    progress(1.);
    return true;
  }
  catch (const Interrupted&) {
    return false;
  }
}

} // namespace balanced_flow_blocks
