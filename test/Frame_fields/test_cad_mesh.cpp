#include "test_cad_mesh.h"

namespace test {

TEST_FRAME_FIELDS_CAD_MESH(, Surface_mesh)
TEST_FRAME_FIELDS_CAD_MESH(, Polyhedron)

} // namespace test
