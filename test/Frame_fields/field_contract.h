#ifndef TEST_FRAME_FIELDS_FIELD_CONTRACT_H
#define TEST_FRAME_FIELDS_FIELD_CONTRACT_H

#include "test_cut.h"

#include <string>
#include <vector>

namespace test {

// What holds for the field of every mesh with the default parameters: one line for each fact that does not hold.
std::string broken_facts(const Cut& cut, const Field& field);

// The same for the facts that do not depend on the parameters.
std::string broken_facts_of_any_field(const Cut& cut, const Field& field, double maximum_skewness);

// Lists the sectors with 4I >= 2 on constrained edges in patches of at least four sectors: the repair leaves none.
std::string unmeshable_sectors(const Cut& cut, const std::vector<int>& index);

} // namespace test

#endif // TEST_FRAME_FIELDS_FIELD_CONTRACT_H
