// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_SMOOTH_PRINT_MANUAL_H
#define BALANCED_FLOW_SMOOTH_PRINT_MANUAL_H

#include "Command_line.h"

#include <ostream>
#include <string>

namespace balanced_flow_smooth {

/// What --help prints
void print_help(std::ostream& out, const Command_line& command_line);

/// The same, and more, in the language of manual pages
/// \param date of the page, for its foot
void print_manual_page(std::ostream& out, const Command_line& command_line,
                       const std::string& date);

} // namespace balanced_flow_smooth

#endif // BALANCED_FLOW_SMOOTH_PRINT_MANUAL_H
