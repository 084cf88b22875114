// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_FILES_LAS_FILE_H
#define POINT_FILES_LAS_FILE_H

#include "../Point_file.h"
#include "las/Fields.h"
#include "las/Header.h"
#include "las/Input.h"

#include <string>
#include <vector>

namespace point_files {

/// A LAS or LAZ file. It stays on the disk: only the points are in memory, and the rest is read again
/// when it is written.
class Las_file : public Point_file {
  las::Input m_input;
  las::Header m_header;
  las::Fields m_fields;

public:
  explicit Las_file(las::Input input);

  void write(const Target& target) const override;
  void for_each_record(bool with_values, const Visitor& visit) const override;
  std::vector<Property> columns() const override;
  std::vector<std::string> losses() const override { return m_fields.losses(m_header); }
  Scalar coordinate_type() const override { return Scalar::DOUBLE; }
};

} // namespace point_files

#endif // POINT_FILES_LAS_FILE_H
