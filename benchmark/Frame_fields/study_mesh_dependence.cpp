// How much the frame field depends on the mesh of the same domain, for the support strategies and the edge weights.
//
//   study_mesh_dependence [FILE]
//
// writes a CSV file, to the standard output if there is no FILE: one figure a line. plot_mesh_dependence.py turns it
// into tables and a plot. See section "Dependence on the Mesh" of the manual.

#include "Field_zeros.h"
#include "planar_meshes.h"

#include <CGAL/Frame_fields.h>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#if __has_include(<CGAL/AABB_traits_3.h>) // its name since CGAL 6
#include <CGAL/AABB_traits_3.h>
#else
#include <CGAL/AABB_traits.h>
#endif
#include <CGAL/boost/graph/iterator.h>

#include <cmath>
#include <cstddef>
#include <exception>
#include <fstream>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

namespace Frame_fields = CGAL::Frame_fields;
namespace params = CGAL::Frame_fields::parameters;

using Frame_fields::Edge_weighting;
using Frame_fields::Support_strategy;

typedef Frame_fields::Singularity<Mesh::Halfedge_index> Singularity;

typedef CGAL::AABB_face_graph_triangle_primitive<Mesh> AABB_primitive;
#if __has_include(<CGAL/AABB_traits_3.h>)
typedef CGAL::AABB_tree<CGAL::AABB_traits_3<Kernel, AABB_primitive> > AABB_tree;
#else
typedef CGAL::AABB_tree<CGAL::AABB_traits<Kernel, AABB_primitive> > AABB_tree;
#endif

double in_degrees(const double angle) { return angle * 180 / CGAL_PI; }

// ------------------------------------------------------------------------------------------------------------ settings

struct Settings
{
  std::string strategy_name, weights_name;
  Support_strategy strategy;
  Edge_weighting weighting;
};

std::vector<Settings> all_settings()
{
  std::vector<Settings> result;
  typedef Frame_fields::Edge_weighting Weighting;
  for(const auto& [weights_name, weighting] : { std::make_pair("uniform", Weighting::UNIFORM),
                                                std::make_pair("geometric", Weighting::PRIMAL_OVER_DUAL_LENGTH) })
  {
    result.push_back({ "rings(4)", weights_name, Support_strategy::rings(4), weighting });
    result.push_back({ "component()", weights_name, Support_strategy::component(), weighting });
    result.push_back({ "radius()", weights_name, Support_strategy::radius(), weighting });
  }
  return result;
}

std::vector<Settings> settings_with_radius()
{
  std::vector<Settings> result;
  for(const Settings& settings : all_settings())
    if(settings.strategy.kind() == Support_strategy::RADIUS)
      result.push_back(settings);
  return result;
}

// ---------------------------------------------------------------------------------------------------------------- CSV

// The lines of one mesh and one choice of settings.
class Figures
{
public:
  Figures(std::ostream& out, const std::string& study, const std::string& mesh, const int resolution, const int seed,
          const Settings& settings)
    : m_out(out)
    , m_start(study + "," + mesh + "," + std::to_string(resolution) + "," + std::to_string(seed) + ","
              + settings.strategy_name + "," + settings.weights_name + ",")
  {}

  template <typename Value>
  void write(const std::string& quantity, const Value& value) const
  {
    m_out << m_start << quantity << ',' << value << '\n';
  }

  static const char* header() { return "study,mesh,resolution,seed,strategy,weights,quantity,value\n"; }

private:
  std::ostream& m_out;
  std::string m_start;
};

// -------------------------------------------------------------------------------------------------------------- fields

class Frame_field
{
public:
  Frame_field(const Mesh& mesh, const Settings& settings, const bool is_relaxed = true)
    : m_mesh(&mesh)
    , m_alpha(get(CGAL::dynamic_face_property_t<double>(), mesh))
    , m_rho(get(CGAL::dynamic_face_property_t<double>(), mesh))
    , m_index(get(CGAL::dynamic_halfedge_property_t<int>(), mesh))
    , m_matching(get(CGAL::dynamic_halfedge_property_t<int>(), mesh))
  {
    check(Frame_fields::cad_frame_field(mesh, m_alpha, m_rho, m_index,
                                        params::support_strategy(settings.strategy)
                                               .edge_weighting(settings.weighting)
                                               .relax_orthogonality(is_relaxed)
                                               .matching_map(m_matching)));
  }

