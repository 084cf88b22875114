// SPDX-License-Identifier: GPL-3.0-or-later
#include "all_formats.h"

namespace point_files {

const std::vector<Format>& all_formats()
{
  static const std::vector<Format> table = {
      ply_format(), xyz_format(), csv_format(), pts_format(), pwn_format(),
      ptx_format(), off_format(), pcd_format(), las_format(), laz_format(),
  };
  return table;
}

} // namespace point_files
