#include "compiled_stages.h"

namespace CGAL {
namespace Frame_fields {
namespace internal {

TEST_FRAME_FIELDS_QUAD_STAGES(, CGAL::Sequential_tag)
TEST_FRAME_FIELDS_QUAD_STAGES(, CGAL::Parallel_tag)

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL
