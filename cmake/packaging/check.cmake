# SPDX-License-Identifier: GPL-3.0-or-later
# Checks, offline, what can be checked of the packages that others build:
# cmake -D SOURCE_TREE=... -D WORK_DIR=... -D CXX=... -P check.cmake
cmake_minimum_required(VERSION 3.22)
set(packaging ${SOURCE_TREE}/cmake/packaging)

# One version everywhere; the Conan recipe reads it from CMakeLists.txt
file(READ ${SOURCE_TREE}/CMakeLists.txt text)
string(REGEX MATCH "project\\(PointSetFlow VERSION ([0-9.]+)" match "${text}")
set(version ${CMAKE_MATCH_1})
set(port ${packaging}/vcpkg/point-set-flow)
file(READ ${port}/vcpkg.json manifest)
string(JSON port_version GET "${manifest}" version)
file(STRINGS ${packaging}/debian/changelog debian_version LIMIT_COUNT 1)
if(NOT port_version STREQUAL version OR NOT debian_version MATCHES "^point-set-flow \\(${version}-")
  message(FATAL_ERROR "Version ${version}, but vcpkg.json has ${port_version} and debian/changelog ${debian_version}")
endif()

find_program(PYTHON python3)
if(PYTHON)
  foreach(recipe IN ITEMS conanfile.py test_package/conanfile.py)
    execute_process(COMMAND ${PYTHON} -c "import ast, sys; ast.parse(open(sys.argv[1]).read(), sys.argv[1])"
                            ${packaging}/conan/${recipe} COMMAND_ERROR_IS_FATAL ANY)
  endforeach()
endif()

# The port runs with stand-ins for vcpkg's functions, which do what matters of them here
function(vcpkg_check_features)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "OUT_FEATURE_OPTIONS" "FEATURES;INVERTED_FEATURES")
  set(options "")
  foreach(list IN ITEMS FEATURES INVERTED_FEATURES)
    while(arg_${list})
      list(POP_FRONT arg_${list} feature option)
      string(JSON description GET "${manifest}" features ${feature} description) # fails if there is none
      if((feature IN_LIST FEATURES AND list STREQUAL "FEATURES")
         OR (NOT feature IN_LIST FEATURES AND list STREQUAL "INVERTED_FEATURES"))
        set(value ON)
      else()
        set(value OFF)
      endif()
      list(APPEND options -D${option}=${value})
    endwhile()
  endforeach()
  set(${arg_OUT_FEATURE_OPTIONS} "${options}" PARENT_SCOPE)
endfunction()
function(vcpkg_cmake_configure)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "SOURCE_PATH" "OPTIONS;MAYBE_UNUSED_VARIABLES")
  execute_process(
    COMMAND ${CMAKE_COMMAND} -S ${arg_SOURCE_PATH} -B ${WORK_DIR}/build ${arg_OPTIONS} -D CMAKE_BUILD_TYPE=Release
            -D CMAKE_CXX_COMPILER=${CXX} -D CMAKE_INSTALL_PREFIX=${CURRENT_PACKAGES_DIR}
    OUTPUT_QUIET ERROR_VARIABLE messages COMMAND_ERROR_IS_FATAL ANY)
  foreach(name IN LISTS arg_MAYBE_UNUSED_VARIABLES)
    string(REPLACE "\n    ${name}\n" "\n" messages "${messages}")
  endforeach()
  if(messages MATCHES "not used by the project:[ \n]*([A-Z_]+)")
    message(FATAL_ERROR "The port sets what there is not: ${CMAKE_MATCH_1}")
  endif()
endfunction()
function(vcpkg_cmake_install)
  execute_process(COMMAND ${CMAKE_COMMAND} --build ${WORK_DIR}/build --target install OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
endfunction()
function(vcpkg_cmake_config_fixup) # moves nothing, as PACKAGE_NAME says where the files are
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "PACKAGE_NAME" "")
  if(NOT EXISTS ${CURRENT_PACKAGES_DIR}/share/${arg_PACKAGE_NAME}/${arg_PACKAGE_NAME}Config.cmake)
    message(FATAL_ERROR "The port finds no ${arg_PACKAGE_NAME}Config.cmake")
  endif()
endfunction()
function(vcpkg_fixup_pkgconfig)
endfunction()
function(vcpkg_install_copyright)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "" "FILE_LIST")
  file(COPY ${arg_FILE_LIST} DESTINATION ${CURRENT_PACKAGES_DIR}/share/${PORT})
endfunction()

file(REMOVE_RECURSE ${WORK_DIR})
set(PORT point-set-flow)
set(FEATURES core tbb)
set(CURRENT_PORT_DIR ${port})
set(CURRENT_PACKAGES_DIR ${WORK_DIR}/prefix)
include(${port}/portfile.cmake)
foreach(file IN ITEMS include/CGAL/balanced_flow_smooth_point_set.h share/pkgconfig/point-set-flow.pc
                      share/point-set-flow/usage share/point-set-flow/LICENSE)
  if(NOT EXISTS ${WORK_DIR}/prefix/${file})
    message(FATAL_ERROR "The port does not install ${file}")
  endif()
endforeach()
execute_process(
  COMMAND ${CMAKE_COMMAND} -S ${SOURCE_TREE}/test/packaging/consumer -B ${WORK_DIR}/consumer -D CMAKE_CXX_COMPILER=${CXX}
          -D CMAKE_PREFIX_PATH=${WORK_DIR}/prefix -D WITH_TBB=TRUE -D WITH_PROGRAM=FALSE
  OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
