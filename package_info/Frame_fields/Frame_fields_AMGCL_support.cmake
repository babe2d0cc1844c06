# Makes the target CGAL::AMGCL_support if AMGCL is found.
if(TARGET CGAL::AMGCL_support)
  return()
endif()

find_package(amgcl CONFIG QUIET)
if(TARGET amgcl::amgcl)
  # Only the headers: AMGCL's own target turns OpenMP on, with which results depend on the number of threads.
  get_target_property(amgcl_include_directories amgcl::amgcl INTERFACE_INCLUDE_DIRECTORIES)
  add_library(CGAL::AMGCL_support INTERFACE IMPORTED)
  set_target_properties(CGAL::AMGCL_support PROPERTIES
    INTERFACE_COMPILE_DEFINITIONS CGAL_AMGCL_ENABLED
    INTERFACE_INCLUDE_DIRECTORIES "${amgcl_include_directories}")
endif()
