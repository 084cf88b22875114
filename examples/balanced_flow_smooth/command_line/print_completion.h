// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_SMOOTH_PRINT_COMPLETION_H
#define BALANCED_FLOW_SMOOTH_PRINT_COMPLETION_H

#include "Command_line.h"

#include <ostream>
#include <string>
#include <vector>

namespace balanced_flow_smooth {

/// What completion has to know of a program besides its options
struct Completed_program {
  std::string name;
  std::vector<std::string> commands; ///< of which the first word is one; empty if there are none
};

/// Prints the script that completes command lines of a program.
/// \param shell bash, zsh or fish
void print_completion(std::ostream& out, const Command_line& command_line,
                      const Completed_program& program, const std::string& shell);

} // namespace balanced_flow_smooth

#endif // BALANCED_FLOW_SMOOTH_PRINT_COMPLETION_H
