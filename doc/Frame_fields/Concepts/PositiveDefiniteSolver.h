/*!
\ingroup PkgFrame_fieldsConcepts
\cgalConcept

The concept `PositiveDefiniteSolver` describes a solver of linear systems with one sparse hermitian positive definite
matrix (symmetric, for real scalars) and any number of right-hand sides.

A solver need not be more accurate than iterative ones are: the functions of this package check every row of a
solution, and ask the solver again for what is left in those that do not hold up to \f$ 10^{-12} \f$ of their terms, up
to 100 times. Direct solvers suit best: the matrix of a patch without constrained edges is shifted by only
\f$ 10^{-9} \f$ from a positive semi-definite one.

\cgalRefines{MoveConstructible}

\cgalHasModelsBegin
\cgalHasModels{CGAL::Frame_fields::Eigen_positive_definite_solver}
\cgalHasModels{CGAL::Frame_fields::Cholmod_positive_definite_solver}
\cgalHasModels{CGAL::Frame_fields::Amgcl_positive_definite_solver}
\cgalHasModels{CGAL::Frame_fields::Automatic_positive_definite_solver}
\cgalHasModels{CGAL::Frame_fields::Linear_algebra_real_solver}
\cgalHasModels{CGAL::Frame_fields::Doubled_real_solver}
\cgalHasModelsEnd

\sa `FrameFieldSolverTraits`
*/
class PositiveDefiniteSolver
{
public:

/// \name Types
/// @{

/*!
The type of the entries, `double` or `std::complex<double>`.
*/
typedef unspecified_type Scalar;

/// @}

/// \name Operations
/// @{

/*!
factors `matrix`, which has at least one row, and returns whether this succeeded. After the return the solver must not
refer to `matrix` any more.
*/
bool factor(const CGAL::Frame_fields::Hermitian_matrix<Scalar>& matrix);

/*!
resizes `solution` to the size of `right_hand_side`, sets it such that the factored matrix times `solution` is
`right_hand_side`, and returns whether this succeeded. It is called after a successful `factor()`, maybe several times.
A solution with an entry that is not finite counts as a failure, whatever is returned.
*/
bool solve(const std::vector<Scalar>& right_hand_side, std::vector<Scalar>& solution);

/// @}

}; /* end PositiveDefiniteSolver */
