# SPDX-License-Identifier: GPL-3.0-or-later
# After the folder of the program, which says whether it has LASzip
include(CMakePackageConfigHelpers)
set(POINT_SET_FLOW_CONFIG_DIR ${CMAKE_INSTALL_DATADIR}/cmake/PointSetFlow CACHE STRING
    "Where PointSetFlowConfig.cmake is installed, below the prefix")
mark_as_advanced(POINT_SET_FLOW_CONFIG_DIR)
set(point_set_flow_pc_dir ${CMAKE_INSTALL_DATADIR}/pkgconfig)

set(point_set_flow_program_has_laz FALSE)
if(TARGET balanced-flow-smooth)
  get_target_property(definitions point_set_flow_point_files COMPILE_DEFINITIONS)
  if("POINT_SET_FLOW_WITH_LASZIP" IN_LIST definitions)
    set(point_set_flow_program_has_laz TRUE)
  endif()
endif()

install(DIRECTORY include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.h")
install(TARGETS point_set_flow EXPORT PointSetFlowTargets INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT PointSetFlowTargets NAMESPACE PointSetFlow:: DESTINATION ${POINT_SET_FLOW_CONFIG_DIR})
configure_package_config_file(cmake/PointSetFlowConfig.cmake.in PointSetFlowConfig.cmake
                              INSTALL_DESTINATION ${POINT_SET_FLOW_CONFIG_DIR} PATH_VARS CMAKE_INSTALL_BINDIR)
write_basic_package_version_file(PointSetFlowConfigVersion.cmake COMPATIBILITY SameMinorVersion
                                 ARCH_INDEPENDENT)
install(FILES ${PROJECT_BINARY_DIR}/PointSetFlowConfig.cmake
              ${PROJECT_BINARY_DIR}/PointSetFlowConfigVersion.cmake
              cmake/PointSetFlowDependencies.cmake
        DESTINATION ${POINT_SET_FLOW_CONFIG_DIR})

# pkg-config: what CGAL's targets add, as CGAL has no file of its own
list(TRANSFORM POINT_SET_FLOW_DEFINITIONS PREPEND "-D" OUTPUT_VARIABLE point_set_flow_pc_cflags)
list(JOIN point_set_flow_pc_cflags " " point_set_flow_pc_cflags)
set(point_set_flow_pc_tbb "")
if(TBB::tbb IN_LIST POINT_SET_FLOW_DEPENDENCIES)
  set(point_set_flow_pc_tbb " tbb")
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  string(APPEND point_set_flow_pc_cflags " -frounding-math")
endif()
foreach(dir IN LISTS CGAL_INCLUDE_DIRS)
  cmake_path(NORMAL_PATH dir)
  if(NOT dir IN_LIST CMAKE_CXX_IMPLICIT_INCLUDE_DIRECTORIES)
    string(APPEND point_set_flow_pc_cflags " -I${dir}")
  endif()
endforeach()
foreach(name IN ITEMS PREFIX FULL_INCLUDEDIR)
  cmake_path(RELATIVE_PATH CMAKE_INSTALL_${name} BASE_DIRECTORY ${CMAKE_INSTALL_FULL_DATADIR}/pkgconfig
             OUTPUT_VARIABLE point_set_flow_pc_to_${name})
endforeach()
configure_file(cmake/point-set-flow.pc.in point-set-flow.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/point-set-flow.pc DESTINATION ${point_set_flow_pc_dir})
