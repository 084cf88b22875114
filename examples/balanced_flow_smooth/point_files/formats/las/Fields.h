// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_FILES_LAS_FIELDS_H
#define POINT_FILES_LAS_FIELDS_H

#include "../../Layout.h"
#include "Header.h"
#include "Input.h"

#include <cstddef>
#include <string>
#include <vector>

namespace point_files::las {

/// A number in the record of a point, other than a coordinate
struct Field {
  std::string name;
  Scalar type = Scalar::UINT8; // of the bytes where it is
  std::size_t at = 0;
  unsigned shift = 0, bits = 0; // no bits: it has all of its bytes
  double scale = 1., offset = 0.;

  Number get(const char* record) const;
  /// \param number one that `holds()`
  void put(char* record, const Number& number) const;

  /// Whether the number is one of this field of a point format, to the last digit
  bool holds(const Number& number) const;

  /// The type in other formats
  Scalar scalar() const;
};

/// The number that LAS has for the type of extra bytes
unsigned number_of(Scalar type);

/// The fields of a point format, without the waveforms
std::vector<Field> fields_of(unsigned point_format);

/// The name that a field gets behind others: the only one, also without blanks
std::string unique_name(std::string name, const std::vector<Field>& others);

/// The fields of a file: those of its point format, and those of the extra bytes that are described
class Fields {
  std::vector<Field> m_fields;
  std::size_t m_described = 0; // bytes of a record

public:
  Fields(const Input& input, const Header& header);

  const std::vector<Field>& all() const { return m_fields; }

  /// What other formats can not take
  std::vector<std::string> losses(const Header& header) const;

private:
  void add_extra(const char* descriptor);
};

} // namespace point_files::las

#endif // POINT_FILES_LAS_FIELDS_H
