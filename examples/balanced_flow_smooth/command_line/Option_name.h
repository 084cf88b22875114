// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_SMOOTH_OPTION_NAME_H
#define BALANCED_FLOW_SMOOTH_OPTION_NAME_H

#include <boost/program_options.hpp>

#include <string>

namespace balanced_flow_smooth {

/// The name of an option in parts: "-k", "--neighbors", "N"
struct Option_name {
  std::string short_name, long_name, argument;
  bool argument_is_optional;

  explicit Option_name(const boost::program_options::option_description& option);
};

} // namespace balanced_flow_smooth

#endif // BALANCED_FLOW_SMOOTH_OPTION_NAME_H
