# SPDX-License-Identifier: GPL-3.0-or-later
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(balanced_flow_config_dir ${CMAKE_INSTALL_DATADIR}/cmake/BalancedFlow)

install(DIRECTORY include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.h")
install(TARGETS balanced_flow EXPORT BalancedFlowTargets)
install(EXPORT BalancedFlowTargets NAMESPACE BalancedFlow:: DESTINATION ${balanced_flow_config_dir})
configure_package_config_file(cmake/BalancedFlowConfig.cmake.in BalancedFlowConfig.cmake
                              INSTALL_DESTINATION ${balanced_flow_config_dir})
write_basic_package_version_file(BalancedFlowConfigVersion.cmake COMPATIBILITY SameMinorVersion
                                 ARCH_INDEPENDENT)
install(FILES ${PROJECT_BINARY_DIR}/BalancedFlowConfig.cmake
              ${PROJECT_BINARY_DIR}/BalancedFlowConfigVersion.cmake
              cmake/BalancedFlowDependencies.cmake
        DESTINATION ${balanced_flow_config_dir})
