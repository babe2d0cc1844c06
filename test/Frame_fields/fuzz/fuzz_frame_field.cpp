// A target for libFuzzer: bytes become parameters, a mesh and its feature edges, on which all public functions are
// called. What breaks the contract of one of them ends the program.

#include "Fuzz_case.h"
#include "check_quads.h"

#include "../field_contract.h"
#include "../map_contract.h"
#include "../sentinels.h"

#include <CGAL/Frame_fields.h>

#include <boost/iterator/function_output_iterator.hpp>
#include <boost/property_map/function_property_map.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace {

using namespace test;

typedef Surface_mesh Mesh;
typedef Mesh::Face_index Face;
typedef Mesh::Halfedge_index Halfedge;

void expect(const bool is_true, const std::string& fact)
{
  if(is_true)
    return;
  std::cerr << "broken: " << fact << std::endl;
  std::abort();
}

// What else the bytes may give: directions and weights of faces, and targets of sectors.
struct Guidance
{
  typename boost::property_map<Mesh, CGAL::dynamic_face_property_t<Vector> >::const_type direction;
  Face_map<Mesh, double> weight;
  Halfedge_map<Mesh, int> target;

  Guidance(const Mesh& mesh, const Fuzz_parameters& parameters, Byte_reader& bytes)
    : direction(get(CGAL::dynamic_face_property_t<Vector>(), mesh))
    , weight(get(CGAL::dynamic_face_property_t<double>(), mesh))
    , target(get(CGAL::dynamic_halfedge_property_t<int>(), mesh))
  {
    const double infinity = std::numeric_limits<double>::infinity();
    const double weights[] = { 0, 1, 1e-300, 1e300, 1e-3, infinity, -1, std::numeric_limits<double>::quiet_NaN() };
    for(const Face f : faces(mesh))
    {
      const unsigned int byte = parameters.is_guided ? bytes.byte() : 0;
      put(weight, f, weights[byte % 8]);
      put(direction, f, Vector((byte >> 3) % 4 * 1., (byte >> 5) % 4 - 1., (byte >> 7) * 1e-9));
    }
    for(const Halfedge h : halfedges(mesh))
      put(target, h, FF::NO_INDEX_TARGET);
    if(!parameters.has_index_targets || num_faces(mesh) == 0)
      return;
    for(unsigned int n = bytes.below(9); n > 0; --n)
    {
      Halfedge h = halfedge(Face(bytes.byte() % num_faces(mesh)), mesh);
      for(unsigned int k = bytes.below(3); k > 0; --k)
        h = next(h, mesh);
      const int values[] = { 0, 1, -1, 2, 4, -4, std::numeric_limits<int>::max(), std::numeric_limits<int>::min() + 1 };
      put(target, h, values[bytes.below(8)]);
    }
  }
};

bool is_finite(const Point& p) { return std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z()); }

bool is_overconstrained(const Cad_mesh<Mesh>& cad_mesh, const Face f)
{
  int number = 0;
  for(const Halfedge h : CGAL::halfedges_around_face(halfedge(f, cad_mesh.mesh), cad_mesh.mesh))
    number += is_border(opposite(h, cad_mesh.mesh), cad_mesh.mesh) || get(cad_mesh.is_feature, edge(h, cad_mesh.mesh));
  return number > 1;
}

double edge_length(const Halfedge h, const Mesh& mesh)
{
  const Vector way = mesh.point(target(h, mesh)) - mesh.point(source(h, mesh));
  return std::hypot(way.x(), way.y(), way.z());
}

double longest_edge(const Mesh& mesh)
{
  double result = 0;
  for(const Halfedge h : halfedges(mesh))
    result = (std::max)(result, edge_length(h, mesh));
  return result;
}

