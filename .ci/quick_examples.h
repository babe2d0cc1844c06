#ifndef CI_QUICK_EXAMPLES_H
#define CI_QUICK_EXAMPLES_H

#include "../test/Frame_fields/compiled_stages.h"

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <string>

// Most examples read a mesh of this type. CGAL's readers and writers of all formats take longer to compile than the
// examples themselves.
namespace quick_examples {

typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;

} // namespace quick_examples

#define QUICK_EXAMPLES_FILES(EXTERN_OR_NOTHING)                                                                        \
  EXTERN_OR_NOTHING template bool CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(                                \
    const std::string&, quick_examples::Mesh&, const CGAL::parameters::Default_named_parameters&);                     \
  EXTERN_OR_NOTHING template bool CGAL::IO::write_polygon_mesh(                                                        \
    const std::string&, quick_examples::Mesh&, const CGAL::parameters::Default_named_parameters&);

QUICK_EXAMPLES_FILES(extern)

#endif // CI_QUICK_EXAMPLES_H
