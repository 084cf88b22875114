// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_BLOCKS_MANUAL_H
#define BALANCED_FLOW_BLOCKS_MANUAL_H

#include "command_line/print_manual.h"

#include <string>
#include <vector>

namespace balanced_flow_blocks {

constexpr const char* program_name = "balanced-flow-blocks";

inline const std::vector<std::string> commands = {"plan", "smooth", "join", "run", "status"};

/// The words of --help and of the manual page that are not about one option
inline balanced_flow_smooth::Manual_page manual_page()
{
  return {
      program_name,
      "take the noise off 3D point sets that do not fit into memory",
      {"plan [OPTION]... DIR INPUT...", "smooth [--threads N] DIR BLOCK", "join DIR",
       "run [OPTION]... DIR [INPUT...]", "status [--json] DIR"},
      {"Smooths any number of files as one cloud, block by block, on one machine or many. The "
       "result "
       "is bitwise that of balanced-flow-smooth for all points at once. What is done is not done "
       "again: after an interruption, a crash or a lost machine the same command goes on.",
       "Options of smoothing and reading are those of balanced-flow-smooth. They are given to "
       "plan, or "
       "to run if it plans. --in-place, --normals, --dry-run and --output-format are for that "
       "program only. --threads, --quiet and --json are for all commands, and --jobs is for run."},
      {{"Commands",
        {{"plan",
          "sorts the points of the inputs, which are files or directories of files, into blocks in "
          "DIR."},
         {"smooth",
          "smooths one block, with all other points on which it depends. BLOCK is a number "
          "from 0 on. Blocks can be smoothed in any order and by any number of processes."},
         {"join", "writes each input with its smoothed points to DIR/smoothed, or to the "
                  "--output-dir of plan."},
         {"run", "does all that is not done yet."},
         {"status", "tells how many blocks there are, and how many are smoothed."}},
        {},
        true},
       {"Exit status",
        {{"0", "it is done."},
         {"1", "the command line is wrong; nothing was done."},
         {"2", "something could not be read, smoothed or written; what is done stays."},
         {"130, 143", "interrupted by Ctrl-C (SIGINT) or SIGTERM; what is done stays."}},
        {},
        true},
       {"Examples",
        {{"balanced-flow-blocks run --memory 4G work tiles/",
          "All of it; the result is in work/smoothed."},
         {"seq 0 99 | parallel balanced-flow-blocks smooth --quiet work",
          "Smooth the blocks 0 to 99 by GNU parallel."}},
        {},
        false}}};
}

} // namespace balanced_flow_blocks

#endif // BALANCED_FLOW_BLOCKS_MANUAL_H
