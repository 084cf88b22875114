// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_FILES_LAS_RECORDS_H
#define POINT_FILES_LAS_RECORDS_H

#include "Header.h"
#include "Input.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <ostream>
#include <string>

namespace point_files::las {

/// Goes through the records of the points.
class Record_reader {
public:
  virtual ~Record_reader() = default;

  /// The next of as many records as the header announces, until the next call; those who want may
  /// change it. Throws `std::runtime_error` if it can not be read.
  virtual char* next() = 0;
};

/// Takes the records of the points.
class Record_writer {
public:
  virtual ~Record_writer() = default;

  virtual void write(const char* record) = 0;
  /// Writes what is still to be written.
  virtual void finish() = 0;
};

/// Makes the reader that suits the file.
std::unique_ptr<Record_reader> make_reader(const Input& input, const Header& header);

/// Makes a writer. For compressed records, the stream can seek.
std::unique_ptr<Record_writer> make_writer(std::ostream& out, bool is_compressed,
                                           unsigned point_format, std::size_t record_size);

} // namespace point_files::las

#endif // POINT_FILES_LAS_RECORDS_H
