// SPDX-License-Identifier: GPL-3.0-or-later
#include "Format.h"

#include "Line_reader.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <stdexcept>

namespace point_files {

const Format* find_format(std::string name)
{
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  for (const Format& format : all_formats())
    if (name == format.name || std::find(format.extensions.begin(), format.extensions.end(),
                                         name) != format.extensions.end())
      return &format;
  return nullptr;
}

const Format& format_of(const std::filesystem::path& path)
{
  const std::string extension = path.extension().string();
  if (const Format* format = find_format(extension.substr((std::min)(extension.size(), size_t(1)))))
    return *format;
  std::string known;
  for (const Format& format : all_formats()) {
    known += (known.empty() ? "" : ", ") + format.name;
    for (const std::string& other : format.extensions)
      known += ", " + other;
  }
  throw std::runtime_error("the format \"" + extension + "\" is not known (" + known + ")");
}

const Format* format_with_magic(const Bytes& bytes)
{
  for (const Format& format : all_formats())
    if (!format.magic.empty() &&
        bytes.compare(size_of_mark(bytes), format.magic.size(), format.magic) == 0 &&
        (!format.recognizes || format.recognizes(bytes)))
      return &format;
  return nullptr;
}

const Format& format_of_bytes(const Bytes& bytes)
{
  if (const Format* format = format_with_magic(bytes))
    return *format;
  for (const Format& format : all_formats())
    if (format.magic.empty() && format.recognizes && format.recognizes(bytes))
      return format;
  const auto is_control = [](unsigned char c) { return c < ' ' && !std::isspace(c); };
  if (std::any_of(bytes.begin(),
                  bytes.begin() + std::ptrdiff_t((std::min)(bytes.size(), size_t(200))),
                  is_control))
    throw std::runtime_error("the format can not be guessed: use --format");
  return *find_format("xyz");
}

void check_support(const Format& format)
{
  if (!format.read)
    fail_without(format.library, format.package, "the format " + format.name);
}

void fail_without(const std::string& library, const std::string& package, const std::string& what)
{
  throw std::runtime_error(what + " needs " + library +
                           ", which this program was built without: install it (" + package +
                           "), and build the program again");
}

} // namespace point_files
