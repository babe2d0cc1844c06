#ifndef TEST_FRAME_FIELDS_MAP_CONTRACT_H
#define TEST_FRAME_FIELDS_MAP_CONTRACT_H

#include "test_cut.h"

#include <CGAL/number_type_config.h>

#include <cmath>
#include <cstddef>
#include <set>
#include <string>
#include <vector>

// What holds of the points of a seamless map, with nothing of the library: they have no more than 50 bits.
namespace test {

typedef Kernel::Point_2 Point_2;
typedef Kernel::Vector_2 Vector_2;

// Whose sign is exact: the rounding errors of both products are numbers, too.
inline double cross_product(const Vector_2& a, const Vector_2& b)
{
  const double product = a.x() * b.y(), other = a.y() * b.x();
  return product - other + (std::fma(a.x(), b.y(), -product) - std::fma(a.y(), b.x(), -other));
}

// `uv` is per halfedge, for the corner at its target.
inline std::string broken_facts_of_map(const Cut& cut, const std::vector<int>& index_of_sector,
                                       const std::vector<Point_2>& uv, const std::size_t number_of_uncertified_patches)
{
  const auto along = [&](const int h) { return uv[h] - uv[previous_of(h)]; };
  std::set<int> uncertified_patches;
  for(int h = 0; h < cut.number_of_halfedges(); ++h)
    if(!(cross_product(along(h), along(next_of(h))) > 0))
      uncertified_patches.insert(cut.patch[face_of(h)]);
  std::string broken;
  if(uncertified_patches.size() != number_of_uncertified_patches)
    broken += "the patches with faces that are not positively oriented are those without certificate; ";

  std::vector<double> turned(cut.number_of_sectors(), 0);
  std::vector<char> is_certified(cut.number_of_sectors(), false);
  bool are_at_origin = true, are_aligned = true, are_seamless = true;
  for(int h = 0; h < cut.number_of_halfedges(); ++h)
  {
    if(uncertified_patches.count(cut.patch[face_of(h)]) > 0)
    {
      are_at_origin = are_at_origin && uv[h] == Point_2(0, 0);
      continue;
    }
    const Vector_2 d = along(h), out = along(next_of(h));
    turned[cut.sector[h]] += std::atan2(cross_product(out, -d), out * -d);
    is_certified[cut.sector[h]] = true;
    if(cut.is_constrained(h))
    {
      are_aligned = are_aligned && (d.x() == 0) != (d.y() == 0);
      continue;
    }
    const Vector_2 e = along(cut.opposite[h]);
    are_seamless = are_seamless && (e == -d || e == d || e == Vector_2(-d.y(), d.x()) || e == Vector_2(d.y(), -d.x()));
  }
  bool are_indices_right = true;
  for(int s = 0; s < cut.number_of_sectors(); ++s)
  {
    const int quarter_turns = (cut.is_constrained_sector[s] ? 2 : 4) - index_of_sector[s];
    are_indices_right =
      are_indices_right && (!is_certified[s] || std::abs(turned[s] - quarter_turns * CGAL_PI / 2) < 1e-3);
  }
  if(!are_at_origin)
    broken += "corners without certified map are at the origin; ";
  if(!are_aligned)
    broken += "one coordinate stays along constrained edges; ";
  if(!are_seamless)
    broken += "charts differ by quarter turns and a translation; ";
  if(!are_indices_right)
    broken += "sectors turn as their indices say; ";
  return broken;
}

} // namespace test

#endif // TEST_FRAME_FIELDS_MAP_CONTRACT_H