// Whether the mesh and the parameters are such that an error code, or OK, may come out.
class Expectation
{
public:
  Expectation(const Cad_mesh<Mesh>& cad_mesh, const Fuzz_parameters& parameters,
              const bool makes_quads = false)
    : m_parameters(parameters)
  {
    const Mesh& mesh = cad_mesh.mesh;
    m_is_empty = num_faces(mesh) == 0;
    // The copy of the mesh that is refined has coordinates of about 1 at most, so that tiny edges may be lost in it.
    const double least_length = makes_quads ? 1e-290 * longest_edge(mesh) : 0;
    for(const Face f : faces(mesh))
    {
      m_is_overconstrained |= !makes_quads && is_overconstrained(cad_mesh, f);
      for(const auto v : vertices_around_face(halfedge(f, mesh), mesh))
        m_is_finite &= is_finite(mesh.point(v));
      for(const Halfedge h : halfedges_around_face(halfedge(f, mesh), mesh))
      {
        m_has_edge_without_length |= mesh.point(source(h, mesh)) == mesh.point(target(h, mesh));
        m_may_lose_edge |= edge_length(h, mesh) <= least_length;
      }
    }
  }

  bool allows(const FF::Error_code code) const
  {
    switch(code)
    {
      case FF::OK:
        return !m_is_empty && m_is_finite && !m_has_edge_without_length && !m_is_overconstrained && has_good_numbers();
      case FF::ERROR_EMPTY_MESH: return m_is_empty;
      case FF::ERROR_NON_FINITE_COORDINATE: return !m_is_finite;
      case FF::ERROR_ZERO_LENGTH_EDGE: return m_has_edge_without_length || m_may_lose_edge;
      case FF::ERROR_OVERCONSTRAINED_FACE: return m_is_overconstrained;
      case FF::ERROR_WRONG_PARAMETER: return !has_good_numbers();
      case FF::ERROR_WRONG_FIELD: return m_parameters.is_guided || m_parameters.has_index_targets;
      case FF::ERROR_POINCARE_HOPF: return m_parameters.has_index_targets;
      case FF::ERROR_NO_RECEIVING_SECTOR: return m_parameters.sharp_corner_bound >= CGAL_PI;
      default: return false;
    }
  }

private:
  bool has_good_numbers() const
  {
    const double bound = m_parameters.sharp_corner_bound, skewness = m_parameters.maximum_skewness;
    const double weight = m_parameters.orthogonality_weight;
    const double length = m_parameters.orthogonality_length; // 0 stands for the default
    return bound >= 0 && std::isfinite(bound) && skewness >= 0 && skewness < CGAL_PI / 2 && weight >= 0
        && std::isfinite(weight) && length >= 0 && std::isfinite(length);
  }

  const Fuzz_parameters& m_parameters;
  bool m_is_empty = false, m_is_overconstrained = false, m_is_finite = true, m_has_edge_without_length = false,
       m_may_lose_edge = false;
};

bool meets_targets(const Mesh& mesh, const Maps<Mesh>& maps, const Guidance& guidance)
{
  for(const Halfedge h : halfedges(mesh))
    if(!is_border(h, mesh) && get(guidance.target, h) != FF::NO_INDEX_TARGET
       && get(guidance.target, h) != get(maps.index, h))
      return false;
  return true;
}

// Vectors of the frames are read as the field that they come from.
void check_vectors(const Cad_mesh<Mesh>& cad_mesh, const Maps<Mesh>& maps, const Field& field)
{
  const Mesh& mesh = cad_mesh.mesh;
  std::map<Face, std::array<Vector, 4> > branches;
  auto branches_of_face = field.branches.begin();
  for(const Face f : faces(mesh))
    branches[f] = *branches_of_face++;
  const auto branch = [&](const int b)
  {
    return boost::make_function_property_map<Face, Vector>([&branches, b](const Face f) { return branches[f][b]; });
  };
  const Maps<Mesh> read(mesh);
  double misalignment = sentinel;
  const FF::Result result = FF::frame_field_from_vectors(
    mesh, branch(0), branch(1), read.alpha, read.rho, read.matching,
    cad_mesh.features().maximum_misalignment(std::ref(misalignment)));
  expect(bool(result), "vectors are read: " + result.message);
  expect(misalignment < 1e-9, "vectors are aligned");
  for(const Face f : faces(mesh))
    expect(std::abs(get(read.rho, f) - get(maps.rho, f)) < 1e-9, "vectors have the skewness of their field");
}

