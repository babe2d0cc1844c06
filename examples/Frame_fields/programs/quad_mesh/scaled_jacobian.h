#ifndef FRAME_FIELDS_PROGRAMS_SCALED_JACOBIAN_H
#define FRAME_FIELDS_PROGRAMS_SCALED_JACOBIAN_H

#include "../shared/Mesh.h"

#include <CGAL/Kernel/global_functions_3.h>

#include <algorithm>
#include <array>
#include <cmath>

inline Vector unit(const Vector& vector)
{
  const double length = std::sqrt(vector.squared_length());
  return length > 0 ? vector / length : vector;
}

// The smallest sine of the corners of a quadrangle, seen along the normal of its diagonals, as Verdict defines it.
inline double scaled_jacobian(const Mesh& mesh, const Face f)
{
  std::array<Point, 4> p;
  Halfedge h = mesh.halfedge(f);
  for(Point& point : p)
  {
    point = mesh.point(mesh.target(h));
    h = mesh.next(h);
  }
  const Vector normal = unit(CGAL::cross_product(Vector(p[0], p[2]), Vector(p[1], p[3])));
  double result = 1;
  for(const int k : { 0, 1, 2, 3 })
  {
    const Vector to_next = unit(Vector(p[k], p[(k + 1) % 4])), to_previous = unit(Vector(p[k], p[(k + 3) % 4]));
    result = (std::min)(result, normal * CGAL::cross_product(to_next, to_previous));
  }
  return result;
}

#endif // FRAME_FIELDS_PROGRAMS_SCALED_JACOBIAN_H
