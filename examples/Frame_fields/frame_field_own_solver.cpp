#include <CGAL/Frame_fields.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <Eigen/IterativeLinearSolvers>

#include <complex>
#include <functional>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;
namespace FF = CGAL::Frame_fields;
namespace PMP = CGAL::Polygon_mesh_processing;

// Eigen's conjugate gradients as a model of `PositiveDefiniteSolver`. What is called factor here keeps the matrix only.
template <typename Scalar_>
struct Iterative_solver
{
  typedef Scalar_ Scalar;
  typedef Eigen::SparseMatrix<Scalar> Matrix;
  typedef Eigen::Matrix<Scalar, Eigen::Dynamic, 1> Vector;

  bool factor(const FF::Hermitian_matrix<Scalar>& m)
  {
    matrix = std::make_unique<Matrix>(Eigen::Map<const Matrix>(m.size(), m.size(), m.row.size(), m.column_begin.data(),
                                                               m.row.data(), m.value.data()));
    return true;
  }

  bool solve(const std::vector<Scalar>& right_hand_side, std::vector<Scalar>& solution) const
  {
    Eigen::ConjugateGradient<Matrix, Eigen::Lower> solver(*matrix);
    solver.setTolerance(1e-12);
    const Vector x = solver.solve(Eigen::Map<const Vector>(right_hand_side.data(), right_hand_side.size()));
    solution.assign(x.data(), x.data() + x.size());
    return solver.info() == Eigen::Success;
  }

  std::unique_ptr<Matrix> matrix; // its address stays when the solver is moved
};

struct Iterative_solver_traits
{
  typedef Iterative_solver<double> Real_solver;
  typedef Iterative_solver<std::complex<double> > Complex_solver;
  typedef CGAL::Tag_true Has_independent_solvers; // patches may be solved in parallel

  Real_solver real_solver_object() const { return {}; }
  Complex_solver complex_solver_object() const { return {}; }
};

int main(int argc, char* argv[])
{
  const std::string filename = (argc > 1) ? argv[1] : "data/flange.off";
  Mesh mesh;
  if(!PMP::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << "Cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  auto is_feature = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_feature", false).first;
  auto alpha = mesh.add_property_map<Mesh::Face_index, double>("f:alpha").first;
  auto rho = mesh.add_property_map<Mesh::Face_index, double>("f:rho").first;
  auto index = mesh.add_property_map<Mesh::Halfedge_index, int>("h:index").first;
  FF::Statistics statistics;
  PMP::detect_sharp_edges(mesh, 40, is_feature);
  const auto features = FF::parameters::edge_is_constrained_map(is_feature);
  FF::Result result = FF::split_overconstrained_faces(mesh, features);
  if(result)
    result = FF::cad_frame_field(mesh, alpha, rho, index,
                                 features.sparse_linear_solver(Iterative_solver_traits())
                                         .statistics(std::ref(statistics)));
  std::cout << FF::get_error_message(result.error_code) << ": energy " << statistics.energy_relaxed << std::endl;
  return result ? EXIT_SUCCESS : EXIT_FAILURE;
}