void check_map(const Cad_mesh<Mesh>& cad_mesh, const Maps<Mesh>& maps)
{
  const Mesh& mesh = cad_mesh.mesh;
  const auto uv_map = get(CGAL::dynamic_halfedge_property_t<Point_2>(), mesh);
  std::vector<FF::Uncertified_patch<Face> > uncertified;
  const FF::Result result = FF::seamless_parameterization(
    mesh, maps.alpha, maps.rho, maps.matching, maps.index, uv_map,
    cad_mesh.features().uncertified_patch_output_iterator(std::back_inserter(uncertified)));
  expect(bool(result), "patches are mapped: " + result.message);
  std::vector<Point_2> uv;
  std::vector<int> index;
  for_each_halfedge(mesh, [&](const Halfedge h)
  {
    uv.push_back(get(uv_map, h));
    index.push_back(get(maps.index, h));
  });
  const Cut cut = cad_mesh.cut();
  const std::string broken = broken_facts_of_map(cut, index_of_sectors(cut, index), uv, uncertified.size());
  expect(broken.empty(), broken);
}

void check_streamlines(const Cad_mesh<Mesh>& cad_mesh, const Maps<Mesh>& maps,
                       const Streamline_parameters& fuzz_parameters)
{
  const Mesh& mesh = cad_mesh.mesh;
  std::vector<FF::Streamline<Point, Face> > lines;
  const double given = fuzz_parameters.spacing * longest_edge(mesh);
  const std::optional<double> spacing =
    fuzz_parameters.have_default_spacing() ? std::nullopt : std::optional<double>(given);
  const FF::Result result = FF::trace_streamlines(
    mesh, maps.alpha, maps.rho, maps.matching, std::back_inserter(lines),
    cad_mesh.features().streamline_spacing(spacing)
                       .streamline_separation(fuzz_parameters.separation)
                       .maximum_streamline_length(fuzz_parameters.maximum_length));
  expect(result ? fuzz_parameters.are_in_range() : result.error_code == FF::ERROR_WRONG_PARAMETER && lines.empty(),
         "an unexpected answer: " + result.message);
  expect(result || !fuzz_parameters.are_in_range() || !fuzz_parameters.have_default_spacing(),
         "streamlines are found at the default spacing: " + result.message);
  for(const FF::Streamline<Point, Face>& line : lines)
  {
    expect(line.faces.size() > 0 && line.points.size() == line.faces.size() + 1
           && line.branches.size() == line.faces.size(), "each segment of a streamline has a face and a branch");
    expect(!line.is_closed || line.points.front() == line.points.back(), "a closed line ends where it begins");
    for(const Point& p : line.points)
      expect(is_finite(p), "points of streamlines are finite");
  }
}

// Puts numbers of any size in up to three places of a field.
void spoil(const Mesh& mesh, const Maps<Mesh>& maps, Byte_reader& bytes)
{
  const double infinity = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  const double numbers[] = { 0, 1e-3, 1e3, 1e9, -1e18, 1e300, infinity, nan };
  const int largest = std::numeric_limits<int>::max(), integers[] = { 0, 1, -4, 1000, largest, -largest, -largest - 1 };
  for(unsigned int n = bytes.below(4); n > 0; --n)
  {
    const Face f(bytes.byte() % num_faces(mesh));
    const Halfedge h = halfedge(f, mesh);
    const unsigned int kind = bytes.below(4);
    if(kind == 0)
      put(maps.alpha, f, numbers[bytes.below(8)]);
    else if(kind == 1)
      put(maps.rho, f, numbers[bytes.below(8)]);
    else
      put(maps.matching, h, integers[bytes.below(7)]);
    if(kind == 3 && get(maps.matching, h) > -largest)
      put(maps.matching, opposite(h, mesh), -get(maps.matching, h));
  }
}

