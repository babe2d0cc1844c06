# Tests of the programs cad_frame_field and cad_quad_mesh, and of the examples: one for each class of test_program.py,
# test_soups.py and test_quad_program.py. A class whose tests may be skipped has no others, as the whole class is
# reported as skipped then.
# Expects cgal_data_directory and FRAME_FIELDS_CAD_DATA_DIRECTORY.

if(NOT TARGET cad_frame_field)
  message("NOTICE: The programs are not built and will not be tested.")
  return()
endif()
find_package(Python3 QUIET COMPONENTS Interpreter)
if(NOT Python3_Interpreter_FOUND)
  message("NOTICE: The tests of the programs require Python 3 and will not be run.")
  return()
endif()

function(add_program_tests test_program program)
  set(script ${CMAKE_CURRENT_LIST_DIR}/${test_program}.py)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${script})
  file(STRINGS ${script} test_classes REGEX "^class .*Test\\)")
  list(FILTER test_classes EXCLUDE REGEX "Test\\(") # what others derive from
  foreach(test_class ${test_classes})
    string(REGEX REPLACE "^class ([A-Za-z0-9_]+).*" "\\1" test_class ${test_class})
    add_test(NAME ${test_program}.${test_class}
      COMMAND ${Python3_EXECUTABLE} ${script} $<TARGET_FILE:${program}> ${CMAKE_CURRENT_LIST_DIR}/../..
              ${cgal_data_directory} ${FRAME_FIELDS_CAD_DATA_DIRECTORY} ${test_class})
    set_tests_properties(${test_program}.${test_class} PROPERTIES SKIP_REGULAR_EXPRESSION "OK \\(skipped="
      COST 10) # the long ones start first
  endforeach()
endfunction()

add_program_tests(test_program cad_frame_field)
add_program_tests(test_soups cad_frame_field)
add_program_tests(test_quad_program cad_quad_mesh)

# The scripts of the benchmarks that measure and compare quad meshes.
find_program(Frame_fields_PYTHON NAMES python3 PATHS /usr/bin NO_DEFAULT_PATH DOC "Python 3 that has SciPy")
find_program(Frame_fields_PYTHON NAMES python3)
mark_as_advanced(Frame_fields_PYTHON)
execute_process(COMMAND ${Frame_fields_PYTHON} -c "import scipy" RESULT_VARIABLE no_scipy OUTPUT_QUIET ERROR_QUIET)
if(no_scipy EQUAL 0)
  add_test(NAME test_quad_comparison COMMAND ${Frame_fields_PYTHON} ${CMAKE_CURRENT_LIST_DIR}/test_quad_comparison.py
    $<TARGET_FILE:cad_quad_mesh>)
else()
  message("NOTICE: The comparison of quad meshers requires SciPy and will not be tested.")
endif()
