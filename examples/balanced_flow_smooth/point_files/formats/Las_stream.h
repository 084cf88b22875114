// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_FILES_LAS_STREAM_H
#define POINT_FILES_LAS_STREAM_H

#include "../Streamed_file.h"

namespace point_files {

/// Opens a LAS or LAZ file.
std::unique_ptr<Streamed_file> open_las_stream(const std::filesystem::path& path,
                                               const Read_options& options);

} // namespace point_files

#endif // POINT_FILES_LAS_STREAM_H
