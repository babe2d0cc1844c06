#include <CGAL/Frame_fields.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/version.h>

#if CGAL_VERSION_NR < 1060000000
#include <CGAL/Qt/Basic_viewer_qt.h>
#include <CGAL/Qt/init_ogl_context.h>
#elif __has_include(<CGAL/Basic_viewer.h>) // not yet in 6.0
#include <CGAL/Basic_viewer.h>
#else
#include <CGAL/Qt/Basic_viewer.h>
#endif

#include <cmath>
#include <cstdlib>

typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;
typedef Mesh::Property_map<Mesh::Face_index, double> Angle_map;

namespace FF = CGAL::Frame_fields;
namespace PMP = CGAL::Polygon_mesh_processing;

// The faces, and a little above each, so that it is not hidden, a cross: one direction in blue, the other one in red.
template <typename Scene>
void add_field(const Mesh& mesh, const Angle_map alpha, const Angle_map rho, Scene& scene)
{
  for(const Mesh::Face_index f : mesh.faces())
  {
    const auto h = mesh.halfedge(f);
    const Mesh::Point &p = mesh.point(mesh.source(h)), &q = mesh.point(mesh.target(h)),
                      &r = mesh.point(mesh.target(mesh.next(h)));
    scene.face_begin(CGAL::IO::Color(220, 220, 215));
    for(const Mesh::Point& corner : { p, q, r })
      scene.add_point_in_face(corner);
    scene.face_end();
    const double size = 0.4 * std::sqrt(PMP::face_area(f, mesh));
    const Mesh::Point center = CGAL::centroid(p, q, r) + 0.1 * size * PMP::compute_face_normal(f, mesh);
    const auto branch = FF::frame_vectors(mesh, f, alpha[f], rho[f]);
    scene.add_segment(center + size * branch[0], center + size * branch[2], CGAL::IO::blue());
    scene.add_segment(center + size * branch[1], center + size * branch[3], CGAL::IO::red());
  }
}

void show(const Mesh& mesh, const Angle_map alpha, const Angle_map rho)
{
#if CGAL_VERSION_NR >= 1060000000
  CGAL::Graphics_scene scene;
  add_field(mesh, alpha, rho, scene);
  CGAL::draw_graphics_scene(scene, "Frame field"); // no window if CGAL_TEST_SUITE is set
#else
  int argc = 1;
  char name[] = "draw_frame_field", *argv[] = { name, nullptr };
  CGAL::Qt::init_ogl_context(4, 3);
  QApplication application(argc, argv);
  CGAL::Basic_viewer_qt viewer(nullptr, "Frame field");
  add_field(mesh, alpha, rho, viewer);
  viewer.show();
  if(std::getenv("CGAL_TEST_SUITE") == nullptr)
    application.exec();
#endif
}

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(!PMP::IO::read_polygon_mesh((argc > 1) ? argv[1] : "data/flange.off", mesh))
    return EXIT_FAILURE;
  auto is_feature = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_feature").first;
  auto alpha = mesh.add_property_map<Mesh::Face_index, double>("f:alpha").first;
  auto rho = mesh.add_property_map<Mesh::Face_index, double>("f:rho").first;
  auto index = mesh.add_property_map<Mesh::Halfedge_index, int>("h:index").first;
  PMP::detect_sharp_edges(mesh, 40, is_feature);
  const auto features = FF::parameters::edge_is_constrained_map(is_feature);
  if(!FF::split_overconstrained_faces(mesh, features) || !FF::cad_frame_field(mesh, alpha, rho, index, features))
    return EXIT_FAILURE;
  show(mesh, alpha, rho);
}
