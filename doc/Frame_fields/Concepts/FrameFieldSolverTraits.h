/*!
\ingroup PkgFrame_fieldsConcepts
\cgalConcept

The concept `FrameFieldSolverTraits` describes what the functions of this package need of linear algebra: solvers of
sparse positive definite systems, one for real symmetric and one for complex hermitian matrices. An object of this type
is passed as named parameter `sparse_linear_solver`.

Every patch of the surface is solved by solver objects of its own, which are asked for anew for each system.

\cgalRefines{CopyConstructible}

\cgalHasModelsBegin
\cgalHasModels{CGAL::Frame_fields::Eigen_frame_field_solver_traits}
\cgalHasModels{CGAL::Frame_fields::Cholmod_frame_field_solver_traits}
\cgalHasModels{CGAL::Frame_fields::Amgcl_frame_field_solver_traits}
\cgalHasModels{CGAL::Frame_fields::Automatic_frame_field_solver_traits}
\cgalHasModels{CGAL::Frame_fields::Linear_algebra_frame_field_solver_traits}
\cgalHasModelsEnd

\sa `FrameFieldOrderingSolverTraits`
\sa `PositiveDefiniteSolver`
*/
class FrameFieldSolverTraits
{
public:

/// \name Types
/// @{

/*!
The solver of real symmetric systems, a model of `PositiveDefiniteSolver` whose `Scalar` is `double`. It is used for the
prescribed rotation and for the relaxation. The presence of this member type is what distinguishes a model of this
concept from a model of `SparseLinearAlgebraWithFactorTraits_d`, which is accepted in its place.
*/
typedef unspecified_type Real_solver;

/*!
The solver of complex hermitian systems, a model of `PositiveDefiniteSolver` whose `Scalar` is `std::complex<double>`.
It is used for the orthogonal field. `CGAL::Frame_fields::Doubled_real_solver` makes one of a real solver.
*/
typedef unspecified_type Complex_solver;

/*!
`CGAL::Tag_true` if different solver objects may be used at the same time in different threads, and if
`real_solver_object()` and `complex_solver_object()` may be called at the same time; otherwise `CGAL::Tag_false`, and
then the patches are solved one after the other.
*/
typedef unspecified_type Has_independent_solvers;

/// @}

/// \name Operations
/// @{

/*!
returns a solver of real symmetric systems.
*/
Real_solver real_solver_object() const;

/*!
returns a solver of complex hermitian systems.
*/
Complex_solver complex_solver_object() const;

/// @}

}; /* end FrameFieldSolverTraits */
