// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_SMOOTH_MANUAL_H
#define BALANCED_FLOW_SMOOTH_MANUAL_H

#include "print_manual.h"

#include <string>
#include <utility>
#include <vector>

namespace balanced_flow_smooth {

// The words of --help and of the man page that are not about one option.

constexpr const char* program_name = "balanced-flow-smooth";

namespace manual {

constexpr const char* summary = "take the noise off 3D point sets";

// what comes after the name of the program
inline const std::vector<std::string> synopsis = {
    "[OPTION]... INPUT OUTPUT",       "[OPTION]... --output-dir DIR INPUT...",
    "[OPTION]... --in-place FILE...", "[OPTION]... --together --in-place|--output-dir DIR FILE...",
    "[OPTION]... --dry-run FILE",
};

inline const std::vector<std::string> description = {
    "Smooths the points of each INPUT by dynamic balanced flow and writes them to OUTPUT, to a "
    "file of the same name in DIR, or back to FILE. Noise, neighborhoods and all else that the "
    "method needs are found in the data. INPUT may be -, standard input, and OUTPUT may be -, "
    "standard output.",
    "In the same format, nothing changes in a file but coordinates and, where there are any, "
    "normals: all other bytes stay, as do the types of the numbers. A number that does not change "
    "keeps its bytes, too.",
    "The summary tells what share of the points moved, and why the others did not: they have no "
    "noise, they have fewer than two neighbors or are far from all others, or they lie on their "
    "surface already. With --json "
    "these are numbers of points: \"moved\", and in \"not_moved\" \"without_noise\", "
    "\"too_few_neighbors\", \"constrained\" and \"at_rest\". They add up to \"points\".",
    "With --together the files are scans of one scene, which must be registered: they are smoothed "
    "as one cloud in which each point knows its scan, so that layers of different scans come "
    "together. Each is written back in its own format; all of them are written, or none. The "
    "report "
    "tells of each file how its points moved, and of all \"together\" the rest. "
    "Normals, or the positions of scanners, keep the sides of walls apart that are in different "
    "scans.",
    "No input is written over, by outputs or reports and under any of its names, unless --in-place "
    "or the same name as INPUT and OUTPUT asks for it. "
    "An output is written beside its place and moved there when it is complete and on the disk, "
    "with the permissions of the file that it replaces. A file that fails is reported and left as "
    "it was, and the next one is taken.",
};

inline const std::vector<std::pair<std::string, std::string>> formats = {
    {"ply", "ASCII or binary of either byte order, with any properties, lists and elements."},
    {"xyz",
     "also txt, asc: text with a point in each line, between blanks, tabs, commas or semicolons, "
     "with anything else in further columns; empty lines, comments from # or // on, and lines with "
     "the number of the points that follow are kept."},
    {"csv", "the same; written with commas and a header."},
    {"pts", "the same; written with the number of points. Several scans, each with its number, "
            "are smoothed as with --together."},
    {"pwn", "also xyzn: the same; columns 4 to 6 are normals."},
    {"ptx",
     "scans as grids of points, with their headers; (0, 0, 0) is where the scanner saw nothing "
     "and stays. All scans are smoothed as with --together, and the positions of the scanners tell "
     "the sides of surfaces, as normals would. Normals can not be added."},
    {"pcd",
     "versions .5 to .7: ascii, binary and, if the program was built with liblzf, "
     "binary_compressed, with any fields. Organized clouds stay organized, and the position in "
     "VIEWPOINT is that of the scanner. Written from other formats as binary."},
    {"off", "text, also COFF, NOFF, STOFF and so on, with the faces."},
    {"las",
     "versions 1.0 to 1.4 with point formats 0 to 10: only the coordinates and the bounds in the "
     "header change, and these only if a point moves. Coordinates are rounded to the nearest "
     "that the scale of the file can hold; if one leaves its range, the file is not written. "
     "The points stay on the disk while they are smoothed; standard input is copied to a "
     "temporary file (TMPDIR). Normals can not be added."},
    {"laz",
     "the same, compressed, if the program was built with LASzip. COPC is read as LAZ; if a point "
     "moves, it is written as LAZ without the records of COPC."},
};

inline const std::vector<std::string> on_formats = {
    "The extension of a name tells the format. That of standard input is guessed from its first "
    "bytes, and standard output gets that of the input; --format and --output-format tell "
    "otherwise. From one format to another go the points, the normals and whatever are numbers of "
    "points (to OFF, PTS and PWN as columns without names); a warning tells what is lost.",
    "Columns of text are x, y, z and others, unless a header, which may be a comment, or --columns "
    "tells what they are. Columns are normals if they are called nx, ny, nz there, or Nx, "
    "normal_x, "
    "NormalX and so on, or if the format is pwn. The summary tells what was taken for what. "
    "Normals "
    "that are null vectors or not finite are not known, and stay; --normals fills them.",
    "Points whose coordinates are not finite are an error, except in PTX and in organized PCD, "
    "unless --invalid keeps them in their places or drops them. They are not counted as points in "
    "the report, but on their own.",
    "Lines end with LF, CR or both. Text in UTF-16 is refused.",
    "In PLY, integer coordinates are rounded, and integer normals keep their length; normals of "
    "unsigned integers stay as they are.",
};

inline const std::vector<std::pair<std::string, std::string>> exit_status = {
    {"0", "all files are written."},
    {"1", "the command line is wrong; nothing was done."},
    {"2", "at least one file could not be read, smoothed or written; the others are written, with "
          "--together none."},
    {"130, 143", "interrupted by Ctrl-C (SIGINT) or SIGTERM; the file at work is left as it was."},
};

inline const std::vector<std::pair<std::string, std::string>> examples = {
    {"balanced-flow-smooth scan.ply smoothed.ply", "Smooth one file."},
    {"balanced-flow-smooth --dry-run scan.ply",
     "Tell the spacing, the noise and what would be done."},
    {"balanced-flow-smooth --noise 0.003 scan.ply smoothed.ply",
     "Smooth a file whose noise is known: 3 mm, if the unit is 1 m."},
    {"balanced-flow-smooth --together --output-dir smoothed a.ply b.las c.ptx",
     "Smooth three scans of one scene as one cloud."},
    {"balanced-flow-smooth --in-place --json=report.json scans/*.ply",
     "Smooth many files where they are, with a report for programs."},
    {"zcat scan.ply.gz | balanced-flow-smooth - - | gzip > smoothed.ply.gz", "In a pipeline."},
    {"find . -name '*.xyz' -exec balanced-flow-smooth -q --in-place {} +",
     "All below a directory."},
};

/// All of it
inline Manual_page page()
{
  return {program_name,
          summary,
          synopsis,
          description,
          {{"Formats", formats, on_formats, true},
           {"Exit status", exit_status, {}, true},
           {"Examples", examples, {}, false}}};
}

} // namespace manual

} // namespace balanced_flow_smooth

#endif // BALANCED_FLOW_SMOOTH_MANUAL_H
