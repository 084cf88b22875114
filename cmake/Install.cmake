# SPDX-License-Identifier: GPL-3.0-or-later
# After the folder of the program, which says whether it has PDAL
include(CMakePackageConfigHelpers)
set(BALANCED_FLOW_CONFIG_DIR ${CMAKE_INSTALL_DATADIR}/cmake/BalancedFlow CACHE STRING
    "Where BalancedFlowConfig.cmake is installed, below the prefix")
mark_as_advanced(BALANCED_FLOW_CONFIG_DIR)
set(balanced_flow_pc_dir ${CMAKE_INSTALL_DATADIR}/pkgconfig)

set(balanced_flow_program_has_pdal FALSE)
if(TARGET balanced-flow-smooth)
  get_target_property(definitions balanced-flow-smooth COMPILE_DEFINITIONS)
  if(BALANCED_FLOW_WITH_PDAL IN_LIST definitions)
    set(balanced_flow_program_has_pdal TRUE)
  endif()
endif()

install(DIRECTORY include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.h")
install(TARGETS balanced_flow EXPORT BalancedFlowTargets INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT BalancedFlowTargets NAMESPACE BalancedFlow:: DESTINATION ${BALANCED_FLOW_CONFIG_DIR})
configure_package_config_file(cmake/BalancedFlowConfig.cmake.in BalancedFlowConfig.cmake
                              INSTALL_DESTINATION ${BALANCED_FLOW_CONFIG_DIR} PATH_VARS CMAKE_INSTALL_BINDIR)
write_basic_package_version_file(BalancedFlowConfigVersion.cmake COMPATIBILITY SameMinorVersion
                                 ARCH_INDEPENDENT)
install(FILES ${PROJECT_BINARY_DIR}/BalancedFlowConfig.cmake
              ${PROJECT_BINARY_DIR}/BalancedFlowConfigVersion.cmake
              cmake/BalancedFlowDependencies.cmake
        DESTINATION ${BALANCED_FLOW_CONFIG_DIR})

# pkg-config: what CGAL's targets add, as CGAL has no file of its own
list(TRANSFORM BALANCED_FLOW_DEFINITIONS PREPEND "-D" OUTPUT_VARIABLE balanced_flow_pc_cflags)
list(JOIN balanced_flow_pc_cflags " " balanced_flow_pc_cflags)
set(balanced_flow_pc_tbb "")
if(TBB::tbb IN_LIST BALANCED_FLOW_DEPENDENCIES)
  set(balanced_flow_pc_tbb " tbb")
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  string(APPEND balanced_flow_pc_cflags " -frounding-math")
endif()
foreach(dir IN LISTS CGAL_INCLUDE_DIRS)
  cmake_path(NORMAL_PATH dir)
  if(NOT dir IN_LIST CMAKE_CXX_IMPLICIT_INCLUDE_DIRECTORIES)
    string(APPEND balanced_flow_pc_cflags " -I${dir}")
  endif()
endforeach()
foreach(name IN ITEMS PREFIX FULL_INCLUDEDIR)
  cmake_path(RELATIVE_PATH CMAKE_INSTALL_${name} BASE_DIRECTORY ${CMAKE_INSTALL_FULL_DATADIR}/pkgconfig
             OUTPUT_VARIABLE balanced_flow_pc_to_${name})
endforeach()
configure_file(cmake/balanced-flow.pc.in balanced-flow.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/balanced-flow.pc DESTINATION ${balanced_flow_pc_dir})
