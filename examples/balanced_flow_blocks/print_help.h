// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_BLOCKS_PRINT_HELP_H
#define BALANCED_FLOW_BLOCKS_PRINT_HELP_H

#include "command_line/Command_line.h"

#include <ostream>

namespace balanced_flow_blocks {

/// What --help prints
inline void print_help(std::ostream& out, const balanced_flow_smooth::Command_line& command_line)
{
  out << R"(Usage: balanced-flow-blocks plan [OPTION]... DIR INPUT...
       balanced-flow-blocks smooth [--threads N] DIR BLOCK
       balanced-flow-blocks join DIR
       balanced-flow-blocks run [OPTION]... DIR [INPUT...]
       balanced-flow-blocks status [--json] DIR

Smooths point sets that do not fit into memory, or on several machines. The result is
bitwise that of balanced-flow-smooth for all points at once.

  plan    sorts the points of the inputs, files or directories of files, into blocks in DIR;
          options of smoothing are given here
  smooth  smooths one block, with as many other points as have a say. BLOCK is a number
          from 0 on. Blocks can be smoothed in any order and by any number of processes.
  join    writes each input with its smoothed points to DIR/smoothed, or to --output-dir,
          which is given to plan
  run     does all that is not done yet
  status  tells how many blocks there are, and how many are smoothed

What is done is not done again: after an interruption the same command goes on.
)";
  for (const auto& group : command_line.groups)
    out << '\n' << group;
}

} // namespace balanced_flow_blocks

#endif // BALANCED_FLOW_BLOCKS_PRINT_HELP_H
