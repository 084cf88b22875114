# SPDX-License-Identifier: GPL-3.0-or-later
# Builds and runs a project that finds the installed package, in two translation units.
set(build ${WORK_DIR}/find_package)
file(REMOVE_RECURSE ${build})
execute_process(
  COMMAND ${CMAKE_COMMAND} -S ${CONSUMER_DIR} -B ${build} -D CMAKE_PREFIX_PATH=${WORK_DIR}/prefix
          -D CMAKE_CXX_COMPILER=${CXX} -D CMAKE_BUILD_TYPE=${BUILD_TYPE} -D WITH_TBB=${WITH_TBB}
          -D WITH_PROGRAM=${WITH_PROGRAM} -D WITH_PDAL=${WITH_PDAL}
  COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --build ${build} --parallel 2 COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${build}/consumer COMMAND_ERROR_IS_FATAL ANY)

# -ffast-math is refused, and the compiler says why
execute_process(
  COMMAND ${CXX} -std=c++17 -ffast-math -E -I ${WORK_DIR}/prefix/include -o ${build}/fast_math.i
          ${CONSUMER_DIR}/main.cpp
  RESULT_VARIABLE result ERROR_VARIABLE message OUTPUT_QUIET)
if(result EQUAL 0 OR NOT message MATCHES "must not be compiled with -ffast-math")
  message(FATAL_ERROR "-ffast-math is not refused: ${message}")
endif()
