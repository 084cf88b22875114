// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_SMOOTH_FORMAT_H
#define BALANCED_FLOW_SMOOTH_FORMAT_H

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>

enum class Format { PLY, XYZ, OFF, LAS, LAZ };
constexpr const char* format_names[] = {"ply", "xyz", "off", "las", "laz"};
inline std::string name_of(Format format) { return format_names[std::size_t(format)]; }

inline bool is_las(Format format) { return format == Format::LAS || format == Format::LAZ; }

/// whether a file of one format can be written as one of the other with nothing else changed
inline bool same_kind(Format a, Format b) { return a == b || (is_las(a) && is_las(b)); }

/// Standard input and output are called so.
inline bool is_standard_stream(const std::filesystem::path& path) { return path == "-"; }

inline std::optional<Format> find_format(std::string name)
{
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  for (std::size_t i = 0; i < 5; ++i)
    if (name == format_names[i])
      return Format(i);
  if (name == "pwn" || name == "txt" || name == "pts")
    return Format::XYZ;
  return std::nullopt;
}

inline Format format_of(const std::filesystem::path& path)
{
  const std::string extension = path.extension().string();
  if (const auto format = find_format(extension.substr((std::min)(extension.size(), size_t(1)))))
    return *format;
  throw std::runtime_error("the format \"" + extension +
                           "\" is not known (ply, xyz, pwn, txt, pts, off, las, laz)");
}

/// Guesses the format from how a file begins.
inline Format format_of_bytes(const std::string& bytes)
{
  if (bytes.compare(0, 3, "ply") == 0)
    return Format::PLY;
  if (bytes.compare(0, 4, "LASF") == 0)
    return Format::LAS;
  if (bytes.substr(0, 200).find("OFF") != std::string::npos)
    return Format::OFF;
  const auto is_control = [](unsigned char c) { return c < ' ' && !std::isspace(c); };
  if (std::any_of(bytes.begin(),
                  bytes.begin() + std::ptrdiff_t((std::min)(bytes.size(), size_t(200))),
                  is_control))
    throw std::runtime_error("the format can not be guessed: use --format");
  return Format::XYZ;
}

#endif // BALANCED_FLOW_SMOOTH_FORMAT_H
