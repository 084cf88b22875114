# SPDX-License-Identifier: GPL-3.0-or-later
# Builds a project that takes in the source tree, uninstalled and offline, and sees that the package
# adds nothing to it that it did not ask for.
foreach(way IN ITEMS add_subdirectory FetchContent)
  set(build ${WORK_DIR}/${way})
  file(REMOVE_RECURSE ${build})
  execute_process(
    COMMAND ${CMAKE_COMMAND} -S ${CONSUMER_DIR}/source_tree -B ${build} -D WAY=${way}
            -D SOURCE_TREE=${SOURCE_TREE} -D FETCHCONTENT_FULLY_DISCONNECTED=ON
            -D CMAKE_CXX_COMPILER=${CXX} -D POINT_SET_FLOW_WITH_TBB=${WITH_TBB} -D CMAKE_INSTALL_PREFIX=${build}/prefix
    COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND ${CMAKE_COMMAND} --build ${build} COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND ${build}/consumer COMMAND_ERROR_IS_FATAL ANY)

  execute_process(COMMAND ${CMAKE_COMMAND} --install ${build} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
  if(EXISTS ${build}/prefix)
    message(FATAL_ERROR "${way}: the package is installed with its user's project")
  endif()
  execute_process(COMMAND ${CMAKE_CTEST_COMMAND} -N WORKING_DIRECTORY ${build} OUTPUT_VARIABLE tests)
  if(NOT tests MATCHES "Total Tests: 0")
    message(FATAL_ERROR "${way}: the package adds tests to its user's project: ${tests}")
  endif()
  file(READ ${build}/compile_commands.json commands)
  if(commands MATCHES " (-W[a-z]+|-O[0-9]|-g)")
    message(FATAL_ERROR "${way}: the package adds ${CMAKE_MATCH_1} to its user's flags")
  endif()
endforeach()
