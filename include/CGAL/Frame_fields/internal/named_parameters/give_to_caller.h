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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_NAMED_PARAMETERS_GIVE_TO_CALLER_H
#define CGAL_FRAME_FIELDS_INTERNAL_NAMED_PARAMETERS_GIVE_TO_CALLER_H

#include <CGAL/Named_function_parameters.h>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Assigns a value to the object that the caller passed by `std::ref()` as a named parameter; does nothing if that
// parameter is not given.
template <typename Value, typename Reference>
void give_to_caller(const Value& value, const Reference reference)
{
  reference.get() = value;
}

template <typename Value>
void give_to_caller(const Value&, const CGAL::internal_np::Param_not_found) {}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_NAMED_PARAMETERS_GIVE_TO_CALLER_H
