// SPDX-License-Identifier: GPL-3.0-or-later
#include "check_paths.h"

#include "Command_line.h"

#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

namespace balanced_flow_smooth {

namespace {

typedef std::filesystem::path Path;

/// The device and the number of a regular file; nothing if there is none.
std::optional<std::pair<dev_t, ino_t>> identity(const Path& path)
{
  struct stat status;
  const int result = path == "-" ? ::fstat(STDIN_FILENO, &status) : ::stat(path.c_str(), &status);
  if (result != 0 || !S_ISREG(status.st_mode))
    return std::nullopt;
  return std::make_pair(status.st_dev, status.st_ino);
}

/// Files, found again under any of their names
class File_set {
  std::map<std::pair<dev_t, ino_t>, Path> m_files;
  std::map<Path, Path> m_names; // of those that are not there yet

public:
  /// \return the path under which the file is in the set; null if it is not
  const Path* find(const Path& path) const
  {
    if (const auto id = identity(path)) {
      const auto found = m_files.find(*id);
      return found == m_files.end() ? nullptr : &found->second;
    }
    const auto found = m_names.find(canonical(path));
    return found == m_names.end() ? nullptr : &found->second;
  }

  void insert(const Path& path)
  {
    if (const auto id = identity(path))
      m_files.emplace(*id, path);
    else
      m_names.emplace(canonical(path), path);
  }

private:
  static Path canonical(const Path& path)
  {
    std::error_code ignored;
    const Path canonical =
        std::filesystem::weakly_canonical(std::filesystem::absolute(path), ignored);
    return canonical.empty() ? path : canonical;
  }
};

std::string name_of(const Path& input) { return input == "-" ? "standard input" : input.string(); }

void check_outputs(const Settings& settings, const File_set& inputs)
{
  File_set outputs;
  for (const Job& job : settings.jobs) {
    if (job.output.empty() || job.output == "-")
      continue;
    if (const Path* first = outputs.find(job.output))
      throw Usage_error(*first == job.output ? "two files would become " + job.output.string()
                                             : first->string() + " and " + job.output.string() +
                                                   " are the same file");
    outputs.insert(job.output);
    if (job.output == job.input)
      continue; // asked for by --in-place, or by its name as input and as output
    if (const Path* input = inputs.find(job.output))
      throw Usage_error(job.output.string() + " is the input " +
                        (*input == job.input ? "itself" : name_of(*input)) +
                        ": to replace a file, use --in-place");
  }
  if (settings.report.empty() || settings.report == "-")
    return;
  if (const Path* input = inputs.find(settings.report))
    throw Usage_error("the report would be written over the input " + name_of(*input));
  if (outputs.find(settings.report))
    throw Usage_error("the report would be written over the output " + settings.report);
}

} // namespace

void check_paths(const Settings& settings)
{
  File_set inputs;
  for (const Job& job : settings.jobs) {
    const Path* first = inputs.find(job.input);
    if (first && settings.together)
      throw Usage_error(*first == job.input ? name_of(job.input) + " is given twice"
                                            : name_of(*first) + " and " + name_of(job.input) +
                                                  " are the same file, which can not be two scans");
    inputs.insert(job.input);
  }
  check_outputs(settings, inputs);
}

} // namespace balanced_flow_smooth
