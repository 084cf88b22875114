// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_SMOOTH_PRINT_MANUAL_H
#define BALANCED_FLOW_SMOOTH_PRINT_MANUAL_H

#include "Command_line.h"

#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace balanced_flow_smooth {

/// The words of --help and of the manual page of a program that are not about one option
struct Manual_page {
  /// A list of terms, and what is to be said of all of them
  struct Section {
    std::string title;
    std::vector<std::pair<std::string, std::string>> terms;
    std::vector<std::string> paragraphs;
    bool is_in_help;
  };
  std::string name, summary;
  std::vector<std::string> synopsis; ///< what comes after the name of the program
  std::vector<std::string> description;
  std::vector<Section> sections; ///< behind the options
};

/// What --help prints
void print_help(std::ostream& out, const Manual_page& page, const Command_line& command_line);

/// The same, and more, in the language of manual pages
/// \param date of the page, for its foot
void print_manual_page(std::ostream& out, const Manual_page& page, const Command_line& command_line,
                       const std::string& date);

} // namespace balanced_flow_smooth

#endif // BALANCED_FLOW_SMOOTH_PRINT_MANUAL_H
