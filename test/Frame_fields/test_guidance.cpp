#include "test_cad_mesh.h"

#include <Eigen/Eigenvalues>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

// Fields that follow given directions.
namespace {

using namespace test;

constexpr double turn = 360 * degree;

struct Guide
{
  Vector direction;
  double weight;
};

template <typename Mesh>
class Guidance : public testing::Test
{
protected:
  typedef typename boost::graph_traits<Mesh>::face_descriptor Face;

  static Point center(const Cad_mesh<Mesh>& cad_mesh, const Face f)
  {
    const auto h = halfedge(f, cad_mesh.mesh);
    return CGAL::centroid(cad_mesh.point(source(h, cad_mesh.mesh)), cad_mesh.point(target(h, cad_mesh.mesh)),
                          cad_mesh.point(target(next(h, cad_mesh.mesh), cad_mesh.mesh)));
  }

  // The named parameters for a guide that depends on the center of the face.
  template <typename Guide_at>
  static auto guided_by(const Cad_mesh<Mesh>& cad_mesh, const Guide_at& guide_at)
  {
    const auto direction = [&cad_mesh, guide_at](const Face f) { return guide_at(center(cad_mesh, f)).direction; };
    const auto weight = [&cad_mesh, guide_at](const Face f) { return guide_at(center(cad_mesh, f)).weight; };
    return parameters::guiding_direction_map(boost::make_function_property_map<Face>(direction))
      .guiding_weight_map(boost::make_function_property_map<Face>(weight));
  }

  // The angle between the direction in the plane of the face and the nearest branch.
  static double deviation(const Vector& direction, const std::array<Vector, 4>& branches)
  {
    const Vector normal = CGAL::cross_product(branches[0], branches[1]);
    const Vector projected = direction - (direction * normal) / normal.squared_length() * normal;
    double least = turn;
    for(const Vector& branch : branches)
      least = (std::min)(least, std::atan2(std::sqrt(CGAL::cross_product(projected, branch).squared_length()),
                                           projected * branch));
    return least;
  }

  template <typename Guide_at>
  static double mean_deviation(const Cad_mesh<Mesh>& cad_mesh, const Field& field, const Guide_at& guide_at)
  {
    double sum = 0;
    std::size_t number = 0;
    for(const Face f : faces(cad_mesh.mesh))
      sum += deviation(guide_at(center(cad_mesh, f)).direction, field.branches[number++]);
    return sum / static_cast<double>(number);
  }