// What reads a field is told of one that is wrong, and may not see it, but writes nothing if it does.
void check_spoilt_field(const Cad_mesh<Mesh>& cad_mesh, const Maps<Mesh>& maps, Byte_reader& bytes)
{
  const Mesh& mesh = cad_mesh.mesh;
  const auto features = cad_mesh.features();
  const auto expect_answer = [](const FF::Result& result, const bool is_untouched)
  {
    expect(result || result.error_code == FF::ERROR_WRONG_FIELD, "an unexpected answer: " + result.message);
    expect(result || is_untouched, "outputs stay untouched on failure");
  };
  spoil(mesh, maps, bytes);
  const Maps<Mesh> output(mesh);
  put_sentinels(mesh, output);
  const FF::Result indices = FF::singularity_indices(mesh, maps.alpha, maps.matching, output.index,
                                                     features.skewness_map(maps.rho));
  expect_answer(indices, hold_sentinels(mesh, output));
  FF::Field_quality quality;
  quality.energy = sentinel;
  const FF::Result measured = FF::frame_field_quality(mesh, maps.alpha, maps.rho, maps.matching,
                                                       features.quality(std::ref(quality)));
  expect_answer(measured, quality.energy == sentinel);
  std::vector<FF::Streamline<Point, Face> > lines;
  const FF::Result traced =
    FF::trace_streamlines(mesh, maps.alpha, maps.rho, maps.matching, std::back_inserter(lines),
                          features.maximum_streamline_length(longest_edge(mesh)));
  expect_answer(traced, lines.empty());
  for(const Face f : faces(mesh))
    put(output.alpha, f, get(maps.alpha, f));
  const FF::Result relaxed =
    FF::relax_frame_field(mesh, output.alpha, output.rho, features.matching_map(maps.matching));
  const auto all_faces = faces(mesh);
  expect_answer(relaxed, std::all_of(all_faces.begin(), all_faces.end(), [&](const Face f)
                                     { return get(output.rho, f) == sentinel; }));
}

// Calls `cad_frame_field()` and its stages one by one.
template <typename NamedParameters>
void check_field(const Cad_mesh<Mesh>& cad_mesh, const Fuzz_parameters& fuzz_parameters, const Guidance& guidance,
                 Byte_reader& bytes, const NamedParameters& np)
{
  const Mesh& mesh = cad_mesh.mesh;
  const Expectation expectation(cad_mesh, fuzz_parameters);
  const Maps<Mesh> maps(mesh);
  put_sentinels(mesh, maps);
  FF::Statistics statistics;
  std::vector<Halfedge> corners;
  const FF::Result result = FF::cad_frame_field(
    mesh, maps.alpha, maps.rho, maps.index,
    parameters::join(np, parameters::matching_map(maps.matching).prescribed_rotation_map(maps.omega)
      .statistics(std::ref(statistics)).sharp_corner_output_iterator(std::back_inserter(corners))));
  expect(expectation.allows(result.error_code), "an unexpected answer: " + result.message);
  if(!result)
  {
    expect(hold_sentinels(mesh, maps) && corners.empty(), "outputs stay untouched on failure");
    return;
  }
  const Cut cut = cad_mesh.cut();
  const Field field = to_field(cad_mesh, maps);
  std::string broken = broken_facts_of_any_field(cut, field, fuzz_parameters.maximum_skewness);
  if(fuzz_parameters.repairs && !fuzz_parameters.has_index_targets)
    broken += unmeshable_sectors(cut, field.index);
  expect(broken.empty(), broken);
  expect(meets_targets(mesh, maps, guidance), "index targets are met");
  expect(std::isfinite(statistics.energy_orthogonal), "the energy is finite");

  const Maps<Mesh> staged(mesh);
  const auto with_matching = parameters::join(np, parameters::matching_map(staged.matching));
  expect(bool(FF::prescribe_rotation(mesh, staged.omega, np)), "the rotation is prescribed");
  expect(bool(FF::orthogonal_frame_field(
           mesh, staged.alpha, parameters::join(with_matching, parameters::prescribed_rotation_map(staged.omega)))),
         "the orthogonal field is found");
  for(const Halfedge h : halfedges(mesh))
    expect(get(staged.omega, h) == get(maps.omega, h), "the stages give the same prescribed rotation");
  for(const Halfedge h : halfedges(mesh))
    expect(get(staged.matching, h) == get(maps.matching, h), "the stages give the same matching");
  expect(bool(FF::singularity_indices(mesh, staged.alpha, staged.matching, staged.index, np)), "indices are found");
  for(const Halfedge h : halfedges(mesh))
    expect(get(staged.index, h) == get(maps.index, h), "the stages give the same indices");
  if(fuzz_parameters.relaxes)
  {
    expect(bool(FF::relax_frame_field(mesh, staged.alpha, staged.rho, with_matching)), "the field is relaxed");
    for(const Face f : faces(mesh))
      expect(get(staged.alpha, f) == get(maps.alpha, f) && get(staged.rho, f) == get(maps.rho, f),
             "the stages give the same field");
  }

  FF::Field_quality quality;
  expect(bool(FF::frame_field_quality(mesh, maps.alpha, maps.rho, maps.matching, np.quality(std::ref(quality)))),
         "it is measured");
  std::vector<FF::Singularity<Halfedge> > found;
  expect(bool(FF::singularities(mesh, maps.index, std::back_inserter(found), np)), "singularities are listed");
  for(const std::array<Vector, 4>& branches : field.branches)
    for(const Vector& branch : branches)
      expect(std::abs(branch.squared_length() - 1) < 1e-9, "branches are unit vectors");
  check_vectors(cad_mesh, maps, field);
  check_map(cad_mesh, maps);
  check_streamlines(cad_mesh, maps, read_streamline_parameters(bytes));
  check_spoilt_field(cad_mesh, maps, bytes);
}

