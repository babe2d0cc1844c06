#ifndef TEST_FRAME_FIELDS_TEST_CUT_H
#define TEST_FRAME_FIELDS_TEST_CUT_H

#include "test_models.h"

#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/Statistics.h>

#include <array>
#include <limits>
#include <vector>

// What the tests know of a mesh and a field without the library's own arrays: halfedges are numbered 3f, 3f+1, 3f+2 in
// the order of faces(tm), from halfedge(f, tm) on. A halfedge stands for the corner at its target as well.
namespace test {

struct Field
{
  CGAL::Frame_fields::Result result;
  CGAL::Frame_fields::Statistics statistics;
  std::vector<double> alpha, rho;                  // per face
  std::vector<int> index, matching;                // per halfedge
  std::vector<double> omega;                       // per halfedge
  std::vector<std::array<Vector, 4> > branches;    // per face
};

class Cut
{
public:
  // `points` are those at the targets; `opposite` is -1 on constrained edges.
  Cut(std::vector<Point> points, std::vector<int> opposite);

  int number_of_faces() const { return static_cast<int>(points.size() / 3); }
  int number_of_halfedges() const { return static_cast<int>(points.size()); }
  int number_of_sectors() const { return static_cast<int>(theta.size()); }
  bool is_constrained(const int h) const { return opposite[h] < 0; }
  bool is_sharp(const int s, const double bound) const { return is_constrained_sector[s] && theta[s] < bound; }

  // r_ij across an unconstrained edge.
  double rotation(const std::vector<double>& alpha, const std::vector<int>& matching, int h) const;
  // The sum of values of halfedges counter-clockwise around each sector.
  std::vector<double> sums_around_sectors(const std::vector<double>& values) const;

  std::vector<Point> points;
  std::vector<int> opposite;
  std::vector<double> angle, phi, transport;  // per halfedge: at the corner, in the basis of the face, c_ij
  std::vector<int> sector;                    // per halfedge
  std::vector<int> patch;                     // per face
  std::vector<double> theta;                  // per sector
  std::vector<char> is_constrained_sector;
  int number_of_patches = 0;
};

inline int face_of(const int h) { return h / 3; }
inline int next_of(const int h) { return h % 3 == 2 ? h - 2 : h + 1; }
inline int previous_of(const int h) { return h % 3 == 0 ? h + 2 : h - 1; }

double largest(const std::vector<double>& values);
double largest_difference(const std::vector<double>& values, const std::vector<double>& expected);

// Poincare-Hopf: the sum of 4I over the sectors of a patch less four times the Euler characteristic of the cut patch.
// Fails if the index is not the same on all corners of a sector.
std::vector<int> poincare_hopf_defects(const Cut& cut, const std::vector<int>& index);

// |4I - index| of eq. (3), from an orthogonal field and its matching. The rotations must be less than a half turn
// across edges whose transport is a half turn, where its sign decides otherwise.
double largest_index_error(const Cut& cut, const std::vector<double>& alpha, const std::vector<int>& matching,
                           const std::vector<int>& index);

// The index of a field when another matching takes the place of its own.
std::vector<int> index_after_change(const Cut& cut, const Field& field, const std::vector<int>& new_matching);

// The angle between a constrained edge and the nearest branch: by angles in the face, and in space for faces without
// very small angles.
double largest_misalignment(const Cut& cut, const Field& field);
double largest_misalignment_in_space(const Cut& cut, const Field& field);

// The sectors whose natural index is prescribed: sharp corners below a bound, and blunt ones, of two quadrangles or
// more, that differ from a straight angle by more than another bound. The blunt ones do not count in a patch where all
// sectors are corners.
struct Corner_bounds
{
  double sharp, blunt = std::numeric_limits<double>::infinity();
};
std::vector<char> prescribed_corners(const Cut& cut, const Corner_bounds& bounds); // per sector

// K of the strategies `rings(k)` and `component`.
std::vector<double> rotation_demand_of_rings(const Cut& cut, int number_of_rings, const Corner_bounds& bounds);
std::vector<double> rotation_demand_of_component(const Cut& cut, const Corner_bounds& bounds);

// omega has least norm if it is orthogonal to every cycle, that is, lambda(target) - lambda(source) for some lambda on
// the sectors: the largest deviation from such a form.
double largest_deviation_from_gradient(const Cut& cut, const std::vector<double>& omega);

std::vector<int> constrained_sectors_below(const Cut& cut, double angle);
std::vector<int> index_of_sectors(const Cut& cut, const std::vector<int>& index);
int number_of_unmeshable_sectors(const Cut& cut, const std::vector<int>& index);

// A field before and after relaxation, at weight eps.
struct Relaxation
{
  double energy_before, energy_after; // 2 sum r^2, and sum r0^2 + r1^2 + eps sum (gamma0 - gamma1)^2
  double largest_gradient;            // at the branches that are not along a constrained edge
  double largest_fixed_gamma;         // at those that are
};
Relaxation relaxation(const Cut& cut, const Field& orthogonal, const Field& relaxed, double weight);

// The largest distance of a branch in `after` from the nearest branch of the same face in `before`.
double largest_branch_distance(const std::vector<std::array<Vector, 4> >& before,
                               const std::vector<std::array<Vector, 4> >& after);

// Angles that differ by less count as equal where they decide on a number of quadrangles.
constexpr double angle_tolerance = 1e-3;

// The default bounds.
constexpr double sharp_corner_bound = 135 * degree - angle_tolerance;
constexpr Corner_bounds corner_bounds{ sharp_corner_bound, 22.5 * degree + angle_tolerance };

// What holds for each field of the default bound: exact indices, alignment, and the largest skewness.
void expect_valid_field(const Cut& cut, const Field& field);

} // namespace test

#endif // TEST_FRAME_FIELDS_TEST_CUT_H
