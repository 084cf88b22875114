# SPDX-License-Identifier: GPL-3.0-or-later
# An overlay port that builds the tree in which it lies: a clone or an unpacked archive
get_filename_component(SOURCE_PATH "${CURRENT_PORT_DIR}/../../../.." ABSOLUTE)
if(NOT EXISTS "${SOURCE_PATH}/cmake/packaging/vcpkg/point-set-flow/portfile.cmake")
  message(FATAL_ERROR "Use this port where it lies: --overlay-ports=.../cmake/packaging/vcpkg")
endif()

vcpkg_check_features(OUT_FEATURE_OPTIONS feature_options FEATURES
    laz POINT_SET_FLOW_WITH_LASZIP
    program POINT_SET_FLOW_BUILD_PROGRAM
    tbb POINT_SET_FLOW_WITH_TBB)

set(VCPKG_BUILD_TYPE release) # headers, and a program
vcpkg_cmake_configure(SOURCE_PATH "${SOURCE_PATH}"
  OPTIONS ${feature_options} -DPOINT_SET_FLOW_BUILD_TESTS=OFF -DPOINT_SET_FLOW_BUILD_EXAMPLES=OFF
          -DPOINT_SET_FLOW_WITH_LZF=OFF -DPOINT_SET_FLOW_CONFIG_DIR=share/PointSetFlow)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(PACKAGE_NAME PointSetFlow)
vcpkg_fixup_pkgconfig()
if("program" IN_LIST FEATURES)
  vcpkg_copy_tools(TOOL_NAMES balanced-flow-smooth balanced-flow-blocks AUTO_CLEAN)
endif()

file(INSTALL "${CURRENT_PORT_DIR}/usage" DESTINATION "${CURRENT_PACKAGES_DIR}/share/${PORT}")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
