// The headers of this mesh come first.
#include <CGAL/Linear_cell_complex_for_bgl_combinatorial_map_helper.h>
#include <CGAL/Linear_cell_complex_for_combinatorial_map.h>
#include <CGAL/boost/graph/graph_traits_Linear_cell_complex_for_combinatorial_map.h>

#include "test_mesh_matrix.h"

namespace {

using namespace test;

template <typename Kernel>
using Linear_cell_complex = typename CGAL::Linear_cell_complex_for_bgl_combinatorial_map_helper<
  2, 3, CGAL::Linear_cell_complex_traits<3, Kernel> >::type;

typedef testing::Types<Linear_cell_complex<EPICK>, Linear_cell_complex<EPECK> > Linear_cell_complexes;

struct Names
{
  template <typename>
  static std::string GetName(const int i)
  {
    return std::array<const char*, 2>{ "Linear_cell_complex_of_EPICK", "Linear_cell_complex_of_EPECK" }[i];
  }
};

INSTANTIATE_TYPED_TEST_SUITE_P(Linear_cell_complex, Every_mesh_type, Linear_cell_complexes, Names);
INSTANTIATE_TYPED_TEST_SUITE_P(Linear_cell_complex, Every_editable_mesh_type, Linear_cell_complexes, Names);

} // namespace
