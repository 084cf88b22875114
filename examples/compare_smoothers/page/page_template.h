// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef COMPARISON_PAGE_TEMPLATE_H
#define COMPARISON_PAGE_TEMPLATE_H

#include <string>

namespace comparison {

/// The page without its data: HTML, styles and scripts of this folder, which the build turns into a
/// program text.
std::string page_template();

} // namespace comparison

#endif // COMPARISON_PAGE_TEMPLATE_H
