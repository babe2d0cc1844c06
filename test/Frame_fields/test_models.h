#ifndef TEST_FRAME_FIELDS_TEST_MODELS_H
#define TEST_FRAME_FIELDS_TEST_MODELS_H

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh/Surface_mesh_fwd.h>

#include <array>
#include <cstddef>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <utility>
#include <vector>

// The models that the tests run on, as triangle soups with feature edges.
namespace test {

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point;
typedef Kernel::Vector_3 Vector;
typedef std::array<std::size_t, 3> Triangle;

struct Model
{
  std::vector<Point> points;
  std::vector<Triangle> triangles;
  std::vector<std::pair<Point, Point> > features; // border edges need not be among them
};

constexpr double degree = 3.14159265358979323846 / 180;

// An edge between the two points, whichever comes first.
std::pair<Point, Point> segment(const Point& p, const Point& q);

// Triangulated polygons in the plane z = 0, refined to edges of about `size`. Open polylines become feature edges.
typedef std::vector<std::pair<double, double> > Polyline;
Model planar(const Polyline& polygon, double size, const std::vector<Polyline>& features = {},
             const std::vector<Polyline>& holes = {});

Model regular_polygon(int n, double size = 0.25);
Model wedge(double angle_in_degrees, double size = 0.15);
// A star with one tip per angle; between two tips there is a reflex or wide corner at distance 1 from the center.
Model star(const std::vector<double>& tip_angles_in_degrees, double size = 0.4);

// A wedge of polar coordinates: `fan` triangles around its tip.
Model wedge_with_fan(double angle_in_degrees, int fan);

// The image of a grid of m x n cells of the unit square, closed in u or v on demand.
Model grid(int m, int n, bool is_closed_in_u, bool is_closed_in_v,
           const std::function<Point(double, double)>& position);
Model square(int n);
Model annulus(int m, int n);
Model open_cylinder();
// Eight faces around, its points moved at random but those of the border: a smooth field is lost after some rings.
Model rough_tube(int number_of_rings);
Model torus();
Model convex_hull(const std::vector<Point>& points);
Model sphere();

Model tetrahedron(); // all edges are features
Model cube();        // of twelve faces, each with two feature edges
Model single_triangle();

// A curved sheet without symmetry, with features that cross, end inside, close up and reach the border.
Model quilt();

// Moves the third vertex of a triangle towards the middle of the opposite edge; the distance that is left is
// `distance` times the old one.
Model with_flat_triangle(Model model, std::size_t triangle, double distance);
// Moves the second vertex of a triangle towards the first one.
Model with_short_edge(Model model, std::size_t triangle, double length);

// Marks the edges with dihedral angles above 40 degrees.
Model with_sharp_edges(Model model);

Model transformed(Model model, const std::function<Point(const Point&)>& map);

// Leaves an oriented manifold as it is and makes one of any other soup.
Model repaired(Model model);

// Both models, the other one 100 away.
Model side_by_side(Model model, const Model& other);

// Reads an OFF file, and feature edges from a file of index pairs or, without one, by dihedral angle. A soup that is no
// oriented manifold is repaired.
Model read_model(const std::string& model_file, const std::string& feature_file = "");

// Writes `stem`.off and `stem`.feat, which `read_model()` reads.
void write_model(const Model& model, const std::string& stem);

// The faces of a mesh as they are, without features.
Model to_model(const CGAL::Surface_mesh<Point>& mesh);

// A model that is made when a test needs it.
struct Named_model
{
  std::string name;
  std::function<Model()> make;
  std::string file; // empty if generated

  bool is_available() const;
};
std::ostream& operator<<(std::ostream& out, const Named_model& model);

std::vector<Named_model> generated_models();
std::vector<Named_model> cgal_models();
std::vector<Named_model> cad_models();

// The number of sectors with 4I >= 2 on constrained edges that an independent implementation leaves.
std::optional<int> reference_number_of_unmeshable_sectors(const Named_model& model);

} // namespace test

#endif // TEST_FRAME_FIELDS_TEST_MODELS_H
