# SPDX-License-Identifier: GPL-3.0-or-later

find_package(Boost QUIET COMPONENTS unit_test_framework)
if(NOT TARGET Boost::unit_test_framework)
  message("NOTICE: The tests of this package require Boost.Test, and will not be compiled.")
  return()
endif()
list(APPEND libraries Boost::unit_test_framework)
add_compile_definitions(BOOST_TEST_DYN_LINK)
