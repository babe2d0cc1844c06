/*!
\ingroup PkgFrame_fieldsConcepts
\cgalConcept

The concept `FrameFieldOrderingSolverTraits` refines `FrameFieldSolverTraits` for solvers that eliminate the unknowns in
the order of their numbers: it tells in which order that should be.

The unknowns of each system are numbered in the order that `elimination_order()` returns. It is called up to twice for
each patch: for the graph of the sectors, which the prescribed rotation needs if there are sharp corners, and for that
of the faces, whose order serves the orthogonal field and the relaxation. With a model of `FrameFieldSolverTraits`
alone, unknowns are numbered in the order of the mesh, and solvers find their own order.

\cgalRefines{FrameFieldSolverTraits}

\cgalHasModelsBegin
\cgalHasModels{CGAL::Frame_fields::Eigen_frame_field_solver_traits}
\cgalHasModels{CGAL::Frame_fields::Cholmod_frame_field_solver_traits}
\cgalHasModels{CGAL::Frame_fields::Automatic_frame_field_solver_traits}
\cgalHasModelsEnd
*/
class FrameFieldOrderingSolverTraits
{
public:

/*!
returns the numbers from 0 to `pattern.size() - 1` in the order in which the rows of a matrix with the entries of
`pattern` should be eliminated; the values of `pattern` have no meaning. If `Has_independent_solvers` is
`CGAL::Tag_true`, it may be called at the same time in different threads.
*/
std::vector<int> elimination_order(const CGAL::Frame_fields::Hermitian_matrix<float>& pattern) const;

}; /* end FrameFieldOrderingSolverTraits */
