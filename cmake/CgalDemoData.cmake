# SPDX-License-Identifier: GPL-3.0-or-later
# Unpacks CGAL's own examples and sample data, which Debian ships in the package libcgal-demo.
# Sets CGAL_DEMO_DATA_DIR and CGAL_DEMO_EXAMPLES_DIR, empty where the package is not installed.

foreach(name IN ITEMS data examples)
  string(TOUPPER ${name} upper_name)
  set(CGAL_DEMO_${upper_name}_DIR "")
  file(GLOB archive /usr/share/doc/libcgal-demo/${name}.tar.* /usr/share/doc/libcgal-dev/${name}.tar.*)
  if(archive)
    list(GET archive 0 archive)
    set(unpacked ${PROJECT_BINARY_DIR}/libcgal-demo)
    if(NOT EXISTS ${unpacked}/${name})
      file(MAKE_DIRECTORY ${unpacked})
      execute_process(COMMAND ${CMAKE_COMMAND} -E tar xf ${archive} WORKING_DIRECTORY ${unpacked}
                      COMMAND_ERROR_IS_FATAL ANY)
    endif()
    set(CGAL_DEMO_${upper_name}_DIR ${unpacked}/${name})
  else()
    message(STATUS "PointSetFlow: libcgal-demo is not installed, what needs CGAL's ${name} is left out")
  endif()
endforeach()
