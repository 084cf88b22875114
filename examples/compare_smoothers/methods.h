// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef COMPARISON_METHODS_H
#define COMPARISON_METHODS_H

#include "measure/Smoothers.h"

#include <functional>
#include <string>
#include <vector>

namespace comparison {

/// Short name (option --methods, file names), title, and call of a method
struct Named_method {
  std::string name, title;
  std::function<Smoothed(const Points&)> run;
};

/// In the order of the table
std::vector<Named_method> all_methods();

} // namespace comparison

#endif // COMPARISON_METHODS_H
