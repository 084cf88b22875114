// SPDX-License-Identifier: GPL-3.0-or-later
#include "Spool_file.h"

#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <system_error>

namespace point_files {

Spool_file::Spool_file()
{
  std::string name = std::filesystem::temp_directory_path() / "balanced-flow-smooth.XXXXXX";
  const int file = ::mkstemp(name.data()); // which nobody else may read
  if (file < 0)
    throw std::runtime_error("no temporary file " + name +
                             " can be made: " + std::generic_category().message(errno));
  ::close(file);
  m_path = name;
}

Spool_file::~Spool_file()
{
  std::error_code ignored;
  std::filesystem::remove(m_path, ignored);
}

} // namespace point_files
