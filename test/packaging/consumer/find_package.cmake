# SPDX-License-Identifier: GPL-3.0-or-later
# Builds and runs a project that finds the installed package, in two translation units.
set(build ${WORK_DIR}/find_package)
file(REMOVE_RECURSE ${build})
execute_process(
  COMMAND ${CMAKE_COMMAND} -S ${CONSUMER_DIR} -B ${build} -D CMAKE_PREFIX_PATH=${WORK_DIR}/prefix
          -D CMAKE_CXX_COMPILER=${CXX} -D CMAKE_BUILD_TYPE=${BUILD_TYPE} -D WITH_TBB=${WITH_TBB}
          -D WITH_PROGRAM=${WITH_PROGRAM} -D WITH_LAZ=${WITH_LAZ}
  COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --build ${build} --parallel 2 COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${build}/consumer COMMAND_ERROR_IS_FATAL ANY)

# What can not work is refused, and the compiler says why
function(check_refused flags expected)
  execute_process(
    COMMAND ${CXX} -std=c++17 ${flags} -E -I ${WORK_DIR}/prefix/include -o ${build}/refused.i
            ${CONSUMER_DIR}/main.cpp
    RESULT_VARIABLE result ERROR_VARIABLE message OUTPUT_QUIET)
  if(result EQUAL 0 OR NOT message MATCHES "${expected}")
    message(FATAL_ERROR "${flags} is not refused: ${message}")
  endif()
endfunction()
check_refused(-ffast-math "must not be compiled with -ffast-math")
check_refused(-Ofast "must not be compiled with -ffast-math")
check_refused(-ffinite-math-only "must not be compiled with -ffast-math")
check_refused(-DWITHOUT_EIGEN "needs Eigen") # its folder is not among those of the includes
