// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_FILES_LAS_LAZ_RECORDS_H
#define POINT_FILES_LAS_LAZ_RECORDS_H

#include "Records.h"

namespace point_files::las {

// Compressed records, by LASzip, which sees nothing but the points: it would lose the rest of a file.

/// Whether this program was built with LASzip; if not, what follows throws `std::runtime_error`.
bool has_laszip();

std::unique_ptr<Record_reader> make_laz_reader(const Input& input, const Header& header);
std::unique_ptr<Record_writer> make_laz_writer(std::ostream& out, unsigned point_format,
                                               std::size_t record_size);

/// The variable length record that tells how the records are compressed
std::string laszip_vlr(unsigned point_format, std::size_t record_size);

constexpr const char* laszip_user_id = "laszip encoded";
constexpr unsigned laszip_record_id = 22204;

} // namespace point_files::las

#endif // POINT_FILES_LAS_LAZ_RECORDS_H
