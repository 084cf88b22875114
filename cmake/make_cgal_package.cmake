# SPDX-License-Identifier: GPL-3.0-or-later
# Makes of this project the package Point_set_flow as it would stand in CGAL's own tree, and a patch
# for the lists of CGAL that name it:
#   cmake -D OUT=directory [-D CGAL_INCLUDE_DIR=/usr/include] [-D NAME=value ...] -P cmake/make_cgal_package.cmake
# Copy what is in OUT over a clone of CGAL, and there: patch -p1 < point_set_flow.patch
# See doc/cgal_submission.md.

# What only those who submit can say
set(COPYRIGHT "The authors of Point_set_flow" CACHE STRING "holder of the copyright")
set(AUTHORS "The authors of Point_set_flow" CACHE STRING "")
set(MAINTAINER "The authors of Point_set_flow" CACHE STRING "maintainer with an address")
set(YEAR 2026 CACHE STRING "of the copyright")
set(SINCE 6.3 CACHE STRING "the release of CGAL that will be the first with it")
set(CGAL_INCLUDE_DIR /usr/include CACHE STRING "where CGAL is whose lists are patched")
if(NOT OUT OR NOT EXISTS ${CGAL_INCLUDE_DIR}/CGAL/license/gpl_package_list.txt)
  message(FATAL_ERROR "usage: cmake -D OUT=directory [-D CGAL_INCLUDE_DIR=directory with CGAL] -P make_cgal_package.cmake")
endif()
get_filename_component(OUT ${OUT} ABSOLUTE)
get_filename_component(root ${CMAKE_CURRENT_LIST_DIR} DIRECTORY)
set(templates ${CMAKE_CURRENT_LIST_DIR}/cgal_package)
set(package ${OUT}/Point_set_flow)
file(REMOVE_RECURSE ${package} ${OUT}/Installation ${OUT}/point_set_flow.patch)

