// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_FILES_PLY_STREAM_H
#define POINT_FILES_PLY_STREAM_H

#include "../Streamed_file.h"

namespace point_files {

/// Opens a PLY file whose points are records of bytes that are all of one size, and come first; null for others.
std::unique_ptr<Streamed_file> open_ply_stream(const std::filesystem::path& path);

} // namespace point_files

#endif // POINT_FILES_PLY_STREAM_H
