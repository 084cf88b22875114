// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_EXAMPLES_TEMPORARY_FILE_H
#define BALANCED_FLOW_EXAMPLES_TEMPORARY_FILE_H

#include <filesystem>
#include <fstream>
#include <random>
#include <stdexcept>
#include <string>
#include <system_error>

/// A new file beside the one to be written; removed unless it takes that one's place.
class Temporary_file {
  std::filesystem::path m_target, m_path;
  std::ofstream m_out;

public:
  /// A link stays a link: it is what it points to that is written.
  explicit Temporary_file(const std::filesystem::path& path)
      : m_target(std::filesystem::weakly_canonical(path)),
        m_path(m_target.string() + "." + std::to_string(std::random_device()()) + ".part"),
        m_out(m_path, std::ios::binary)
  {
    if (!m_out)
      throw std::runtime_error("no file can be written in this directory");
  }

  ~Temporary_file()
  {
    m_out.close();
    std::error_code ignored;
    std::filesystem::remove(m_path, ignored);
  }

  std::ostream& stream() { return m_out; }

  void take_place()
  {
    m_out.close();
    if (!m_out)
      throw std::runtime_error("writing failed");
    std::error_code ignored; // there may be no file yet
    const auto status = std::filesystem::status(m_target, ignored);
    if (std::filesystem::exists(status))
      std::filesystem::permissions(m_path, status.permissions(), ignored);
    std::filesystem::rename(m_path, m_target);
  }
};

#endif // BALANCED_FLOW_EXAMPLES_TEMPORARY_FILE_H
