# A user's project takes the package by add_subdirectory and, once it is installed, by find_package,
# with the CGAL and the Eigen of this build.

set(consumer_directory ${PROJECT_BINARY_DIR}/consumer)
set(consumer_prefix ${consumer_directory}/prefix)

function(add_consumer_test name)
  add_test(NAME ${name}
    COMMAND ${CMAKE_CTEST_COMMAND}
      --build-and-test ${PROJECT_SOURCE_DIR}/consumer ${consumer_directory}/${name}
      --build-generator ${CMAKE_GENERATOR}
      --build-options -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER} -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG=
        -DCGAL_DIR=${CGAL_DIR} -DEigen3_DIR=${Eigen3_DIR} ${ARGN}
      --test-command consumer)
  set_tests_properties(${name} PROPERTIES COST 30) # the longest ones start first
endfunction()

add_consumer_test(consumer_add_subdirectory -DFRAME_FIELDS_SOURCE_DIRECTORY=${PROJECT_SOURCE_DIR}/../..)

add_test(NAME consumer_install COMMAND ${CMAKE_COMMAND} --install ${CMAKE_BINARY_DIR} --prefix ${consumer_prefix})
add_consumer_test(consumer_find_package -DCMAKE_PREFIX_PATH=${consumer_prefix})
foreach(program cad_frame_field cad_quad_mesh)
  if(TARGET ${program})
    add_test(NAME ${program}_installed COMMAND ${consumer_prefix}/bin/${program} --version)
    set_tests_properties(${program}_installed PROPERTIES FIXTURES_REQUIRED frame_fields_installation
      PASS_REGULAR_EXPRESSION "^${program} [0-9.]+\n$")
  endif()
endforeach()
set_tests_properties(consumer_install PROPERTIES FIXTURES_SETUP frame_fields_installation)
set_tests_properties(consumer_find_package PROPERTIES FIXTURES_REQUIRED frame_fields_installation)
