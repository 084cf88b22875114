// SPDX-License-Identifier: GPL-3.0-or-later
#include "lzf.h"

#ifdef POINT_SET_FLOW_WITH_LZF

#include <lzf.h>

#include <limits>
#include <stdexcept>

namespace point_files::pcd {

std::string decompress_lzf(const char* compressed, std::size_t compressed_size, std::size_t size)
{
  std::string bytes(size, '\0');
  // the library counts in unsigned int, as do the sizes in PCD
  const unsigned found =
      ::lzf_decompress(compressed, unsigned(compressed_size), bytes.data(), unsigned(size));
  if (found != size)
    throw std::runtime_error("the compressed points are damaged: they are no " +
                             std::to_string(size) + " bytes of LZF");
  return bytes;
}

std::string compress_lzf(const std::string& bytes)
{
  const std::size_t largest = bytes.size() + bytes.size() / 16 + 64; // noise becomes longer
  if (largest > (std::numeric_limits<unsigned>::max)())
    throw std::runtime_error("the points have " + std::to_string(bytes.size()) +
                             " bytes, too many for binary_compressed PCD");
  std::string compressed(largest, '\0');
  const unsigned size = ::lzf_compress(bytes.data(), unsigned(bytes.size()), compressed.data(),
                                       unsigned(compressed.size()));
  if (size == 0)
    throw std::runtime_error("liblzf does not compress the points");
  compressed.resize(size);
  return compressed;
}

} // namespace point_files::pcd

#else

#include "../../Format.h"

namespace point_files::pcd {

namespace {

[[noreturn]] void fail_without_lzf()
{
  fail_without("liblzf", "liblzf-dev in Debian and Ubuntu", "binary_compressed PCD");
}

} // namespace

std::string decompress_lzf(const char*, std::size_t, std::size_t) { fail_without_lzf(); }

std::string compress_lzf(const std::string&) { fail_without_lzf(); }

} // namespace point_files::pcd

#endif
