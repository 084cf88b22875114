// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_FILES_PCD_LZF_H
#define POINT_FILES_PCD_LZF_H

#include <cstddef>
#include <string>

namespace point_files::pcd {

// Compression by liblzf. Without the library both throw `std::runtime_error`, which says so.

/// How many bytes one of LZF stands for at most: three can stand for 264.
constexpr std::size_t largest_lzf_ratio = 88;

/// \param size of the bytes; throws `std::runtime_error` if it is another one
std::string decompress_lzf(const char* compressed, std::size_t compressed_size, std::size_t size);

std::string compress_lzf(const std::string& bytes);

} // namespace point_files::pcd

#endif // POINT_FILES_PCD_LZF_H
