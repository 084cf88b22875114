# SPDX-License-Identifier: GPL-3.0-or-later
# Installs the package into WORK_DIR and builds and runs the consumer project against it.
file(REMOVE_RECURSE ${WORK_DIR})
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${WORK_DIR}/prefix
                COMMAND_ERROR_IS_FATAL ANY)
execute_process(
  COMMAND ${CMAKE_COMMAND} -S ${CONSUMER_DIR} -B ${WORK_DIR}/build -D CMAKE_PREFIX_PATH=${WORK_DIR}/prefix
          -D CMAKE_CXX_COMPILER=${CXX} -D CMAKE_BUILD_TYPE=${BUILD_TYPE} -D BALANCED_FLOW_WITH_TBB=${WITH_TBB}
  COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --build ${WORK_DIR}/build COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${WORK_DIR}/build/consumer COMMAND_ERROR_IS_FATAL ANY)

# What can not work is refused, and the compiler says why
function(check_refused flags expected)
  execute_process(
    COMMAND ${CXX} -std=c++17 ${flags} -E -I ${WORK_DIR}/prefix/include -o ${WORK_DIR}/refused.i
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
