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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_NAMED_PARAMETERS_CONCURRENCY_H
#define CGAL_FRAME_FIELDS_INTERNAL_NAMED_PARAMETERS_CONCURRENCY_H

#include <CGAL/Frame_fields/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

namespace CGAL {

// Later versions of CGAL have a named parameter `concurrency_tag` of their own. In earlier ones, `concurrency_tag_t`
// names the type below, which no caller can give. In later ones CGAL's declaration hides it, as a declaration hides a
// name that is found through a using directive.
namespace Frame_fields {
namespace internal {
namespace missing_in_cgal {

struct concurrency_tag_t;

} // namespace missing_in_cgal
} // namespace internal
} // namespace Frame_fields

namespace internal_np {

using namespace Frame_fields::internal::missing_in_cgal;

} // namespace internal_np

namespace Frame_fields {
namespace internal {

// The tag given by the parameter of this package, or else by CGAL's, or else `Sequential_tag`.
template <typename NamedParameters>
struct Given_concurrency
{
  typedef typename CGAL::internal_np::Lookup_named_param_def<
    CGAL::internal_np::concurrency_tag_t, NamedParameters, CGAL::Sequential_tag>::type Tag_of_cgal;
  typedef typename CGAL::internal_np::Lookup_named_param_def<
    internal::concurrency_t, NamedParameters, Tag_of_cgal>::type type;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_NAMED_PARAMETERS_CONCURRENCY_H
