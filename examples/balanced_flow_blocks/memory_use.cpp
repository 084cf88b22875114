// SPDX-License-Identifier: GPL-3.0-or-later
#include "memory_use.h"

#include "command_line/Command_line.h"

#include <cctype>
#include <charconv>

namespace balanced_flow_blocks {

std::uint64_t memory_from_text(const std::string& text)
{
  if (text.empty())
    return std::uint64_t(2) << 30;
  std::uint64_t size = 0;
  const char* const end = text.data() + text.size();
  const auto parsed = std::from_chars(text.data(), end, size);
  const std::string unit(parsed.ptr, end);
  const std::string units = "KMGT";
  std::uint64_t factor = 1;
  bool is_size = parsed.ec == std::errc() && unit.size() <= 1;
  if (is_size && !unit.empty()) {
    const std::size_t power = units.find(char(std::toupper(static_cast<unsigned char>(unit[0]))));
    is_size = power != std::string::npos;
    if (is_size)
      factor = std::uint64_t(1) << (10 * (power + 1));
  }
  if (!is_size || size > (~std::uint64_t(0) >> 1) / factor)
    throw balanced_flow_smooth::Usage_error("--memory is \"" + text +
                                            "\", but must be a size such as 512M or 2G");
  if (size * factor < smallest_memory)
    throw balanced_flow_smooth::Usage_error("--memory is " + text + ", but must be at least 256M");
  return size * factor;
}

} // namespace balanced_flow_blocks
