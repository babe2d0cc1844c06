#ifndef BENCHMARK_FRAME_FIELDS_FIELD_ZEROS_H
#define BENCHMARK_FRAME_FIELDS_FIELD_ZEROS_H

// Where the singularities of a field in the plane are, finer than the vertices that carry their indices.

#include "planar_meshes.h"

#include <CGAL/Frame_fields/Eigen_frame_field_solver_traits.h>
#include <CGAL/Frame_fields/internal/named_parameters/options.h>
#include <CGAL/Frame_fields/internal/field/orthogonal_field.h>
#include <CGAL/Frame_fields/internal/field/stages.h>
#include <CGAL/Frame_fields/internal/maps/Stage_mesh.h>

#include <CGAL/Named_function_parameters.h>

#include <Eigen/Dense>

#include <cmath>
#include <complex>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

// The orthogonal field before its complex numbers z are brought to unit length. A singularity of the field is a zero
// of z. In the faces around a singular sector, z is taken along the fan into one face, z_i = z_j exp(4i (c_ij -
// omega_ij)), and there fitted by the linear function of the plane with the least sum of squares. Around a closed
// sector the way back does not quite lead to the same value; what is missing is shared by all dual edges of the fan.
namespace internal = CGAL::Frame_fields::internal;

class Field_zeros
{
public:
  template <typename T, typename Tag, typename Base>
  Field_zeros(const Mesh& mesh, const CGAL::Named_function_parameters<T, Tag, Base>& np)
    : m_sector(mesh.num_halfedges(), -1)
  {
    typedef CGAL::Named_function_parameters<T, Tag, Base> Pack;
    const internal::Options options = internal::options_from(np);
    internal::Stage_mesh<Mesh, Pack> stage_mesh(mesh, np);
    const CGAL::Frame_fields::Result result = internal::check_and_cut(options, stage_mesh);
    if(!result)
      throw std::runtime_error(result.message);
    const auto& cut_mesh = stage_mesh.cut_mesh();
    cut_mesh.for_each_halfedge([&](const Mesh::Halfedge_index h, const int i)
    {
      if(i >= 0)
        m_sector[h] = cut_mesh.surface().sector[i];
    });
    for(const Mesh::Face_index f : cut_mesh.face_descriptors())
      m_centroids.push_back(centroid(mesh, f));
    m_surface = cut_mesh.surface();
    solve(options);
  }

  // The zero next to the sector at the target of a halfedge; nothing if its fan has less than three faces.
  std::optional<Point_2> zero_at(const Mesh::Halfedge_index h) const
  {
    std::vector<Point_2> places;
    std::vector<std::complex<double> > values;
    for(const Transported_face& face : fan(m_sector[h]))
    {
      places.push_back(m_centroids[face.face]);
      values.push_back(m_z[face.face] * std::polar(1., face.angle));
    }
    return places.size() < 3 ? std::nullopt : zero_of_linear_fit(places, values);
  }

private:
  struct Transported_face
  {
    int face;
    double angle; // what takes z into the first face of the fan
  };

  static Point_2 centroid(const Mesh& mesh, const Mesh::Face_index f)
  {
    const auto point = [&](const Mesh::Vertex_index v) { return Point_2(mesh.point(v).x(), mesh.point(v).y()); };
    const Mesh::Halfedge_index h = mesh.halfedge(f);
    return CGAL::centroid(point(mesh.source(h)), point(mesh.target(h)), point(mesh.target(mesh.next(h))));
  }

  void solve(const internal::Options& options)
  {
    const CGAL::Frame_fields::Eigen_frame_field_solver_traits solver_traits;
    std::vector<double> omega;
    internal::prescribe_rotation<CGAL::Sequential_tag>(m_surface, options, solver_traits, omega);
    const std::vector<int> face_order = internal::order_faces<CGAL::Sequential_tag>(m_surface, solver_traits);
    m_z.resize(m_surface.number_of_faces());
    for(const internal::Patch& patch : m_surface.patches)
    {
      const internal::Orthogonal_field_system system(m_surface, patch, omega, face_order);
      auto solver = solver_traits.complex_solver_object();
      std::vector<std::complex<double> > unknowns;
      if(!internal::factor_and_solve(solver, system.matrix(), system.right_hand_side(), unknowns))
        throw std::runtime_error("the orthogonal field was not found");
      for(int f = patch.faces.begin_index; f < patch.faces.end_index; ++f)
        m_z[f] = system.unknown(f) < 0 ? std::polar(1., 4 * internal::aligned_alpha(m_surface, f))
                                       : unknowns[system.unknown(f)];
    }
    m_transport_angle.resize(m_surface.number_of_halfedges(), 0);
    for(int e = 0; e < m_surface.number_of_dual_edges(); ++e)
    {
      m_transport_angle[m_surface.dual_edges[e].halfedge] = 4 * (m_surface.transport[e] - omega[e]);
      m_transport_angle[m_surface.dual_edges[e].opposite] = -4 * (m_surface.transport[e] - omega[e]);
    }
  }

  std::vector<Transported_face> fan(const int sector) const
  {
    std::vector<Transported_face> result;
    double angle = 0;
    internal::for_each_corner(m_surface.opposite, m_surface.first_corner[sector], [&](const int corner)
    {
      result.push_back({ internal::face_of(corner), angle });
      angle += m_transport_angle[corner];
    });
    if(!m_surface.is_constrained_sector(sector))
    {
      const double missing = std::remainder(angle, 2 * CGAL_PI);
      for(std::size_t k = 0; k < result.size(); ++k)
        result[k].angle -= missing * static_cast<double>(k) / static_cast<double>(result.size());
    }
    return result;
  }

  static std::optional<Point_2> zero_of_linear_fit(const std::vector<Point_2>& places,
                                                   const std::vector<std::complex<double> >& values)
  {
    Eigen::MatrixXd matrix(places.size(), 3), right_hand_side(places.size(), 2);
    for(std::size_t k = 0; k < places.size(); ++k)
    {
      matrix.row(k) << 1, places[k].x(), places[k].y();
      right_hand_side.row(k) << values[k].real(), values[k].imag();
    }
    const Eigen::MatrixXd fit = matrix.colPivHouseholderQr().solve(right_hand_side);
    const Eigen::Matrix2d gradient = fit.bottomRows<2>().transpose();
    const Eigen::Vector2d zero = gradient.inverse() * Eigen::Vector2d(-fit(0, 0), -fit(0, 1));
    return zero.allFinite() ? std::optional<Point_2>(Point_2(zero.x(), zero.y())) : std::nullopt;
  }

  internal::Cut_surface m_surface;
  std::vector<int> m_sector;                 // per halfedge of the mesh
  std::vector<Point_2> m_centroids;          // per face of the surface
  std::vector<std::complex<double> > m_z;    // per face of the surface
  std::vector<double> m_transport_angle;     // per halfedge of the surface
};

#endif // BENCHMARK_FRAME_FIELDS_FIELD_ZEROS_H
