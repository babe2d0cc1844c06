# Included by the project of the examples when .ci/run configures it. They and the programs run for a short time, so
# they are optimized less. They take the stages on arrays from the tests, where these are compiled once, optimized as
# users have them. The examples also share CGAL's readers, and their headers are precompiled. What the sources include
# themselves is checked without all this, by clang++.
function(make_examples_quick)
  set(header ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/quick_examples.h)
  set(stages ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../test/Frame_fields/compiled_stages.h)
  add_library(quick_examples STATIC ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/quick_examples.cpp)
  target_link_libraries(quick_examples PUBLIC CGAL::Frame_fields)
  target_precompile_headers(quick_examples PRIVATE ${header} <CGAL/Frame_fields.h>
    <CGAL/Polygon_mesh_processing/detect_features.h> <iostream>)
  target_compile_options(quick_examples PRIVATE -O1)
  foreach(example ${examples})
    target_compile_options(${example} PRIVATE -O1)
    target_link_libraries(${example} PRIVATE quick_examples test_frame_fields_contract)
    if(example MATCHES "^(frame_field_openmesh|draw_frame_field)$") # these have other options
      target_compile_options(${example} PRIVATE "SHELL:-include ${header}")
    else()
      target_precompile_headers(${example} REUSE_FROM quick_examples)
    endif()
  endforeach()
  foreach(program cad_frame_field cad_quad_mesh)
    target_compile_options(${program} PRIVATE -O1 "SHELL:-include ${stages}")
    target_link_libraries(${program} PRIVATE test_frame_fields_contract)
  endforeach()
endfunction()

cmake_language(DEFER CALL make_examples_quick)