  static long number_of_singularities(const Field& field)
  {
    return static_cast<long>(field.index.size()) - std::count(field.index.begin(), field.index.end(), 0);
  }
};

// The direction around the axis z.
Guide around_axis(const Point& p)
{
  return { Vector(-p.y(), p.x(), 0), 1 };
}

const Vector half_axes(3, 2, 1);

Point on_ellipsoid(const Point& p)
{
  const Vector scaled(p.x() * half_axes.x(), p.y() * half_axes.y(), p.z() * half_axes.z());
  return CGAL::ORIGIN + scaled;
}

// A principal direction of the ellipsoid, weighted by the difference of the principal curvatures.
Guide principal_direction(const Point& p)
{
  const Eigen::Vector3d squares(9, 4, 1), x(p.x(), p.y(), p.z());
  const Eigen::Vector3d normal = x.cwiseQuotient(squares).normalized();
  const Eigen::Matrix3d tangent = Eigen::Matrix3d::Identity() - normal * normal.transpose();
  const Eigen::Matrix3d shape = tangent * squares.cwiseInverse().asDiagonal() * tangent;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(shape); // the normal has the eigenvalue 0, the smallest
  const Eigen::Vector3d d = solver.eigenvectors().col(2);
  return { Vector(d.x(), d.y(), d.z()), solver.eigenvalues()[2] - solver.eigenvalues()[1] };
}

// The four points where the principal curvatures are equal.
double distance_to_umbilic(const Point& p)
{
  const double x = 3 * std::sqrt((9. - 4.) / (9. - 1.)), z = std::sqrt((4. - 1.) / (9. - 1.));
  return std::sqrt(CGAL::squared_distance(Point(std::abs(p.x()), std::abs(p.y()), std::abs(p.z())), Point(x, 0, z)));
}

// A quarter of a torus with open ends.
Model bent_pipe()
{
  return grid(24, 16, false, true, [](const double u, const double v)
  {
    const double radius = 4 + std::cos(turn * v);
    return Point(radius * std::cos(turn * u / 4), radius * std::sin(turn * u / 4), std::sin(turn * v));
  });
}

TYPED_TEST_SUITE(Guidance, Mesh_classes, Mesh_class_names);

TYPED_TEST(Guidance, torus_guided_around_its_axis_has_no_singularity)
{
  const Cad_mesh<TypeParam> cad_mesh(torus());
  const Field field = frame_field(cad_mesh, this->guided_by(cad_mesh, around_axis));
  EXPECT_EQ(0, this->number_of_singularities(field));
  EXPECT_LT(this->mean_deviation(cad_mesh, field, around_axis), 2 * degree);
}

TYPED_TEST(Guidance, bent_pipe_guided_along_its_axis_has_no_singularity)
{
  const Cad_mesh<TypeParam> cad_mesh(bent_pipe());
  const Field field = frame_field(cad_mesh, this->guided_by(cad_mesh, around_axis));
  EXPECT_EQ(0, this->number_of_singularities(field));
  EXPECT_LT(this->mean_deviation(cad_mesh, field, around_axis), 2 * degree);
  EXPECT_LT(largest_misalignment(cad_mesh.cut(), field), 1e-9);
}

TYPED_TEST(Guidance, ellipsoid_guided_by_curvature_is_singular_at_umbilics_only)
{
  const Cad_mesh<TypeParam> cad_mesh(transformed(sphere(), on_ellipsoid));
  const Field field = frame_field(cad_mesh, this->guided_by(cad_mesh, [](const Point& p)
  {
    const Guide guide = principal_direction(p);
    return Guide{ guide.direction, 10 * guide.weight };
  }));
  const Cut cut = cad_mesh.cut();
  const std::vector<int> index = index_of_sectors(cut, field.index);
  int sum = 0;
  for(int h = 0; h < cut.number_of_halfedges(); ++h)
  {
    const int i = index[cut.sector[h]];
    if(i != 0)
    {
      EXPECT_LT(distance_to_umbilic(cut.points[h]), 0.7) << "index " << i << " at " << cut.points[h];
    }
  }
  for(const int i : index)
    sum += i;
  EXPECT_EQ(8, sum);
}

TYPED_TEST(Guidance, weight_zero_is_no_guidance)
{
  const Cad_mesh<TypeParam> cad_mesh(quilt());
  const Field guided = frame_field(cad_mesh, this->guided_by(cad_mesh, [](const Point& p)
  {
    return Guide{ around_axis(p).direction, 0 };
  }));
  EXPECT_EQ(frame_field(cad_mesh).alpha, guided.alpha);
}

TYPED_TEST(Guidance, infinite_weight_keeps_a_branch_along_the_direction)
{
  const Cad_mesh<TypeParam> cad_mesh(quilt());
  const Vector direction(1, 0.3, 0.1);
  const auto guide_at = [&](const Point& p)
  {
    const bool is_guided = std::abs(p.x() - 2.5) + std::abs(p.y() - 2.2) < 1;
    return Guide{ direction, is_guided ? std::numeric_limits<double>::infinity() : 0 };
  };
  const Field field = frame_field(cad_mesh, this->guided_by(cad_mesh, guide_at));
  const Cut cut = cad_mesh.cut();
  std::size_t number = 0, number_of_guided_faces = 0;
  for(const auto f : faces(cad_mesh.mesh))
  {
    const bool has_constrained_edge =
      cut.is_constrained(3 * number) || cut.is_constrained(3 * number + 1) || cut.is_constrained(3 * number + 2);
    if(guide_at(this->center(cad_mesh, f)).weight > 0 && !has_constrained_edge)
    {
      ++number_of_guided_faces;
      EXPECT_LT(this->deviation(direction, field.branches[number]), 1e-9);
    }
    ++number;
  }
  EXPECT_GT(number_of_guided_faces, 0u);
  EXPECT_LT(largest_misalignment(cut, field), 1e-9);
}

TYPED_TEST(Guidance, larger_weights_bring_the_field_nearer)
{
  const Cad_mesh<TypeParam> cad_mesh(transformed(sphere(), on_ellipsoid));
  for(const FF::Edge_weighting weighting : { FF::Edge_weighting::UNIFORM, FF::Edge_weighting::PRIMAL_OVER_DUAL_LENGTH })
    for(const bool is_relaxed : { false, true })
    {
      double last = 45 * degree;
      for(const double factor : { 0.01, 1., 100., 10000. })
      {
        const Field field = frame_field(cad_mesh, parameters::join(
          parameters::relax_orthogonality(is_relaxed).edge_weighting(weighting),
          this->guided_by(cad_mesh, [factor](const Point& p)
        {
          return Guide{ principal_direction(p).direction, factor };
        })));
        const double deviation = this->mean_deviation(cad_mesh, field, principal_direction);
        EXPECT_LT(deviation, last) << "weight " << factor << (is_relaxed ? ", relaxed" : "");
        last = deviation;
      }
      EXPECT_LT(last, 0.05 * degree);
    }
}

TYPED_TEST(Guidance, wrong_guides_are_refused)
{
  const Cad_mesh<TypeParam> cad_mesh(torus());
  const double infinity = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  for(const Guide& guide : { Guide{ Vector(0, 0, 0), 1 }, Guide{ Vector(nan, 0, 1), 1 },
                             Guide{ Vector(infinity, 0, 1), 1 }, Guide{ Vector(1, 2, 3), -1 },
                             Guide{ Vector(1, 2, 3), nan } })
  {
    const Maps<TypeParam> maps(cad_mesh.mesh);
    const FF::Result result =
      FF::cad_frame_field(cad_mesh.mesh, maps.alpha, maps.rho, maps.index,
                          this->guided_by(cad_mesh, [&](const Point&) { return guide; }));
    EXPECT_EQ(FF::ERROR_WRONG_FIELD, result.error_code);
    EXPECT_NE(std::string::npos, result.message.find("face 0 ")) << result.message;
  }
}

} // namespace
