// SPDX-License-Identifier: GPL-3.0-or-later
#include "Written_outputs.h"

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

namespace balanced_flow_blocks {

namespace {

/// The output of an input as a file that can be looked at
Input_file output_of(const Input_file& input)
{
  Input_file output;
  output.path = input.output;
  return output;
}

} // namespace

Written_outputs::Written_outputs(const Manifest& manifest)
    : m_manifest(manifest), m_path(manifest.directory / "written")
{
  std::ifstream in(m_path);
  for (std::string line; std::getline(in, line);) { // the last one may not be complete
    std::istringstream words(line);
    std::uint64_t plan = 0;
    std::size_t i = 0;
    Input_file file;
    std::string end;
    if (words >> plan >> i >> file.size >> file.time >> end && end == "." &&
        plan == manifest.checksum && i < manifest.inputs.size()) {
      file.path = manifest.inputs[i].output;
      m_written[i] = file;
    }
  }
}

bool Written_outputs::has(std::size_t input) const
{
  const auto found = m_written.find(input);
  if (found == m_written.end())
    return false;
  try {
    found->second.check_unchanged();
    return true;
  }
  catch (const std::runtime_error&) {
    return false;
  }
}

void Written_outputs::add(std::size_t input)
{
  Input_file file = output_of(m_manifest.inputs[input]);
  file.look_at_file();
  std::ofstream out(m_path, std::ios::app);
  out << m_manifest.checksum << ' ' << input << ' ' << file.size << ' ' << file.time << " .\n";
  if (!out.flush())
    throw std::runtime_error("cannot write " + m_path.string());
  m_written[input] = file;
}

} // namespace balanced_flow_blocks
