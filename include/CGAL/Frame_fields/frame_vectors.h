// Copyright (c) 2026 The Frame_fields authors.
// All rights reserved.
//
// This file is part of Frame_fields, a package in the form of CGAL's (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Frame_fields authors

#ifndef CGAL_FRAME_FIELDS_FRAME_VECTORS_H
#define CGAL_FRAME_FIELDS_FRAME_VECTORS_H

#include <CGAL/Frame_fields/internal/surface/Mesh_reader.h>
#include <CGAL/Frame_fields/internal/surface/face_basis.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_type_config.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cmath>

/// \file frame_vectors.h

namespace CGAL {
namespace Frame_fields {
/*!
\ingroup PkgFrame_fieldsRef

computes the four branches of the frame of a face as unit vectors, at the angles
\f$ \alpha, \alpha + \pi/2 + \rho, \alpha + \pi \f$ and \f$ \alpha + 3\pi/2 + \rho \f$ from the direction of
`halfedge(f, tm)`, counter-clockwise about the normal of the face.

\tparam TriangleMesh a model of `FaceGraph`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the mesh
\param f a triangle of `tm` whose edges have a positive length; if its area is zero, the vectors lie in some plane
       through its edges
\param alpha the angle of the first branch, in radians
\param skewness the skewness \f$ \rho \f$, in radians
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{a property map associating points to the vertices of `tm`}
    \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%vertex_descriptor`
                   as key type and `%Point_3` as value type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
  \cgalParamNEnd
  \cgalParamNBegin{geom_traits}
    \cgalParamDescription{an instance of a geometric traits class}
    \cgalParamType{a class model of `Kernel`}
    \cgalParamDefault{a \cgal kernel deduced from the point type}
    \cgalParamExtra{All computation is in `double`; the vectors are built from `double` coordinates.}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return an `std::array` of four vectors of type `%Vector_3` of the geometric traits; branches 0 and 2, and 1 and 3, are
        opposite

\sa `cad_frame_field()`
*/
template <typename TriangleMesh, typename CGAL_NP_TEMPLATE_PARAMETERS>
#ifdef DOXYGEN_RUNNING
std::array<Vector_3, 4>
#else
std::array<typename CGAL::GetGeomTraits<TriangleMesh, CGAL_NP_CLASS>::type::Vector_3, 4>
#endif
frame_vectors(const TriangleMesh& tm, const typename boost::graph_traits<TriangleMesh>::face_descriptor f,
              const double alpha, const double skewness,
              const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  typedef internal::Mesh_reader<const TriangleMesh, CGAL_NP_CLASS> Reader;
  typedef typename Reader::Geom_traits::FT FT;

  const Reader reader(tm, np);
  const auto h = halfedge(f, tm);
  const internal::Face_basis basis = internal::face_basis(
    reader.coordinates(source(h, tm)), reader.coordinates(target(h, tm)), reader.coordinates(target(next(h, tm), tm)));

  const auto unit_vector = [&](const double angle, const double sign)
  {
    const double x = sign * std::cos(angle), y = sign * std::sin(angle);
    return reader.traits().construct_vector_3_object()(FT(x * basis[0][0] + y * basis[1][0]),
                                                       FT(x * basis[0][1] + y * basis[1][1]),
                                                       FT(x * basis[0][2] + y * basis[1][2]));
  };
  const double beta = alpha + CGAL_PI / 2 + skewness;
  return { unit_vector(alpha, 1), unit_vector(beta, 1), unit_vector(alpha, -1), unit_vector(beta, -1) };
}

} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_FRAME_VECTORS_H
