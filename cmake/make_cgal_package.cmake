# SPDX-License-Identifier: GPL-3.0-or-later
# Writes the package Point_set_flow as it would be in CGAL's own tree, and what the lists of CGAL must say of it:
#   cmake -D OUT=directory [-D CGAL_INCLUDE_DIR=/usr/include] [-D NAME=value ...] -P cmake/make_cgal_package.cmake
# Code is copied as it is, with CGAL's heading in place of our first line. What is different inside of CGAL is
# made from the templates in cmake/cgal_package. See doc/cgal_submission.md.
cmake_minimum_required(VERSION 3.22)

# What only those who submit can say
set(COPYRIGHT "The authors of Point Set Flow" CACHE STRING "holder of the copyright")
set(AUTHORS "The authors of Point Set Flow" CACHE STRING "")
set(MAINTAINER "The authors of Point Set Flow" CACHE STRING "maintainer with an address")
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
file(REMOVE_RECURSE ${package} ${OUT}/lists ${OUT}/point_set_flow.patch)

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

# The text of a file after its first line, which is our license
function(read_without_license file variable)
  file(READ ${file} text)
  if(NOT text MATCHES "^[^\n]*SPDX-License-Identifier: GPL-3.0-or-later\n")
    message(FATAL_ERROR "make_cgal_package.cmake: the first line of ${file} is not its license")
  endif()
  string(LENGTH "${CMAKE_MATCH_0}" begin)
  string(SUBSTRING "${text}" ${begin} -1 text)
  set(${variable} "${text}" PARENT_SCOPE)
endfunction()

function(copy_source from to)
  read_without_license(${root}/${from} text)
  file(WRITE ${package}/${to} "${cgal_heading}${text}")
endfunction()

# ARGN: what to begin with
function(fill_template from to)
  read_without_license(${templates}/${from} text)
  string(CONFIGURE "${text}" text @ONLY)
  file(WRITE ${package}/${to} "${ARGN}${text}")
endfunction()

# Texts mark what does not hold inside of CGAL's tree by <!-- only here --> and <!-- end -->
function(drop_only_here variable)
  set(text "${${variable}}")
  string(FIND "${text}" "<!-- only here -->" begin)
  while(NOT begin EQUAL -1)
    string(SUBSTRING "${text}" 0 ${begin} before)
    string(SUBSTRING "${text}" ${begin} -1 text)
    string(FIND "${text}" "<!-- end -->" end)
    if(end EQUAL -1)
      message(FATAL_ERROR "make_cgal_package.cmake: <!-- only here --> without <!-- end -->: ${text}")
    endif()
    math(EXPR end "${end} + 12")
    string(SUBSTRING "${text}" ${end} -1 text)
    string(APPEND before "${text}")
    set(text "${before}")
    string(FIND "${text}" "<!-- only here -->" begin)
  endwhile()
  set(${variable} "${text}" PARENT_SCOPE)
endfunction()

function(find_sources variable)
  file(GLOB_RECURSE found RELATIVE ${root} ${ARGN})
  set(${variable} ${found} PARENT_SCOPE)
endfunction()

# ---- include, examples, test

