// SPDX-License-Identifier: GPL-3.0-or-later
// The options of the command line, in words
#include "Command_line.h"
#include "parse_options.h"

#include <cstddef>

namespace balanced_flow_smooth {

namespace options = boost::program_options;

namespace {

std::vector<std::string> names_of_formats()
{
  std::vector<std::string> names;
  for (const point_files::Format& format : point_files::all_formats())
    names.push_back(format.name);
  return names;
}

/// "a, b or c"
std::string alternatives(const std::vector<std::string>& values)
{
  std::string text;
  for (std::size_t i = 0; i < values.size(); ++i)
    text += (i == 0 ? "" : i + 1 == values.size() ? " or " : ", ") + values[i];
  return text;
}

} // namespace

const std::map<std::string, std::vector<std::string>>& choices()
{
  static const std::map<std::string, std::vector<std::string>> table = {
      {"flow", {"curvature", "anisotropic", "well-posed", "volume-preserving", "balanced"}},
      {"curvature", {"learned", "tangent-plane", "covariance"}},
      {"format", names_of_formats()},
      {"output-format", names_of_formats()},
      {"invalid", {"keep", "drop", "error"}},
      {"print-completion", {"bash", "zsh", "fish"}},
  };
  return table;
}

// clang-format off
void Command_line::add_file_options(Option_group& group)
{
  group.add_options()
    ("in-place,i", options::bool_switch(&m_in_place), "replace each file by its smoothed points")
    ("output-dir,d", options::value(&m_output_directory)->value_name("DIR"),
     "write to files of the same names in DIR, which is not the directory of the input")
    ("together", options::bool_switch(&m_settings.together),
     "the files are scans of one scene, in the same coordinates: smooth them as one; all of them are written, or none")
    ("format", options::value(&m_format)->value_name("FORMAT"),
     ("the format of all inputs, whatever their names: " + alternatives(names_of_formats())).c_str())
    ("output-format", options::value(&m_output_format)->value_name("FORMAT"),
     "the format of the output, whatever its name; files in DIR get its extension; "
     "by default that of the input for - and DIR")
    ("columns", options::value(&m_columns)->value_name("NAMES"),
     "what the columns of text are, whatever its header says, for instance x,y,z,nx,ny,nz or x,y,z,_,intensity; _ or "
     "nothing: no name, and so are those that are left")
    ("invalid", options::value(&m_invalid)->value_name("WHAT"),
     "what to do with points whose coordinates are not finite: keep them in their places as they are, drop them, or "
     "error; by default they are kept if the format has a meaning for them, and are an error else")
    ("invalid-zeros", options::bool_switch(&m_settings.zeros_are_invalid),
     "points at (0, 0, 0) are invalid, too, whatever the format")
    ("normals", options::bool_switch(&m_settings.normals),
     "write normals even if the input has none, or some that are null vectors or NaN, which else stay");
}

void Command_line::add_report_options(Option_group& group)
{
  group.add_options()
    ("dry-run,n", options::bool_switch(&m_settings.dry_run),
     "write no points; tell spacing, noise and the parameters that would be used")
    ("json", options::value(&m_settings.report)->implicit_value(json_without_file)->value_name("FILE"),
     "write the report as JSON, to FILE if it is given (--json=FILE), else to standard output in place of the summary")
    ("quiet,q", options::bool_switch(&m_settings.quiet), "no progress bar, no summary, no warnings")
    ("help,h", "print this text")
    ("version", "print the version");
}

void Command_line::add_smoothing_options(Option_group& group)
{
  Smoothing_settings& s = m_settings.smoothing;
  group.add_options()
    ("noise", options::value(&m_noise)->value_name("LENGTH"),
     "standard deviation of the noise along the normals, in the unit of the data; by default estimated around each "
     "point. It replaces the estimate; with 0 nothing moves")
    ("neighbors,k", options::value(&m_k)->value_name("N"),
     "number of neighbors, 0: chosen for each point from the data, which is the default")
    ("neighbor-radius", options::value(&s.neighbor_radius)->value_name("LENGTH"),
     "no neighbors beyond it, 0: no limit, which is the default")
    ("iterations", options::value(&m_iterations)->value_name("N"),
     "number of iterations, by default as many as suit the estimator, 5 or 12")
    ("relax", options::value(&m_relaxation_steps)->implicit_value(std::stoi(relax_without_count), relax_without_count)->value_name("N"),
     "then spread the points evenly along the surface, in N steps, by default 5 (--relax=N); colors and other columns "
     "move with their points")
    ("sharpness-angle", options::value(&s.sharpness_angle)->value_name("DEGREES"),
     "creases from this angle on are features; by default 60, or 30 for the estimator of the paper")
    ("feature-threshold", options::value(&m_feature_threshold)->value_name("K"),
     "K of the paper instead of the sharpness angle")
    ("filter-width", options::value(&m_filter_width)->value_name("SIGMA"),
     "width of the Gaussians, in neighborhood radii; by default 0.6, or 0.3")
    ("step-length", options::value(&s.step_length)->value_name("S"), "s of the paper; by default 0.75")
    ("update-period", options::value(&m_update_period)->value_name("L"),
     "L of the paper, by default 4; 0: the reference is never updated")
    ("flow", options::value(&s.flow)->value_name("FLOW"),
     "curvature, anisotropic, well-posed, volume-preserving or balanced, which is the default")
    ("curvature", options::value(&s.curvature)->value_name("ESTIMATOR"),
     "learned, which is the default; tangent-plane, the same without what is learned; or covariance, that of the paper")
    ("threads", options::value(&m_threads)->value_name("N"), "number of threads, 0: all, which is the default");
}

void Command_line::add_memory_options(Option_group& group)
{
  group.add_options()
    ("memory", options::value(&m_settings.memory)->value_name("SIZE"),
     "smooth files that do not fit into memory, block by block in a directory for temporary files (TMPDIR); SIZE of "
     "memory, say 2G, is used by each process")
    ("jobs,j", options::value(&m_jobs)->value_name("N"), "number of processes that smooth blocks, by default 1")
    ("block-size", options::value(&m_block_size)->value_name("N"),
     "the largest number of points in a block, by default as many as suit the memory");
}

void Command_line::add_hidden_options(Option_group& group)
{
  group.add_options()
    ("print-man", options::value<std::string>()->implicit_value(man_without_date)->value_name("DATE"), "print the manual page")
    ("print-completion", options::value<std::string>()->value_name("SHELL"), "print the completion for a shell")
    ("file", options::value(&m_files), "");
}
// clang-format on

} // namespace balanced_flow_smooth
