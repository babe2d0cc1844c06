#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cstddef>
#include <iostream>
#include <string>

// read_with_cgal SIDES FACES FILE...: reads outputs of the programs as users of CGAL do, of any version. Fails unless
// each file is a valid mesh with so many faces of so many sides.
int main(const int argc, const char* const* const argv)
{
  typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;

  if(argc < 4)
    return 1;
  const std::size_t number_of_sides = std::stoul(argv[1]), number_of_faces = std::stoul(argv[2]);
  for(const char* const* path = argv + 3; path != argv + argc; ++path)
  {
    Mesh mesh;
    if(!CGAL::IO::read_polygon_mesh(*path, mesh) || !CGAL::is_valid_polygon_mesh(mesh)
       || mesh.number_of_faces() != number_of_faces
       || !std::all_of(mesh.faces().begin(), mesh.faces().end(), [&](const Mesh::Face_index f)
                       { return mesh.degree(f) == number_of_sides; }))
    {
      std::cerr << *path << " is not read as it was written\n";
      return 1;
    }
  }
  return 0;
}