auto parameters_of(const Cad_mesh<Mesh>& cad_mesh, const Fuzz_parameters& fuzz_parameters, const Guidance& guidance)
{
  return cad_mesh.features().support_strategy(fuzz_parameters.support_strategy)
                 .edge_weighting(fuzz_parameters.edge_weighting)
                 .sharp_corner_bound(fuzz_parameters.sharp_corner_bound)
                 .maximum_skewness(fuzz_parameters.maximum_skewness)
                 .orthogonality_weight(fuzz_parameters.orthogonality_weight)
                 .orthogonality_length(fuzz_parameters.orthogonality_length == 0
                                       ? std::nullopt
                                       : std::optional<double>(fuzz_parameters.orthogonality_length))
                 .relax_orthogonality(fuzz_parameters.relaxes)
                 .repair_matching(fuzz_parameters.repairs)
                 .index_target_map(guidance.target);
}

// Calls `cad_quad_mesh()`.
void check_quads(const Cad_mesh<Mesh>& cad_mesh, const Fuzz_parameters& fuzz_parameters, const Guidance& guidance,
                 const double edge_length)
{
  const Mesh& mesh = cad_mesh.mesh;
  const bool makes_quads = true;
  const Expectation expectation(cad_mesh, fuzz_parameters, makes_quads);
  Mesh quads;
  const auto is_marked = get(CGAL::dynamic_edge_property_t<bool>(), quads);
  const auto location = get(CGAL::dynamic_vertex_property_t<std::pair<Face, std::array<double, 3> > >(), quads);
  FF::Quad_statistics statistics;
  statistics.number_of_quads = 77;
  const FF::Result result = FF::cad_quad_mesh(
    mesh, quads, parameters_of(cad_mesh, fuzz_parameters, guidance)
                   .guiding_direction_map(guidance.direction).guiding_weight_map(guidance.weight)
                   .target_edge_length(edge_length).output_edge_is_constrained_map(is_marked)
                   .vertex_to_face_location_map(location).statistics(std::ref(statistics)));
  const bool is_length_in_range = edge_length > 0 && std::isfinite(edge_length);
  if(result)
  {
    expect(is_length_in_range && expectation.allows(FF::OK), "wrong input is refused");
    const std::string broken = broken_facts_of_quads(mesh, cad_mesh.is_feature, quads, is_marked, location);
    expect(broken.empty(), broken);
    expect(statistics.number_of_quads == num_faces(quads), "quads are counted");
    return;
  }
  expect(expectation.allows(result.error_code)
         || (result.error_code == FF::ERROR_WRONG_PARAMETER && !is_length_in_range),
         "an unexpected answer: " + result.message);
  expect(num_vertices(quads) == 0 && num_faces(quads) == 0 && statistics.number_of_quads == 77,
         "outputs stay untouched on failure");
}

