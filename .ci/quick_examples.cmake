# Included by the project of the examples when .ci/run configures it. They run for a short time and all include the same
# headers, so they are optimized less and have these precompiled. What they include themselves is checked without, by
# clang++, and the programs are compiled as users have them.
function(make_examples_quick)
  foreach(example ${examples})
    target_compile_options(${example} PRIVATE -O1)
  endforeach()
  set(first frame_field_surface_mesh)
  target_precompile_headers(${first} PRIVATE <CGAL/Frame_fields.h> <CGAL/Simple_cartesian.h> <CGAL/Surface_mesh.h>
    <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h> <CGAL/Polygon_mesh_processing/detect_features.h> <iostream>)
  set(others ${examples})
  list(REMOVE_ITEM others ${first} frame_field_openmesh draw_frame_field) # these have other options
  foreach(example ${others})
    target_precompile_headers(${example} REUSE_FROM ${first})
  endforeach()
endfunction()

cmake_language(DEFER CALL make_examples_quick)
