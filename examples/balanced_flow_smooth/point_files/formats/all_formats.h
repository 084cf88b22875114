// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_FILES_ALL_FORMATS_H
#define POINT_FILES_ALL_FORMATS_H

#include "../Format.h"

namespace point_files {

// Each is defined in the file of its name. A new format gets such a file, a function here, a line in
// the table of all_formats.cpp, and its words for users in command_line/Manual.h.

Format ply_format();
Format xyz_format();
Format csv_format(); // this and the next two with xyz_format()
Format pts_format();
Format pwn_format();
Format ptx_format();
Format off_format();
Format pcd_format();
Format las_format();
Format laz_format(); // with las_format()

} // namespace point_files

#endif // POINT_FILES_ALL_FORMATS_H
