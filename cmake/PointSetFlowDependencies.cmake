# SPDX-License-Identifier: GPL-3.0-or-later
# Finds CGAL, Eigen and, unless POINT_SET_FLOW_WITH_TBB is off, TBB, and says what it found.
# Sets POINT_SET_FLOW_DEPENDENCIES to the targets to link, and POINT_SET_FLOW_DEFINITIONS to what tells
# CGAL of them: CGAL's own modules for that are not in all packages of CGAL, nor found in all folders.
# Used by the build of this project and, installed, by find_package(PointSetFlow): both see the same.

set(POINT_SET_FLOW_DEPENDENCIES "")
if(NOT DEFINED POINT_SET_FLOW_WITH_TBB)
  set(POINT_SET_FLOW_WITH_TBB ON)
endif()

# In a build of this project a missing package is an error; for find_package(PointSetFlow) it
# means that PointSetFlow was not found, and the caller decides.
macro(point_set_flow_missing message)
  if(NOT point_set_flow_from_config)
    message(FATAL_ERROR "PointSetFlow: ${message}")
  endif()
  set(PointSetFlow_FOUND FALSE)
  set(PointSetFlow_NOT_FOUND_MESSAGE "${message}")
  return()
endmacro()

set(CGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE TRUE)
# CGAL 6.0 does not say whether Boost is found by CMake or by itself, of which CMake 3.30 and newer warn
set(CMAKE_POLICY_DEFAULT_CMP0167 NEW)
find_package(CGAL 5.5 QUIET)
unset(CMAKE_POLICY_DEFAULT_CMP0167)
if(NOT CGAL_FOUND)
  point_set_flow_missing("CGAL 5.5 or newer was not found (Debian, Ubuntu: libcgal-dev)")
endif()
find_package(Eigen3 QUIET NO_MODULE) # Eigen 5 refuses a request for 3.3
if(NOT TARGET Eigen3::Eigen OR Eigen3_VERSION VERSION_LESS 3.3)
  point_set_flow_missing("Eigen 3.3 or newer was not found (Debian, Ubuntu: libeigen3-dev)")
endif()
set(POINT_SET_FLOW_DEPENDENCIES CGAL::CGAL Eigen3::Eigen)
set(POINT_SET_FLOW_DEFINITIONS CGAL_EIGEN3_ENABLED)

set(point_set_flow_tbb "off (POINT_SET_FLOW_WITH_TBB)")
if(POINT_SET_FLOW_WITH_TBB)
  set(point_set_flow_tbb "not found, Parallel_tag will not compile (Debian, Ubuntu: libtbb-dev)")
  find_package(TBB QUIET)
  if(TARGET TBB::tbb)
    list(APPEND POINT_SET_FLOW_DEPENDENCIES TBB::tbb)
    if(TARGET TBB::tbbmalloc) # CGAL's concurrent containers, for the examples' and users' sake
      list(APPEND POINT_SET_FLOW_DEPENDENCIES TBB::tbbmalloc)
    endif()
    list(APPEND POINT_SET_FLOW_DEFINITIONS CGAL_LINKED_WITH_TBB NOMINMAX)
    set(point_set_flow_tbb "${TBB_VERSION}, Parallel_tag is available")
  endif()
endif()

if(NOT PointSetFlow_FIND_QUIETLY)
  message(STATUS "PointSetFlow: CGAL ${CGAL_VERSION}")
  message(STATUS "PointSetFlow: Eigen ${Eigen3_VERSION}")
  message(STATUS "PointSetFlow: TBB ${point_set_flow_tbb}")
endif()
