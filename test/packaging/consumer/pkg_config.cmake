# SPDX-License-Identifier: GPL-3.0-or-later
# Compiles and runs an example with nothing but what pkg-config says of the installed package.
set(work ${WORK_DIR}/pkg_config)
file(REMOVE_RECURSE ${work})
file(MAKE_DIRECTORY ${work})
set(ENV{PKG_CONFIG_PATH} ${WORK_DIR}/prefix/share/pkgconfig)

execute_process(COMMAND ${PKG_CONFIG} --cflags --libs point-set-flow
                OUTPUT_VARIABLE flags OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
separate_arguments(flags UNIX_COMMAND "${flags}")
execute_process(COMMAND ${CXX} -std=c++17 ${EXAMPLE} ${flags} -o ${work}/example COMMAND_ERROR_IS_FATAL ANY)

set(points "")
foreach(i RANGE 399)
  math(EXPR x "${i} / 20")
  math(EXPR y "${i} % 20")
  math(EXPR z "${i} * ${i} % 7")
  string(APPEND points "${x} ${y} 0.${z}\n")
endforeach()
file(WRITE ${work}/points.xyz "${points}")
execute_process(COMMAND ${work}/example points.xyz WORKING_DIRECTORY ${work} COMMAND_ERROR_IS_FATAL ANY)
file(STRINGS ${work}/smoothed.xyz smoothed)
list(LENGTH smoothed number_of_points)
if(NOT number_of_points EQUAL 400)
  message(FATAL_ERROR "${number_of_points} of 400 points were written")
endif()

execute_process(COMMAND ${PKG_CONFIG} --exists "point-set-flow >= 0.2" RESULT_VARIABLE result)
if(result EQUAL 0)
  message(FATAL_ERROR "pkg-config finds a version that is not installed")
endif()
