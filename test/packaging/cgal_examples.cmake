# SPDX-License-Identifier: GPL-3.0-or-later
# The drop-in test: CGAL's own example programs, with the name of the smoothing function replaced
# by ours and nothing else, have to compile and to run.

set(examples
  Point_set_processing_3/jet_smoothing_example
  Point_set_processing_3/callback_example
  Point_set_processing_3/scale_estimation_example
  Point_set_processing_3/bilateral_smooth_point_set_example
  Poisson_surface_reconstruction_3/tutorial_example)

foreach(example IN LISTS examples)
  get_filename_component(name ${example} NAME)
  set(source ${CGAL_DEMO_EXAMPLES_DIR}/${example}.cpp)
  if(NOT CGAL_DEMO_EXAMPLES_DIR)
    continue()
  elseif(NOT EXISTS ${source})
    message(FATAL_ERROR "libcgal-demo has no ${example} any more")
  endif()
  file(READ ${source} text)
  string(REGEX REPLACE "(jet|bilateral)_smooth_point_set([ .<(])" "balanced_flow_smooth_point_set\\2" ours "${text}")
  if(ours STREQUAL text)
    message(FATAL_ERROR "${source} calls no smoothing function any more")
  endif()
  set(replaced ${CMAKE_CURRENT_BINARY_DIR}/cgal_examples/${name}.cpp)
  file(CONFIGURE OUTPUT ${replaced} CONTENT "${ours}" @ONLY)

  add_executable(cgal_${name} ${replaced})
  target_link_libraries(cgal_${name} PRIVATE PointSetFlow::point_set_flow)
  target_compile_options(cgal_${name} PRIVATE -O0) # to optimize all of these takes longer than they run
  target_compile_definitions(cgal_${name} PRIVATE CGAL_DATA_DIR="${CGAL_DEMO_DATA_DIR}")
  set(work_dir ${CMAKE_CURRENT_BINARY_DIR}/cgal_examples/${name}_work)
  file(MAKE_DIRECTORY ${work_dir}/data) # where the bilateral example writes
  add_test(NAME cgal_${name} COMMAND cgal_${name} WORKING_DIRECTORY ${work_dir})
endforeach()
