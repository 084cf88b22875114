// SPDX-License-Identifier: GPL-3.0-or-later
#include "Option_name.h"

namespace balanced_flow_smooth {

namespace options = boost::program_options;

Option_name::Option_name(const options::option_description& option)
    : long_name("--" + option.long_name())
{
  const std::string names = option.format_name(); // "-k [ --neighbors ]"
  if (names[1] != '-')
    short_name = names.substr(0, 2);
  const options::value_semantic& value = *option.semantic();
  argument_is_optional = value.min_tokens() == 0 && value.max_tokens() != 0;
  if (value.max_tokens() != 0)
    argument = value.name();
  if (argument_is_optional) // "[=FILE(=-)]"
    argument = argument.substr(2, argument.find('(') - 2);
}

} // namespace balanced_flow_smooth
