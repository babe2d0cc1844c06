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

#ifndef CGAL_FRAME_FIELDS_ERROR_CODE_H
#define CGAL_FRAME_FIELDS_ERROR_CODE_H

#include <CGAL/Frame_fields/internal/surface/strict_floating_point.h>

#include <string>

/// \file Error_code.h

namespace CGAL {
namespace Frame_fields {

// Curses and other libraries define a macro of this name. It is undefined here and restored below. Where it is 0, `OK`
// has the value of the enumerator then, too.
#pragma push_macro("OK")
#undef OK

/// \ingroup PkgFrame_fieldsEnums
///
/// lists what can keep a function of this package from producing its output.
enum Error_code
{
  OK,                                ///< Success
  ERROR_EMPTY_MESH,                  ///< The mesh has no face
  ERROR_MESH_TOO_LARGE,              ///< The mesh has more than 2^31 / 6 faces
  ERROR_NON_TRIANGULAR_MESH,         ///< A face is not a triangle
  ERROR_NON_FINITE_COORDINATE,       ///< A coordinate is infinite or not a number
  ERROR_ZERO_LENGTH_EDGE,            ///< The two ends of an edge have the same coordinates
  ERROR_OVERCONSTRAINED_FACE,        ///< A face has more than one constrained edge
  ERROR_WRONG_PARAMETER,             ///< A parameter is out of its range, most often a named one
  ERROR_WRONG_FIELD,                 ///< A map read as input does not hold what it must
  ERROR_POINCARE_HOPF,               ///< The index targets of a patch do not sum to its Euler characteristic
  ERROR_NO_RECEIVING_SECTOR,         ///< The rotation taken from a sharp corner finds no sector to go to
  ERROR_CANNOT_SOLVE_LINEAR_SYSTEM,  ///< The linear solver failed
  ERROR_INCONSISTENT_HALFEDGES,      ///< Opposite halfedges, or the halfedges around a face, contradict one another
  ERROR_MESH_CHANGED,                ///< The mesh of a `Cut_triangle_mesh` is not the same as when it was cut
  ERROR_NON_QUADRANGULAR_MESH        ///< A face is not a quad
};

/// \ingroup PkgFrame_fieldsEnums
///
/// returns the sentence that describes an error code.
/// \param error_code a value of `Error_code`
inline const char* get_error_message(int error_code)
{
  switch(error_code)
  {
    case OK:                               return "Success";
    case ERROR_EMPTY_MESH:                 return "The mesh has no face";
    case ERROR_MESH_TOO_LARGE:             return "The mesh has too many faces for 32-bit indices";
    case ERROR_NON_TRIANGULAR_MESH:        return "A face is not a triangle";
    case ERROR_NON_FINITE_COORDINATE:      return "A coordinate is infinite or not a number";
    case ERROR_ZERO_LENGTH_EDGE:           return "An edge has length zero";
    case ERROR_OVERCONSTRAINED_FACE:       return "A face has more than one constrained edge";
    case ERROR_WRONG_PARAMETER:            return "A named parameter is out of its range";
    case ERROR_WRONG_FIELD:                return "A map read as input does not hold what it must";
    case ERROR_POINCARE_HOPF:              return "Index targets do not sum to the Euler characteristic";
    case ERROR_NO_RECEIVING_SECTOR:        return "The rotation taken from a sharp corner finds no sector to go to";
    case ERROR_CANNOT_SOLVE_LINEAR_SYSTEM: return "The linear solver failed";
    case ERROR_INCONSISTENT_HALFEDGES:     return "The halfedges of the mesh contradict one another";
    case ERROR_MESH_CHANGED:               return "The mesh has changed since it was cut";
    case ERROR_NON_QUADRANGULAR_MESH:      return "A face is not a quad";
  }
  return "Unknown error";
}

/// \ingroup PkgFrame_fieldsRef
///
/// is the return type of the functions of this package: an error code, and on failure a message that names the element
/// at fault. A face is named by its place in the order of `faces(tm)`, counted from 0, and by the coordinates of one of
/// its vertices. When `error_code` is not `OK`, no output map was written and no output iterator was advanced.
struct [[nodiscard]] Result
{
  /// `OK` or the reason for the failure
  Error_code error_code = OK;

  /// empty on success, otherwise `get_error_message(error_code)` and the element at fault
  std::string message;

  /// returns `true` on success.
  explicit operator bool() const { return error_code == OK; }
};

#pragma pop_macro("OK")

namespace internal {

inline Result failure(const Error_code error_code, const std::string& element)
{
  return { error_code, std::string(get_error_message(error_code)) + ": " + element };
}

inline Result wrong_parameter(const std::string& name, const double value, const std::string& range)
{
  return failure(ERROR_WRONG_PARAMETER, name + " is " + std::to_string(value) + " and must be " + range);
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_ERROR_CODE_H
