// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_SMOOTH_PARSE_OPTIONS_H
#define BALANCED_FLOW_SMOOTH_PARSE_OPTIONS_H

#include <boost/program_options.hpp>

#include <string>

namespace balanced_flow_smooth {

// what options with an optional argument mean without it
constexpr const char *json_without_file = "-", *man_without_date = "",
                     *relax_without_count = "5";

/// Cuts the command line into options and other words. An optional argument is one only behind "=",
/// as everywhere in GNU: the next word may be the name of a file.
/// \param words the name of the option that takes the other words
boost::program_options::parsed_options
parse_options(int argc, char** argv, const boost::program_options::options_description& known,
              const std::string& words);

} // namespace balanced_flow_smooth

#endif // BALANCED_FLOW_SMOOTH_PARSE_OPTIONS_H