  const Mesh& mesh() const { return *m_mesh; }
  double rho(const Mesh::Face_index f) const { return get(m_rho, f); }
  int index(const Mesh::Halfedge_index h) const { return get(m_index, h); }

  // The direction of branch 0 or 1, counted from the axis of x.
  double direction(const Mesh::Face_index f, const int branch) const
  {
    const Mesh::Halfedge_index h = m_mesh->halfedge(f);
    const Kernel::Vector_3 v(m_mesh->point(m_mesh->source(h)), m_mesh->point(m_mesh->target(h)));
    return std::atan2(v.y(), v.x()) + get(m_alpha, f) + branch * (CGAL_PI / 2 + get(m_rho, f));
  }

  std::vector<Singularity> singularities() const
  {
    std::vector<Singularity> result;
    check(Frame_fields::singularities(*m_mesh, m_index, std::back_inserter(result)));
    return result;
  }

  Frame_fields::Field_quality quality() const
  {
    Frame_fields::Field_quality result;
    check(Frame_fields::frame_field_quality(*m_mesh, m_alpha, m_rho, m_matching,
                                            Frame_fields::parameters::quality(std::ref(result))));
    return result;
  }

private:
  static void check(const Frame_fields::Result& result)
  {
    if(!result)
      throw std::runtime_error(result.message);
  }

  const Mesh* m_mesh;
  boost::property_map<Mesh, CGAL::dynamic_face_property_t<double> >::const_type m_alpha, m_rho;
  boost::property_map<Mesh, CGAL::dynamic_halfedge_property_t<int> >::const_type m_index, m_matching;
};

Point_2 place(const Mesh& mesh, const Mesh::Vertex_index v)
{
  return Point_2(mesh.point(v).x(), mesh.point(v).y());
}

double distance(const Point_2& p, const Point_2& q) { return std::sqrt(CGAL::squared_distance(p, q)); }

bool is_at_any_of(const std::vector<Point_2>& corners, const Point_2& p)
{
  for(const Point_2& corner : corners)
    if(distance(corner, p) < 1e-9)
      return true;
  return false;
}

double mean_edge_length(const Mesh& mesh, const Mesh::Vertex_index v)
{
  double sum = 0;
  int count = 0;
  for(const Mesh::Vertex_index w : CGAL::vertices_around_target(mesh.halfedge(v), mesh))
  {
    sum += distance(place(mesh, v), place(mesh, w));
    ++count;
  }
  return sum / count;
}

// ---------------------------------------------------------------------------------------------------- study 1: a wedge

// What compensates the tip: the singular sectors other than the three corners, whose indices add up to 1/4.
struct Compensation
{
  int four_times_index = 0;        // 1 unless a corner is not a quarter
  double distance_from_tip = 0;    // the mean weighted by the indices; the place itself if there is but one
  double distance_of_vertices = 0; // the same for the vertices that carry the indices
  double edge_length = 0;          // the largest mean edge length at these vertices
  int number_of_interior_singularities = 0;
  bool is_on_border = false;       // some of it
};

Compensation compensation_in_wedge(const Frame_field& field, const Field_zeros& zeros,
                                   const std::vector<Point_2>& corners)
{
  Compensation result;
  for(const Singularity& s : field.singularities())
  {
    const Mesh::Vertex_index v = field.mesh().target(s.halfedge);
    const Point_2 p = place(field.mesh(), v);
    if(is_at_any_of(corners, p))
      continue;
    result.four_times_index += s.index;
    result.distance_from_tip += s.index * distance(zeros.zero_at(s.halfedge).value_or(p), corners[0]);
    result.distance_of_vertices += s.index * distance(p, corners[0]);
    result.edge_length = (std::max)(result.edge_length, mean_edge_length(field.mesh(), v));
    result.number_of_interior_singularities += s.is_constrained ? 0 : 1;
    result.is_on_border |= s.is_constrained;
  }
  if(result.four_times_index != 0)
  {
    result.distance_from_tip /= result.four_times_index;
    result.distance_of_vertices /= result.four_times_index;
  }
  return result;
}