// Features are found on every mesh with faces whose coordinates are finite, unless a parameter is out of range.
void check_feature_detection(const Cad_mesh<Mesh>& cad_mesh, const Feature_parameters& fuzz_parameters)
{
  const Mesh& mesh = cad_mesh.mesh;
  const auto is_feature = get(CGAL::dynamic_edge_property_t<int>(), mesh);
  for(const auto e : edges(mesh))
    put(is_feature, e, sentinel);
  const FF::Result result = FF::detect_feature_edges(
    mesh, is_feature, parameters::strong_angle_in_degrees(fuzz_parameters.strong_angle)
                        .weak_angle_in_degrees(fuzz_parameters.weak_angle)
                        .minimum_chain_length(fuzz_parameters.minimum_chain_length)
                        .close_gaps(fuzz_parameters.closes_gaps));
  const auto points = vertices(mesh);
  const bool is_mesh_finite = std::all_of(points.begin(), points.end(), [&](const auto v)
    { return mesh.is_isolated(v) || is_finite(mesh.point(v)); });
  expect(bool(result) == (fuzz_parameters.are_in_range() && is_mesh_finite && num_faces(mesh) > 0),
         "features: " + result.message);
  std::size_t number_of_ends = 0;
  for(const auto e : edges(mesh))
    expect(result ? !is_border(e, mesh) || get(is_feature, e) : get(is_feature, e) == sentinel,
           "border edges are features, and nothing is written on failure");
  if(!result)
    return;
  FF::dangling_feature_ends(mesh, is_feature, boost::make_function_output_iterator([&](const auto v)
  {
    std::size_t number_of_features = 0;
    for(const Halfedge h : halfedges_around_target(v, mesh))
      number_of_features += get(is_feature, edge(h, mesh));
    expect(number_of_features == 1, "one feature ends at a dangling end");
    ++number_of_ends;
  }));
  expect(number_of_ends <= num_vertices(mesh), "a dangling end is listed once");
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* const data, const std::size_t size)
{
  testing::GTEST_FLAG(throw_on_failure) = true;
  Byte_reader bytes(data, size);
  const Fuzz_parameters fuzz_parameters = read_parameters(bytes);
  const std::vector<Point> points = read_points(bytes);
  Cad_mesh<Mesh> cad_mesh(read_combinatorics(bytes, points.size()), false);
  for(const auto v : vertices(cad_mesh.mesh))
    cad_mesh.mesh.point(v) = points[static_cast<std::size_t>(cad_mesh.mesh.point(v).x())];

  const auto features = cad_mesh.features();
  if(fuzz_parameters.splits_chords)
    expect(bool(FF::split_chords(cad_mesh.mesh, features)), "chords of triangles are split");
  if(fuzz_parameters.splits_overconstrained_faces)
    expect(bool(FF::split_overconstrained_faces(cad_mesh.mesh, features)), "triangles are split");

  const Guidance guidance(cad_mesh.mesh, fuzz_parameters, bytes);
  if(fuzz_parameters.makes_quads)
  {
    check_quads(cad_mesh, fuzz_parameters, guidance,
                read_relative_edge_length(bytes) * longest_edge(cad_mesh.mesh));
    return 0;
  }
  check_feature_detection(cad_mesh, read_feature_parameters(bytes));
  const auto np = parameters_of(cad_mesh, fuzz_parameters, guidance);
  if(fuzz_parameters.is_guided)
    check_field(cad_mesh, fuzz_parameters, guidance, bytes,
                np.guiding_direction_map(guidance.direction).guiding_weight_map(guidance.weight));
  else
    check_field(cad_mesh, fuzz_parameters, guidance, bytes, np);
  return 0;
}
