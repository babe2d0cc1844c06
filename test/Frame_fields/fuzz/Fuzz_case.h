#ifndef TEST_FRAME_FIELDS_FUZZ_FUZZ_CASE_H
#define TEST_FRAME_FIELDS_FUZZ_FUZZ_CASE_H

#include "../test_cad_mesh.h"

#include <CGAL/Frame_fields/Edge_weighting.h>
#include <CGAL/Frame_fields/Support_strategy.h>

#include <cstddef>
#include <cstdint>
#include <vector>

// What the fuzzer makes of its bytes; make_corpus.py writes the same format.
namespace test {

// Reads zeros when the bytes are used up.
class Byte_reader
{
public:
  Byte_reader(const std::uint8_t* const data, const std::size_t size) : m_at(data), m_end(data + size) {}

  unsigned int byte() { return m_at == m_end ? 0 : *m_at++; }
  unsigned int below(const unsigned int bound) { return byte() % bound; }
  bool is_at_end() const { return m_at == m_end; }

private:
  const std::uint8_t* m_at;
  const std::uint8_t* m_end;
};

struct Fuzz_parameters
{
  CGAL::Frame_fields::Support_strategy support_strategy = CGAL::Frame_fields::Support_strategy::none();
  CGAL::Frame_fields::Edge_weighting edge_weighting = CGAL::Frame_fields::Edge_weighting::UNIFORM;
  double sharp_corner_bound = 0, maximum_skewness = 0, orthogonality_weight = 0, orthogonality_length = 0;
  bool relaxes = true, repairs = true, splits_chords = false, splits_overconstrained_faces = true, is_guided = false,
       has_index_targets = false, makes_quads = false;
};

Fuzz_parameters read_parameters(Byte_reader& bytes);

struct Feature_parameters
{
  double strong_angle = 0, weak_angle = 0, minimum_chain_length = 0;
  bool closes_gaps = false;

  bool are_in_range() const
  {
    return weak_angle >= 0 && weak_angle <= strong_angle && strong_angle <= 180 && minimum_chain_length >= 0;
  }
};

struct Streamline_parameters
{
  double spacing = 0, separation = 0, maximum_length = 0; // the spacing in terms of the longest edge, 0 by default

  bool have_default_spacing() const { return spacing == 0; }
  bool are_in_range() const { return separation >= 0 && separation <= 1 && maximum_length > 0; }
};

// The length of the edges of quads, in terms of the longest edge of the mesh.
double read_relative_edge_length(Byte_reader& bytes);

// Of the bytes that are left; zeros stand for usual values.
Feature_parameters read_feature_parameters(Byte_reader& bytes);
Streamline_parameters read_streamline_parameters(Byte_reader& bytes);

// A mesh without coordinates yet: the points are (i, 0, 0) for the i-th one. A soup that is no oriented manifold mesh
// is repaired by CGAL's functions for polygon soups, which may remove triangles and duplicate points.
Model read_combinatorics(Byte_reader& bytes, std::size_t number_of_points);

std::vector<Point> read_points(Byte_reader& bytes);

} // namespace test

#endif // TEST_FRAME_FIELDS_FUZZ_FUZZ_CASE_H
