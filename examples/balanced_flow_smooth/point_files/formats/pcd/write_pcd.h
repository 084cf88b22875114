// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_FILES_PCD_WRITE_PCD_H
#define POINT_FILES_PCD_WRITE_PCD_H

#include "../../Point_file.h"

namespace point_files::pcd {

/// Writes the points of a file of another format as binary PCD. Colors of bytes become one field, as
/// users of PCD know them.
void write_pcd(const Target& target, const Point_file& file);

} // namespace point_files::pcd

#endif // POINT_FILES_PCD_WRITE_PCD_H
