// SPDX-License-Identifier: GPL-3.0-or-later
#include "write_rows.h"

namespace point_files {

void write_text_rows(std::ostream& out, const Point_file& file)
{
  const auto append = [](std::string& row, Scalar type, double number) {
    if (!row.empty())
      row += ' ';
    append_text(row, type, number);
  };
  write_rows(out, file, append, "\n");
}

} // namespace point_files
