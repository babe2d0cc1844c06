#include "sentinels.h"
#include "test_cad_mesh.h"

#include <CGAL/Frame_fields/frame_field_from_vectors.h>
#include <CGAL/Frame_fields/singularity_indices.h>

#include <cmath>
#include <iterator>
#include <limits>
#include <map>

namespace {

using namespace test;

// The field of a model and what is left of it when only its vectors are known.
template <typename Mesh>
struct Copied_field
{
  typedef typename boost::graph_traits<Mesh>::face_descriptor face_descriptor;

  Cad_mesh<Mesh> cad_mesh;
  Maps<Mesh> original, copy;
  Halfedge_map<Mesh, int> index;
  std::map<face_descriptor, Vector> u, v;
  double maximum_misalignment = -1;

  Copied_field(const Model& model, const bool relaxes)
    : cad_mesh(model)
    , original(cad_mesh.mesh)
    , copy(cad_mesh.mesh)
    , index(get(CGAL::dynamic_halfedge_property_t<int>(), static_cast<const Mesh&>(cad_mesh.mesh)))
  {
    EXPECT_TRUE(FF::cad_frame_field(cad_mesh.mesh, original.alpha, original.rho, original.index,
      cad_mesh.features().support_strategy(FF::Support_strategy::none()).repair_matching(false)
              .relax_orthogonality(relaxes).matching_map(original.matching)));
    for(const auto f : faces(cad_mesh.mesh))
    {
      const auto vectors = FF::frame_vectors(cad_mesh.mesh, f, get(original.alpha, f), get(original.rho, f));
      u[f] = vectors[0];
      v[f] = vectors[1];
    }
  }

  FF::Result read()
  {
    return FF::frame_field_from_vectors(cad_mesh.mesh, boost::make_assoc_property_map(u),
                                        boost::make_assoc_property_map(v), copy.alpha, copy.rho, copy.matching,
                                        cad_mesh.features().maximum_misalignment(std::ref(maximum_misalignment)));
  }

  FF::Result compute_indices()
  {
    return FF::singularity_indices(cad_mesh.mesh, copy.alpha, copy.matching, index,
                                   cad_mesh.features().skewness_map(copy.rho));
  }

  void expect_same_indices()
  {
    ASSERT_TRUE(read());
    ASSERT_TRUE(compute_indices());
    for(const auto h : halfedges(cad_mesh.mesh))
      EXPECT_EQ(get(original.index, h), get(index, h));
  }
};

template <typename Mesh>
class Field_from_vectors : public testing::Test {};
TYPED_TEST_SUITE(Field_from_vectors, Mesh_classes, Mesh_class_names);

TYPED_TEST(Field_from_vectors, is_the_inverse_of_frame_vectors)
{
  for(const bool relaxes : { false, true })
  {
    Copied_field<TypeParam> field(quilt(), relaxes);
    ASSERT_TRUE(field.read());
    for(const auto f : faces(field.cad_mesh.mesh))
    {
      EXPECT_NEAR(0, std::remainder(get(field.original.alpha, f) - get(field.copy.alpha, f), 360 * degree), 1e-9);
      EXPECT_NEAR(get(field.original.rho, f), get(field.copy.rho, f), 1e-9);
    }
    EXPECT_LT(field.maximum_misalignment, 1e-9);
  }
}

TYPED_TEST(Field_from_vectors, has_the_same_indices)
{
  for(const auto& model : { quilt(), torus(), cube(), star({ 12, 44, 27 }) })
  {
    Copied_field<TypeParam> field(model, false);
    field.expect_same_indices();
  }
}

TYPED_TEST(Field_from_vectors, does_not_depend_on_lengths_signs_and_names_of_the_vectors)
{
  Copied_field<TypeParam> field(quilt(), false);
  int number = 0;
  for(const auto f : faces(field.cad_mesh.mesh))
  {
    const Vector u = field.u[f], v = field.v[f];
    const bool swaps = ++number % 2;
    field.u[f] = (number % 3 + 1) * (number % 5 < 2 ? -1 : 1) * (swaps ? v : u);
    field.v[f] = (number % 7 + 1) * (number % 3 < 2 ? -1 : 1) * (swaps ? u : v);
  }
  field.expect_same_indices();
}

TYPED_TEST(Field_from_vectors, is_turned_onto_constrained_edges)
{
  Copied_field<TypeParam> field(quilt(), false);
  const double turn = 5 * degree;
  for(const auto f : faces(field.cad_mesh.mesh))
  {
    const auto vectors = FF::frame_vectors(field.cad_mesh.mesh, f, get(field.original.alpha, f) + turn, 0);
    field.u[f] = vectors[0];
    field.v[f] = vectors[1];
  }
  ASSERT_TRUE(field.read());
  EXPECT_NEAR(turn, field.maximum_misalignment, 1e-9);
  EXPECT_TRUE(field.compute_indices());
}

TYPED_TEST(Field_from_vectors, refuses_vectors_that_are_no_frame_and_writes_nothing)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Copied_field<TypeParam> field(square(2), false);
  put_sentinels(field.cad_mesh.mesh, field.copy);
  const auto last = std::prev(field.v.end());
  const Vector parallel = 2 * field.u[last->first];
  for(const Vector& wrong : { Vector(0, 0, 0), Vector(0, 0, 1), Vector(nan, 0, 0), parallel })
  {
    last->second = wrong;
    EXPECT_EQ(FF::ERROR_WRONG_FIELD, field.read().error_code);
    EXPECT_EQ(-1, field.maximum_misalignment);
    EXPECT_TRUE(hold_sentinels(field.cad_mesh.mesh, field.copy));
  }
}

} // namespace
