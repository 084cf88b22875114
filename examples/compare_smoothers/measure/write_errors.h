// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef COMPARISON_WRITE_ERRORS_H
#define COMPARISON_WRITE_ERRORS_H

#include "Surface.h"

#include <string>
#include <vector>

namespace comparison {

/// Writes points as PLY with their signed errors as numbers and as colors: blue for -`range` and
/// less, inside, over white to red.
bool write_errors(const std::string& file, const Points& points, const std::vector<double>& errors,
                  double range);

} // namespace comparison

#endif // COMPARISON_WRITE_ERRORS_H
