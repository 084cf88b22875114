# SPDX-License-Identifier: GPL-3.0-or-later
# Turns the page, with its styles and scripts in place, into a program text that returns it.
# Bytes as numbers: compilers have limits for string literals, and raw ones an end of their own.
set(page_dir ${CMAKE_CURRENT_LIST_DIR})
set(page_parts page.css data.js colors.js Camera.js Renderer.js controls.js numbers.js page.js)
set(COMPARISON_DATA "@COMPARISON_DATA@") # left for the program
set(PAGE_STYLES "")
set(PAGE_SCRIPTS "")
foreach(part IN LISTS page_parts)
  file(READ ${page_dir}/${part} text)
  if(part MATCHES "css$")
    string(APPEND PAGE_STYLES "${text}")
  else()
    string(APPEND PAGE_SCRIPTS "${text}")
  endif()
endforeach()
set(page_file ${CMAKE_CURRENT_BINARY_DIR}/comparison_page.html)
configure_file(${page_dir}/page.html.in ${page_file} @ONLY)
file(READ ${page_file} page HEX)
string(LENGTH "${page}" page_size)
math(EXPR page_size "${page_size} / 2")
string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," page "${page}")
file(CONFIGURE OUTPUT page_template.cpp @ONLY CONTENT
"// Made by embed.cmake. SPDX-License-Identifier: GPL-3.0-or-later
#include \"page/page_template.h\"
static const unsigned char page[@page_size@] = {@page@};
std::string comparison::page_template() { return std::string(page, page + @page_size@); }
")
list(TRANSFORM page_parts PREPEND ${page_dir}/)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${page_parts} ${page_dir}/page.html.in)
