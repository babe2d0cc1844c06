#ifndef TEST_FRAME_FIELDS_COMPILED_STAGES_H
#define TEST_FRAME_FIELDS_COMPILED_STAGES_H

#include <CGAL/Frame_fields/Eigen_frame_field_solver_traits.h>
#include <CGAL/Frame_fields/internal/field/stages.h>
#include <CGAL/Frame_fields/internal/parameterization/compute_seamless_map.h>
#include <CGAL/Frame_fields/internal/quads/make_quads.h>
#include <CGAL/Frame_fields/internal/quads/quads_of_field.h>

#include <CGAL/tags.h>

#include <vector>

// The stages on arrays take longer to compile than most tests of them. They are the same for every mesh, so they are
// compiled once, in compiled_stages.cpp. The macro declares or defines them, by its first argument.
#define TEST_FRAME_FIELDS_STAGES(EXTERN_OR_NOTHING, Concurrency_tag)                                                   \
  EXTERN_OR_NOTHING template Patch_result prescribe_rotation<Concurrency_tag>(                                         \
    const Cut_surface&, const Options&, const Eigen_frame_field_solver_traits&, std::vector<double>&);                 \
  EXTERN_OR_NOTHING template std::vector<int> order_faces<Concurrency_tag>(                                            \
    const Cut_surface&, const Eigen_frame_field_solver_traits&);                                                       \
  EXTERN_OR_NOTHING template Patch_result compute_orthogonal_field<Concurrency_tag>(                                   \
    const Cut_surface&, const std::vector<double>&, const std::vector<int>&, const Eigen_frame_field_solver_traits&,   \
    std::vector<double>&);                                                                                             \
  EXTERN_OR_NOTHING template Patch_result compute_indices<Concurrency_tag>(                                            \
    const Cut_surface&, const std::vector<double>&, const std::vector<int>&, std::vector<int>&);                       \
  EXTERN_OR_NOTHING template Patch_result compute_matching_and_indices<Concurrency_tag>(                               \
    const Cut_surface&, const std::vector<double>&, const std::vector<double>&, const Options&, std::vector<int>&,     \
    std::vector<int>&, std::vector<Repaired_sector>&);                                                                 \
  EXTERN_OR_NOTHING template Patch_result relax<Concurrency_tag>(                                                      \
    const Cut_surface&, const std::vector<double>&, const std::vector<int>&, const Options&, const std::vector<int>&,  \
    const Eigen_frame_field_solver_traits&, std::vector<Branch_rotations>&, int&);                                     \
  EXTERN_OR_NOTHING template void compute_seamless_map<Concurrency_tag>(                                               \
    const Cut_surface&, const std::vector<double>&, const std::vector<double>&, const std::vector<int>&,               \
    const std::vector<int>&, const std::vector<double>&, const Eigen_frame_field_solver_traits&, Seamless_map&);

// The same of the stages of quads, in compiled_quad_stages.cpp.
#define TEST_FRAME_FIELDS_QUAD_STAGES(EXTERN_OR_NOTHING, Concurrency_tag)                                              \
  EXTERN_OR_NOTHING template Quad_complex make_quads<Concurrency_tag>(                                                 \
    const Cut_surface&, const Surface_embedding&, const std::vector<int>&, const Seamless_map&,                        \
    const Feature_network&, const Quad_request&, const std::vector<int>&, const Eigen_frame_field_solver_traits&,      \
    Quad_stage_timer&, Quad_statistics&);                                                                              \
  EXTERN_OR_NOTHING template Result make_quads_of_field<Concurrency_tag>(                                              \
    const Cut_surface&, const Surface_embedding&, double, const Quad_request&, const Options&,                         \
    const Eigen_frame_field_solver_traits&, const Mapped_field&, bool, Quad_stage_timer&, Made_quads&);

namespace CGAL {
namespace Frame_fields {
namespace internal {

TEST_FRAME_FIELDS_STAGES(extern, CGAL::Sequential_tag)
TEST_FRAME_FIELDS_STAGES(extern, CGAL::Parallel_tag)
TEST_FRAME_FIELDS_QUAD_STAGES(extern, CGAL::Sequential_tag)
TEST_FRAME_FIELDS_QUAD_STAGES(extern, CGAL::Parallel_tag)

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // TEST_FRAME_FIELDS_COMPILED_STAGES_H