void study_wedge(const Wedge& wedge, const std::string& kind_name, std::ostream& out)
{
  const Mesh mesh = mesh_of(wedge);
  const std::vector<Point_2> corners = { Point_2(0, 0), point_of_wedge(wedge, 1, 0), point_of_wedge(wedge, 1, 1) };
  for(const Settings& settings : all_settings())
  {
    const Frame_field field(mesh, settings);
    const Field_zeros zeros(mesh, params::support_strategy(settings.strategy).edge_weighting(settings.weighting));
    const Compensation compensation = compensation_in_wedge(field, zeros, corners);
    const Frame_fields::Field_quality quality = field.quality();
    const Figures figures(out, "wedge", kind_name, wedge.edges_per_side, wedge.seed, settings);
    figures.write("faces", num_faces(mesh));
    figures.write("compensating index times 4", compensation.four_times_index);
    figures.write("position", compensation.distance_from_tip);
    figures.write("position of the vertex", compensation.distance_of_vertices);
    figures.write("edge length at the position", compensation.edge_length);
    figures.write("on border", compensation.is_on_border);
    figures.write("interior singularities", compensation.number_of_interior_singularities);
    figures.write("maximum skewness", in_degrees(quality.maximum_skewness));
    figures.write("mean skewness", in_degrees(quality.mean_skewness));
  }
}

void study_wedges(std::ostream& out)
{
  const int number_of_seeds = 8;
  for(const auto& [kind, name] : { std::make_pair(REGULAR, "regular"), std::make_pair(IRREGULAR, "irregular"),
                                   std::make_pair(GRADED, "graded"), std::make_pair(NEEDLES, "needles") })
    for(const int edges_per_side : { 15, 30, 60, 120 })
      for(int seed = 0; seed < number_of_seeds; ++seed)
        study_wedge({ 15 * CGAL_PI / 180, edges_per_side, kind, seed, number_of_seeds }, name, out);
}

// ------------------------------------------------------------------------------------ study 2: ten meshings of a plate

struct Placed_index
{
  Point_2 point;
  int index;
};

// Where the singularities of a field on a meshing are.
struct Index_map
{
  std::string corners;                    // 4 I at the corners of the domain
  int number_of_border_singularities = 0; // elsewhere on the border
  std::vector<Placed_index> interior;
};

Index_map index_map(const Frame_field& field, const Domain& domain)
{
  Index_map result;
  std::vector<int> index_of_corner(domain.corners.size(), 0);
  for(const Singularity& s : field.singularities())
  {
    const Point_2 p = place(field.mesh(), field.mesh().target(s.halfedge));
    if(!s.is_constrained)
    {
      result.interior.push_back({ p, s.index });
      continue;
    }
    std::size_t corner = 0;
    while(corner < domain.corners.size() && distance(domain.corners[corner], p) > 1e-9)
      ++corner;
    if(corner < domain.corners.size())
      index_of_corner[corner] = s.index;
    else
      ++result.number_of_border_singularities;
  }
  for(const int index : index_of_corner)
    result.corners += (result.corners.empty() ? "" : " ") + std::to_string(index);
  return result;
}

struct Matched_singularities
{
  int number_of_unmatched = 0;
  double mean_distance = 0;
};

// Matches singularities of the same index, the nearest pair first.
Matched_singularities match(std::vector<Placed_index> a, std::vector<Placed_index> b)
{
  int number_of_pairs = 0;
  double sum_of_distances = 0;
  while(true)
  {
    auto nearest_a = a.end();
    auto nearest_b = b.end();
    for(auto i = a.begin(); i != a.end(); ++i)
      for(auto j = b.begin(); j != b.end(); ++j)
        if(i->index == j->index
           && (nearest_a == a.end() || distance(i->point, j->point) < distance(nearest_a->point, nearest_b->point)))
        {
          nearest_a = i;
          nearest_b = j;
        }
    if(nearest_a == a.end())
      break;
    sum_of_distances += distance(nearest_a->point, nearest_b->point);
    ++number_of_pairs;
    a.erase(nearest_a);
    b.erase(nearest_b);
  }
  return { static_cast<int>(a.size() + b.size()), number_of_pairs > 0 ? sum_of_distances / number_of_pairs : 0 };
}

// The faces at points of the plane, the nearest ones if a point is outside.
std::vector<Mesh::Face_index> faces_at(const Mesh& mesh, const std::vector<Point_2>& points)
{
  AABB_tree tree(faces(mesh).begin(), faces(mesh).end(), mesh);
  std::vector<Mesh::Face_index> result;
  for(const Point_2& p : points)
    result.push_back(tree.closest_point_and_primitive(Point_3(p.x(), p.y(), 0)).second);
  return result;
}

// The angle between two lines.
double angle_between_lines(const double a, const double b) { return std::abs(std::remainder(a - b, CGAL_PI)); }

// The mean angle between the lines of two frames, paired in the better way.
double difference_of_frames(const Frame_field& a, const Mesh::Face_index f, const Frame_field& b,
                            const Mesh::Face_index g)
{
  const auto difference = [&](const int i, const int j)
  {
    return angle_between_lines(a.direction(f, i), b.direction(g, j));
  };
  return (std::min)(difference(0, 0) + difference(1, 1), difference(0, 1) + difference(1, 0)) / 2;
}

// A meshing and its faces at the common sample points.
struct Meshing
{
  Named_mesh named_mesh;
  std::vector<Mesh::Face_index> sampled_faces;

  const Mesh& mesh() const { return named_mesh.mesh; }
};

double mean_difference(const Frame_field& a, const Meshing& meshing_a, const Frame_field& b, const Meshing& meshing_b)
{
  double sum = 0;
  for(std::size_t i = 0; i < meshing_a.sampled_faces.size(); ++i)
    sum += difference_of_frames(a, meshing_a.sampled_faces[i], b, meshing_b.sampled_faces[i]);
  return sum / static_cast<double>(meshing_a.sampled_faces.size());
}

std::vector<Point_2> common_samples(const Domain& domain)
{
  const std::vector<Polyline> borders = sampled_borders(domain, [](const Point_2&) { return 0.01; });
  return Point_source(borders).random_points(5000);
}

Meshing sampled(const Named_mesh& named_mesh, const std::vector<Point_2>& samples)
{
  return { named_mesh, faces_at(named_mesh.mesh, samples) };
}

void study_plate_with(const Settings& settings, const Domain& domain, const std::vector<Meshing>& meshings,
                      std::ostream& out)
{
  const Meshing& reference = meshings.front();
  const Frame_field reference_field(reference.mesh(), settings);
  const Frame_field reference_orthogonal_field(reference.mesh(), settings, false);
  const Index_map reference_map = index_map(reference_field, domain);
  for(const Meshing& meshing : meshings)
  {
    const Frame_field field(meshing.mesh(), settings), orthogonal_field(meshing.mesh(), settings, false);
    const Index_map map = index_map(field, domain);
    const Matched_singularities matched = match(map.interior, reference_map.interior);
    const Frame_fields::Field_quality quality = field.quality();
    const Figures figures(out, "plate", meshing.named_mesh.name, 0, 0, settings);
    figures.write("faces", num_faces(meshing.mesh()));
    figures.write("corner indices times 4", map.corners);
    figures.write("border singularities", map.number_of_border_singularities);
    figures.write("interior singularities", map.interior.size());
    figures.write("unmatched singularities", matched.number_of_unmatched);
    figures.write("distance of singularities", matched.mean_distance / domain.diameter);
    figures.write("difference of orthogonal fields",
                  in_degrees(mean_difference(orthogonal_field, meshing, reference_orthogonal_field, reference)));
    figures.write("difference of fields", in_degrees(mean_difference(field, meshing, reference_field, reference)));
    figures.write("mean skewness", in_degrees(quality.mean_skewness));
  }
}

void study_plate(std::ostream& out)
{
  const Domain domain = plate();
  const std::vector<Point_2> samples = common_samples(domain);
  std::vector<Meshing> meshings;
  for(const Named_mesh& named_mesh : ten_meshings(domain))
    meshings.push_back(sampled(named_mesh, samples));
  for(const Settings& settings : all_settings())
    study_plate_with(settings, domain, meshings, out);
}

