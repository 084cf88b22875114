// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_SMOOTH_PRINT_COMPLETION_H
#define BALANCED_FLOW_SMOOTH_PRINT_COMPLETION_H

#include "Command_line.h"

#include <ostream>
#include <string>

namespace balanced_flow_smooth {

/// Prints the script that completes command lines of the program.
/// \param shell bash, zsh or fish
void print_completion(std::ostream& out, const Command_line& command_line,
                      const std::string& shell);

} // namespace balanced_flow_smooth

#endif // BALANCED_FLOW_SMOOTH_PRINT_COMPLETION_H
