#include "field_contract.h"

#include <CGAL/Frame_fields/Error_code.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace test {

namespace {

constexpr double default_maximum_skewness = 0.45 * 180 * degree;

bool is_finite(const std::vector<double>& values)
{
  return std::all_of(values.begin(), values.end(), [](const double x) { return std::isfinite(x); });
}

} // namespace

std::string broken_facts_of_any_field(const Cut& cut, const Field& field, const double maximum_skewness)
{
  std::ostringstream broken;
  if(!is_finite(field.alpha) || !is_finite(field.rho) || !is_finite(field.omega))
    broken << "an output is not finite\n";
  const std::vector<int> defects = poincare_hopf_defects(cut, field.index);
  for(int patch = 0; patch < cut.number_of_patches; ++patch)
    if(defects[patch] != 0)
      broken << "the indices of patch " << patch << " exceed its Euler characteristic by " << defects[patch] << "/4\n";
  const double misalignment = largest_misalignment(cut, field);
  if(!(misalignment < 1e-9))
    broken << "a frame is " << misalignment << " away from its constrained edge\n";
  if(!(largest(field.rho) <= maximum_skewness + 1e-12))
    broken << "the skewness " << largest(field.rho) << " exceeds " << maximum_skewness << "\n";
  return broken.str();
}

std::string unmeshable_sectors(const Cut& cut, const std::vector<int>& index)
{
  std::vector<int> patch_of_sector(cut.number_of_sectors()), number_of_sectors(cut.number_of_patches, 0);
  for(int h = 0; h < cut.number_of_halfedges(); ++h)
    patch_of_sector[cut.sector[h]] = cut.patch[face_of(h)];
  for(const int patch : patch_of_sector)
    ++number_of_sectors[patch];

  std::ostringstream unmeshable;
  const std::vector<int> sector_index = index_of_sectors(cut, index);
  for(int s = 0; s < cut.number_of_sectors(); ++s)
    if(cut.is_constrained_sector[s] && sector_index[s] >= 2 && number_of_sectors[patch_of_sector[s]] >= 4)
      unmeshable << "a sector of angle " << cut.theta[s] << " has index " << sector_index[s] << "/4\n";
  return unmeshable.str();
}

std::string broken_facts(const Cut& cut, const Field& field)
{
  if(!field.result)
    return field.result.message + "\n";
  std::ostringstream broken;
  broken << broken_facts_of_any_field(cut, field, default_maximum_skewness);
  if(!(largest_misalignment_in_space(cut, field) < 1e-9))
    broken << "a branch is " << largest_misalignment_in_space(cut, field) << " away from its constrained edge\n";
  broken << unmeshable_sectors(cut, field.index);
  if(static_cast<std::size_t>(cut.number_of_patches) != field.statistics.number_of_patches)
    broken << field.statistics.number_of_patches << " patches instead of " << cut.number_of_patches << "\n";
  const std::size_t corners = constrained_sectors_below(cut, sharp_corner_bound).size();
  if(corners != field.statistics.number_of_sharp_corners)
    broken << field.statistics.number_of_sharp_corners << " sharp corners instead of " << corners << "\n";
  return broken.str();
}

} // namespace test