find_sources(headers ${root}/include/*.h)
# What CGAL has in lists: that of the licenses, of which it generates a header, and that of the named parameters
list(REMOVE_ITEM headers include/CGAL/license/Point_set_flow.h include/CGAL/Point_set_flow/parameters.h)
foreach(header IN LISTS headers)
  copy_source(${header} ${header})
endforeach()
fill_template(parameters.h.in include/CGAL/Point_set_flow/parameters.h "${cgal_heading}")

function(write_programs KIND directory)
  list(TRANSFORM ARGN REPLACE "(.+)" "  \\1\n" OUTPUT_VARIABLE PROGRAMS)
  list(JOIN PROGRAMS "" PROGRAMS)
  set(BOOST_TEST "")
  if(KIND STREQUAL "Tests")
    read_without_license(${templates}/find_boost_test.cmake BOOST_TEST)
  endif()
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
file(GLOB test_files RELATIVE ${root} ${root}/test/unit/*.cpp ${root}/test/contract/*.cpp ${root}/test/contract/*.h
  ${root}/test/support/*.h)
foreach(file IN LISTS test_files)
  get_filename_component(name ${file} NAME) # their tests are all in one folder
  copy_source(${file} test/Point_set_flow/${name})
  if(name MATCHES "(.*)\\.cpp$")
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

# The user manual is doc/manual.md, in CGAL's commands and without what is only said outside
file(READ ${root}/doc/manual.md text)
drop_only_here(text)
file(WRITE ${OUT}/manual.md "${text}")
execute_process(COMMAND sed -f ${root}/doc/markdown.sed ${OUT}/manual.md COMMAND sed -f ${templates}/manual.sed
                OUTPUT_VARIABLE MANUAL COMMAND_ERROR_IS_FATAL ANY)
file(REMOVE ${OUT}/manual.md)
string(REGEX REPLACE "\n\n\n+" "\n\n" MANUAL "${MANUAL}")
# left: a link to a file or a place in one, the end of the comment, a section without a name, a group of ours
if(MANUAL MATCHES "[^\n]*(\\]\\([a-zA-Z_./-]*(\\.[a-z]+\\)|#)|\\*/|\n##+ |PkgPointSetFlowParameters)[^\n]*")
  message(FATAL_ERROR "make_cgal_package.cmake: doc/manual.md has what is not inside of CGAL and must be between \
<!-- only here --> and <!-- end -->: ${CMAKE_MATCH_0}")
endif()
fill_template(manual.txt.in doc/Point_set_flow/Point_set_flow.txt)

set(PACKAGE_NAME PkgPointSetFlow)
set(PACKAGE_PICTURE "\\cgalPkgPicture{point_set_flow.png}\n")
set(PACKAGE_AUTHORS "${AUTHORS}")
set(USER_MANUAL Chapter_Point_Set_Flow)
set(PACKAGE_SINCE "\\cgal ${SINCE}")
set(PACKAGE_DEPENDS_ON "\\ref PkgSpatialSearchingD")
set(PACKAGE_BIB "cgal:psf")
set(PACKAGE_LICENSE "\\ref licensesGPL \"GPL\"")
read_without_license(${root}/doc/PackageDescription.txt.in text)
drop_only_here(text)
string(CONFIGURE "${text}" text @ONLY)
file(WRITE ${package}/doc/Point_set_flow/PackageDescription.txt "${text}")
file(COPY_FILE ${root}/doc/bibliography.bib ${OUT}/cgal_manual.bib.add)
file(MAKE_DIRECTORY ${package}/doc/Point_set_flow/fig)
file(COPY_FILE ${root}/doc/fig/pipelines_surfaces.png ${package}/doc/Point_set_flow/fig/point_set_flow.png)
file(WRITE ${package}/doc/Point_set_flow/Doxyfile.in "@INCLUDE = \${CGAL_DOC_PACKAGE_DEFAULTS}

PROJECT_NAME = \"CGAL \${CGAL_DOC_VERSION} - Point Set Flow\"
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

file(WRITE ${package}/package_info/Point_set_flow/copyright "${COPYRIGHT}\n")
file(WRITE ${package}/package_info/Point_set_flow/license.txt "GPL (v3 or later)\n")
file(WRITE ${package}/package_info/Point_set_flow/maintainer "${MAINTAINER}\n")
file(WRITE ${package}/package_info/Point_set_flow/description.txt "Point Set Flow: smoothing of 3D point sets\n")
file(WRITE ${package}/package_info/Point_set_flow/long_description.txt
"This package denoises 3D point sets by the dynamic balanced flow of Xiao, Miao, Liu and Peng. It preserves
sharp features, hardly shrinks curved surfaces, needs no normals, and estimates the noise, the neighborhoods
and the thin parts from the data.
")
fill_template(dependencies.txt package_info/Point_set_flow/dependencies)

# ---- the lists of CGAL

# Writes the list of CGAL with new lines after the line `after`, and appends what changes to the patch
function(patch_list cgal_package file after new_lines)
  file(READ ${CGAL_INCLUDE_DIR}/${file} text)
  string(FIND "${text}" "${after}" found)
  if("${after}" STREQUAL "" OR found EQUAL -1)
    message(FATAL_ERROR "make_cgal_package.cmake: there is no line in ${file} any more to insert after")
  endif()
  string(REPLACE "${after}" "${after}${new_lines}" text "${text}")
  file(WRITE ${OUT}/lists/${file} "${text}")
  set(path ${cgal_package}/include/${file})
  execute_process(COMMAND diff -u ${CGAL_INCLUDE_DIR}/${file} ${OUT}/lists/${file} --label a/${path} --label b/${path}
                  OUTPUT_VARIABLE patch RESULT_VARIABLE result)
  if(NOT result EQUAL 1)
    message(FATAL_ERROR "make_cgal_package.cmake: diff of ${file} failed: ${result}")
  endif()
  file(APPEND ${OUT}/point_set_flow.patch "${patch}")
endfunction()

file(READ ${root}/include/CGAL/Point_set_flow/parameters.h text)
string(REGEX MATCHALL "DEFINE\\([a-z_]+\\)" names "${text}")
if(NOT names)
  message(FATAL_ERROR "make_cgal_package.cmake: no DEFINE(name) in parameters.h any more")
endif()
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
string(REGEX MATCH "[^\n]*Point_set_3 [^\n]*\n" after "${text}")
patch_list(Installation CGAL/license/gpl_package_list.txt "${after}" "Point_set_flow Point Set Flow\n")

list(LENGTH headers headers)
list(LENGTH examples examples)
list(LENGTH tests tests)
message(STATUS "${package}: ${headers} headers, ${examples} examples, ${tests} tests")
