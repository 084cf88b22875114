// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_SMOOTH_COMMAND_LINE_H
#define BALANCED_FLOW_SMOOTH_COMMAND_LINE_H

#include "Settings.h"

#include <boost/program_options.hpp>

#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace balanced_flow_smooth {

/// A command line that is wrong
struct Usage_error : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The values of the options that have a fixed choice
const std::map<std::string, std::vector<std::string>>& choices();

/// What stands on the command line; each option is described once, here.
class Command_line {
  // as they come: signed, so that -1 is refused and not 4294967295
  int m_k = 0, m_iterations = 0, m_update_period = 4, m_relaxation_steps = 0, m_threads = 0,
      m_jobs = 1;
  long m_block_size = 0;
  double m_noise = 0., m_feature_threshold = 0., m_filter_width = 0.;
  bool m_in_place = false;
  std::string m_output_directory, m_format, m_output_format, m_columns, m_invalid;
  std::vector<std::string> m_files;
  Settings m_settings;
  boost::program_options::variables_map m_given;

public:
  typedef boost::program_options::options_description Option_group;

  std::vector<Option_group> groups; // for those who ask for help
  Option_group hidden;

  Command_line();
  Command_line(const Command_line&) = delete; // the options know where their values go
  Command_line& operator=(const Command_line&) = delete;

  /// Throws `Usage_error` if there are options that are not known.
  void read(int argc, char** argv);

  bool has(const char* option) const { return m_given.count(option) != 0; }
  bool is_default(const char* option) const { return m_given[option].defaulted(); }
  std::string text(const char* option) const { return m_given[option].as<std::string>(); }

  /// Makes sense of it; throws `Usage_error` if there is none.
  Settings settings();

  /// The same for programs that take other words than inputs and outputs
  Settings settings_without_jobs();
  const std::vector<std::string>& words() const { return m_files; }

private:
  void add_file_options(Option_group& group);
  void add_report_options(Option_group& group);
  void add_smoothing_options(Option_group& group);
  void add_memory_options(Option_group& group);
  void add_hidden_options(Option_group& group);
  void set_columns();
  void set_smoothing();
  void check_memory() const;
  void set_jobs();
  void add_job_for_each_file();
  std::filesystem::path in_directory(const std::filesystem::path& file) const;
};

} // namespace balanced_flow_smooth

#endif // BALANCED_FLOW_SMOOTH_COMMAND_LINE_H