set(spdx "// SPDX-License-Identifier: GPL-3.0-or-later\n")
set(cgal_heading "// Copyright (c) ${YEAR} ${COPYRIGHT}.
// All rights reserved.
//
// This file is part of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : ${AUTHORS}

")

# Replaces what has to be there: who changes it there is told that it has to be changed here
function(replace_once variable what by)
  string(FIND "${${variable}}" "${what}" found)
  if(found EQUAL -1)
    message(FATAL_ERROR "make_cgal_package.cmake: there is no \"${what}\" any more")
  endif()
  string(REPLACE "${what}" "${by}" replaced "${${variable}}")
  set(${variable} "${replaced}" PARENT_SCOPE)
endfunction()

# A source file with CGAL's heading and, if it is a header, the check of its license
function(copy_source from to)
  file(READ ${root}/${from} text)
  replace_once(text "${spdx}" "${cgal_heading}")
  if(from MATCHES "^include/")
    string(REGEX REPLACE "(#define CGAL_[A-Z0-9_]+_H\n)" "\\1\n#include <CGAL/license/Point_set_flow.h>\n" text "${text}")
  endif()
  # named parameters are in CGAL's own list
  string(REPLACE "#include <CGAL/Point_set_flow/parameters.h>" "#include <CGAL/Named_function_parameters.h>" text "${text}")
  # CGAL's tests link with no library of Boost
  string(REPLACE "#include <boost/test/unit_test.hpp>" "#include <boost/test/included/unit_test.hpp>" text "${text}")
  if(from STREQUAL "include/CGAL/balanced_flow_smooth_point_set.h")
    replace_once(text " Those of this package, from `flow` on, must come first." "")
  endif()
  file(WRITE ${package}/${to} "${text}")
endfunction()

# A template, whose first line is our license
function(fill_template from to)
  file(READ ${templates}/${from} text)
  string(REGEX REPLACE "^[^\n]*SPDX[^\n]*\n" "" text "${text}")
  string(CONFIGURE "${text}" text @ONLY)
  file(WRITE ${package}/${to} "${text}")
endfunction()

function(find_sources variable)
  file(GLOB_RECURSE found RELATIVE ${root} ${ARGN})
  set(${variable} ${found} PARENT_SCOPE)
endfunction()

# ---- include, examples, test

find_sources(headers ${root}/include/*.h)
list(REMOVE_ITEM headers include/CGAL/Point_set_flow/parameters.h)
foreach(header IN LISTS headers)
  copy_source(${header} ${header})
endforeach()

function(write_programs KIND directory)
  list(TRANSFORM ARGN REPLACE "(.+)" "  \\1\n" OUTPUT_VARIABLE PROGRAMS)
  list(JOIN PROGRAMS "" PROGRAMS)
  fill_template(CMakeLists.txt.in ${directory}/Point_set_flow/CMakeLists.txt)
endfunction()

file(GLOB examples RELATIVE ${root}/examples ${root}/examples/*_example.cpp)
foreach(example IN LISTS examples)
  copy_source(examples/${example} examples/Point_set_flow/${example})
endforeach()
list(TRANSFORM examples REPLACE "\\.cpp$" "")
write_programs(Examples examples ${examples})

# all tests that need nothing but the headers of the package and of the tests
set(tests test_named_parameters)
copy_source(cmake/cgal_package/test_named_parameters.cpp test/Point_set_flow/test_named_parameters.cpp)
file(GLOB test_files RELATIVE ${root}/test ${root}/test/*.cpp ${root}/test/*.h)
foreach(file IN LISTS test_files)
  file(READ ${root}/test/${file} text)
  if(text MATCHES "#include \"comparison/")
    continue()
  endif()
  copy_source(test/${file} test/Point_set_flow/${file})
  if(file MATCHES "(.*)\\.cpp$")
    list(APPEND tests ${CMAKE_MATCH_1})
  endif()
endforeach()
write_programs(Tests test ${tests})

# ---- doc

find_sources(concepts ${root}/doc/Concepts/*.h)
foreach(concept IN LISTS concepts)
  get_filename_component(name ${concept} NAME)
  copy_source(${concept} doc/Point_set_flow/Concepts/${name})
endforeach()
fill_template(Point_set_flow.txt doc/Point_set_flow/Point_set_flow.txt)

# What is said of the package, but for what is different inside of CGAL
file(READ ${root}/doc/PackageDescription.txt text)
replace_once(text "// SPDX-License-Identifier: GPL-3.0-or-later\n" "")
function(replace_command command by)
  if(NOT text MATCHES "\n\\\\${command}{[^\n]*}\n")
    message(FATAL_ERROR "make_cgal_package.cmake: there is no line \\${command} in PackageDescription.txt any more")
  endif()
  string(REGEX REPLACE "\n\\\\${command}{[^\n]*}\n" "\n\\\\${command}{${by}}\n" text "${text}")
  set(text "${text}" PARENT_SCOPE)
endfunction()
replace_command(cgalPkgAuthors "${AUTHORS}")
replace_command(cgalPkgManuals "Chapter_Point_Set_Flow_Smoothing,PkgPointSetFlowRef")
replace_command(cgalPkgSince "${SINCE}")
replace_command(cgalPkgDependsOn "\\\\ref PkgSpatialSearchingD")
replace_command(cgalPkgBib "cgal:bfs")
replace_command(cgalPkgLicense "\\\\ref licensesGPL \"GPL\"")
replace_once(text "{Balanced Flow Smoothing,PkgPointSetFlowRef}" "{Balanced Flow Smoothing,PkgPointSetFlow}\n\\cgalPkgPicture{point_set_flow.png}")
replace_once(text "/// \\defgroup PkgPointSetFlowParameters Named Parameters\n/// \\ingroup PkgPointSetFlowRef\n" "")
replace_once(text "\\cgalCRPSection{Named Parameters}\n- \\ref PkgPointSetFlowParameters \"those of this package\"\n\n" "")
string(REGEX REPLACE "\n/// .namespace CGAL(::parameters|::Scale_space_reconstruction_3)?\n///[^\n]*\n" "" text "${text}") # CGAL has them
file(WRITE ${package}/doc/Point_set_flow/PackageDescription.txt "${text}")
file(COPY_FILE ${root}/doc/bibliography.bib ${OUT}/cgal_manual.bib.add)
file(MAKE_DIRECTORY ${package}/doc/Point_set_flow/fig)
file(COPY_FILE ${root}/doc/fig/pipelines_surfaces.png ${package}/doc/Point_set_flow/fig/point_set_flow.png)
file(WRITE ${package}/doc/Point_set_flow/Doxyfile.in "@INCLUDE = \${CGAL_DOC_PACKAGE_DEFAULTS}

PROJECT_NAME = \"CGAL \${CGAL_DOC_VERSION} - Balanced Flow Smoothing\"
EXTRACT_ALL = NO
HIDE_UNDOC_CLASSES = YES
HIDE_UNDOC_MEMBERS = YES
")
file(WRITE ${package}/doc/Point_set_flow/dependencies "Manual
Kernel_23
STL_Extension
Property_map
Spatial_searching
Point_set_3
Point_set_processing_3
Scale_space_reconstruction_3
Poisson_surface_reconstruction_3
Advancing_front_surface_reconstruction
Shape_detection
")
list(TRANSFORM examples REPLACE "(.+)" "\\\\example Point_set_flow/\\1.cpp\n" OUTPUT_VARIABLE listed)
list(JOIN listed "" listed)
file(WRITE ${package}/doc/Point_set_flow/examples.txt "/*!\n${listed}*/\n")

# ---- package_info

set(summary "It takes the noise off 3D point sets by the dynamic balanced flow of Xiao, Miao, Liu and Peng.\n")
file(WRITE ${package}/package_info/Point_set_flow/copyright "${COPYRIGHT}\n")
file(WRITE ${package}/package_info/Point_set_flow/license.txt "GPL (v3 or later)\n")
file(WRITE ${package}/package_info/Point_set_flow/maintainer "${MAINTAINER}\n")
file(WRITE ${package}/package_info/Point_set_flow/description.txt "Balanced Flow Smoothing: smoothing of 3D point sets\n")
file(WRITE ${package}/package_info/Point_set_flow/long_description.txt
"This package takes the noise off 3D point sets by the dynamic balanced flow of Xiao, Miao, Liu and
Peng. It keeps sharp features, hardly shrinks what is curved, needs no normals, and finds the noise,
the neighborhoods and the thin parts in the data.
")
fill_template(dependencies.txt package_info/Point_set_flow/dependencies)

# ---- what CGAL generates or lists

# CGAL's own generator makes the check of the license for each line of its list; it differs from
# that of another package by the names only
file(READ ${CGAL_INCLUDE_DIR}/CGAL/license/Point_set_processing_3.h text)
replace_once(text "POINT_SET_PROCESSING_3" "BALANCED_FLOW")
replace_once(text "Point_set_processing_3" "Point_set_flow")
replace_once(text "Point Set Processing" "Balanced Flow Smoothing")
string(REGEX REPLACE "\\$(URL|Id): [^\n]*\\$" "$\\1$" text "${text}")
file(WRITE ${OUT}/Installation/include/CGAL/license/Point_set_flow.h "${text}")

# The patch for a file of CGAL: `after` is the line that the new lines follow
function(patch_list cgal_package file after new_lines)
  file(READ ${CGAL_INCLUDE_DIR}/${file} text)
  set(path ${cgal_package}/include/${file})
  file(WRITE ${OUT}/patched/a/${path} "${text}")
  replace_once(text "${after}" "${after}${new_lines}")
  file(WRITE ${OUT}/patched/b/${path} "${text}")
  execute_process(COMMAND diff -u a/${path} b/${path} --label a/${path} --label b/${path}
                  WORKING_DIRECTORY ${OUT}/patched OUTPUT_VARIABLE patch RESULT_VARIABLE result)
  if(NOT result EQUAL 1)
    message(FATAL_ERROR "make_cgal_package.cmake: diff of ${file} failed: ${result}")
  endif()
  file(APPEND ${OUT}/point_set_flow.patch "${patch}")
endfunction()

file(READ ${root}/include/CGAL/Point_set_flow/parameters.h text)
string(REGEX MATCHALL "DEFINE\\([a-z_]+\\)" names "${text}")
set(list STL_Extension/internal/parameters_interface.h)
file(READ ${CGAL_INCLUDE_DIR}/CGAL/${list} cgal_list)
set(new_lines "\n// List of named parameters used in Point_set_flow\n")
foreach(name IN LISTS names)
  string(REGEX REPLACE "DEFINE\\((.*)\\)" "\\1" name "${name}")
  if(cgal_list MATCHES "[(, ]${name}[,)]")
    message(STATUS "CGAL has a named parameter ${name} already")
  else()
    string(APPEND new_lines "CGAL_add_named_parameter(${name}_t, ${name}, ${name})\n")
  endif()
endforeach()
string(REGEX MATCH "CGAL_add_named_parameter\\(neighbor_radius_t[^\n]*\n([^\n]+\n)*" after "${cgal_list}")
patch_list(STL_Extension CGAL/${list} "${after}" "${new_lines}")

file(READ ${CGAL_INCLUDE_DIR}/CGAL/license/gpl_package_list.txt text)
string(REGEX MATCH "[^\n]*Arrangement_on_surface_2 [^\n]*\n" after "${text}")
patch_list(Installation CGAL/license/gpl_package_list.txt "${after}" "Point_set_flow Balanced Flow Smoothing\n")
file(REMOVE_RECURSE ${OUT}/patched)

list(LENGTH headers headers)
list(LENGTH examples examples)
list(LENGTH tests tests)
message(STATUS "${package}: ${headers} headers, ${examples} examples, ${tests} tests")