// ---------------------------------------------------------------------------------------------- study 3: orthogonality

// The largest skewness in degrees of the faces that keep a distance from the corners.
double maximum_skewness_away_from_corners(const Frame_field& field, const Domain& domain)
{
  double result = 0;
  for(const Mesh::Face_index f : field.mesh().faces())
  {
    const Point_2 p = place(field.mesh(), field.mesh().target(field.mesh().halfedge(f)));
    double nearest = domain.diameter;
    for(const Point_2& corner : domain.corners)
      nearest = (std::min)(nearest, distance(corner, p));
    if(nearest > 0.1 * domain.diameter)
      result = (std::max)(result, std::abs(field.rho(f)));
  }
  return in_degrees(result);
}

void study_orthogonality_of(const Domain& domain, const std::string& name, std::ostream& out)
{
  int number_of_refinements = 0;
  for(const double size : { 0.12, 0.06, 0.03, 0.015 })
  {
    const Mesh mesh = refined_mesh(domain, size);
    for(const Settings& settings : settings_with_radius())
    {
      const Frame_field field(mesh, settings);
      const Frame_fields::Field_quality quality = field.quality();
      const Figures figures(out, "orthogonality", name, number_of_refinements, 0, settings);
      figures.write("faces", num_faces(mesh));
      figures.write("maximum skewness", in_degrees(quality.maximum_skewness));
      figures.write("maximum skewness away from corners", maximum_skewness_away_from_corners(field, domain));
      figures.write("mean skewness", in_degrees(quality.mean_skewness));
    }
    ++number_of_refinements;
  }
}

void study_orthogonality(std::ostream& out)
{
  study_orthogonality_of(bent_parallelogram(), "bent parallelogram", out);
  study_orthogonality_of(plate(), "plate", out);
}

// ------------------------------------------------------------------------- study 4: refinement of badly shaped meshes

std::vector<Named_mesh> badly_shaped_meshes(const Domain& domain, const double size)
{
  const auto even = [=](const Point_2&) { return size; };
  return { { "even", spaced_mesh(domain, even) },
           { "stretched 4:1 along x", spaced_mesh(domain, even, 0.5) },
           { "stretched 4:1 along y", spaced_mesh(domain, even, 2) },
           { "needles", lattice_mesh(domain, size, 2 * size, size / 4) } };
}

// How far the fields on meshes that get finer are from the field on a very fine mesh.
void study_convergence(std::ostream& out)
{
  const Domain domain = plate();
  const std::vector<Point_2> samples = common_samples(domain);
  const Meshing reference = sampled({ "reference", refined_mesh(domain, 0.015) }, samples);
  int number_of_refinements = 0;
  for(const double size : { 0.1, 0.05, 0.025 })
  {
    for(const Named_mesh& named_mesh : badly_shaped_meshes(domain, size))
    {
      const Meshing meshing = sampled(named_mesh, samples);
      for(const Settings& settings : settings_with_radius())
      {
        const Frame_field reference_field(reference.mesh(), settings, false), field(meshing.mesh(), settings, false);
        const Figures figures(out, "convergence", named_mesh.name, number_of_refinements, 0, settings);
        figures.write("faces", num_faces(meshing.mesh()));
        figures.write("difference of orthogonal fields",
                      in_degrees(mean_difference(field, meshing, reference_field, reference)));
      }
    }
    ++number_of_refinements;
  }
}

int main(int argc, char* argv[])
try
{
  std::ofstream file;
  if(argc > 1)
    file.open(argv[1]);
  std::ostream& out = argc > 1 ? file : std::cout;
  out.precision(6);
  out << Figures::header();
  study_wedges(out);
  study_plate(out);
  study_orthogonality(out);
  study_convergence(out);
  out.flush();
  if(!out)
    throw std::runtime_error("cannot write the figures");
  return 0;
}
catch(const std::exception& error)
{
  std::cerr << "study_mesh_dependence: " << error.what() << '\n';
  return 1;
}
