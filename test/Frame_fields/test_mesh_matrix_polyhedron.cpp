#include "test_mesh_matrix.h"

#include <CGAL/Polyhedron_items_with_id_3.h>

namespace {

using namespace test;

template <typename Kernel>
using Polyhedron_with_ids = CGAL::Polyhedron_3<Kernel, CGAL::Polyhedron_items_with_id_3>;

typedef testing::Types<CGAL::Polyhedron_3<EPICK>, CGAL::Polyhedron_3<Float_kernel>, Polyhedron_with_ids<EPECK> >
  Polyhedra;

struct Names
{
  template <typename>
  static std::string GetName(const int i)
  {
    return std::array<const char*, 3>{ "Polyhedron_3_of_EPICK", "Polyhedron_3_of_float",
                                       "Polyhedron_3_with_ids_of_EPECK" }[i];
  }
};

INSTANTIATE_TYPED_TEST_SUITE_P(Polyhedron_3, Every_mesh_type, Polyhedra, Names);
INSTANTIATE_TYPED_TEST_SUITE_P(Polyhedron_3, Every_editable_mesh_type, Polyhedra, Names);

} // namespace
