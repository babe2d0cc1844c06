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

#ifndef CGAL_FRAME_FIELDS_PARAMETERS_H
#define CGAL_FRAME_FIELDS_PARAMETERS_H

#include <CGAL/Named_function_parameters.h>

/// \file parameters.h

namespace CGAL {
namespace Frame_fields {

/// \cond SKIP_IN_MANUAL
namespace internal {

#define CGAL_add_named_parameter(X, Y, Z) enum X { Y };
#include <CGAL/Frame_fields/internal/named_parameters/parameters_interface.h>
#undef CGAL_add_named_parameter

} // namespace internal

// A sequence of named parameters of CGAL with members that add the parameters of this package, and those of CGAL that
// this package reads, so that both kinds chain in any order. Every function of this package deduces the base class of
// CGAL.
template <typename T, typename Tag, typename Base = CGAL::internal_np::No_property>
struct Named_parameters
  : CGAL::Named_function_parameters<T, Tag, Base>
{
  typedef CGAL::Named_function_parameters<T, Tag, Base> Pack;

  Named_parameters(const T& value) : Pack(value) {}
  Named_parameters(const T& value, const Base& base) : Pack(value, base) {}

#define CGAL_add_named_parameter(X, Y, Z)                                            \
  template <typename K>                                                              \
  Named_parameters<K, internal::X, Pack> Z(const K& k) const                         \
  {                                                                                  \
    return Named_parameters<K, internal::X, Pack>(k, *this);                         \
  }
#include <CGAL/Frame_fields/internal/named_parameters/parameters_interface.h>
#undef CGAL_add_named_parameter

#define CGAL_add_named_parameter(X, Y, Z)                                            \
  template <typename K>                                                              \
  Named_parameters<K, CGAL::internal_np::X, Pack> Z(const K& k) const                \
  {                                                                                  \
    return Named_parameters<K, CGAL::internal_np::X, Pack>(k, *this);                \
  }
#include <CGAL/Frame_fields/internal/named_parameters/reused_parameters_interface.h>
#undef CGAL_add_named_parameter
};

/// \endcond

namespace parameters {

/// \cond SKIP_IN_MANUAL
#define CGAL_add_named_parameter(X, Y, Z)                                            \
  template <typename K>                                                              \
  Named_parameters<K, internal::X> Z(const K& k)                                     \
  {                                                                                  \
    return Named_parameters<K, internal::X>(k);                                      \
  }
#include <CGAL/Frame_fields/internal/named_parameters/parameters_interface.h>
#undef CGAL_add_named_parameter

#define CGAL_add_named_parameter(X, Y, Z)                                            \
  template <typename K>                                                              \
  Named_parameters<K, CGAL::internal_np::X> Z(const K& k)                            \
  {                                                                                  \
    return Named_parameters<K, CGAL::internal_np::X>(k);                             \
  }
#include <CGAL/Frame_fields/internal/named_parameters/reused_parameters_interface.h>
#undef CGAL_add_named_parameter
/// \endcond

/// \ingroup PkgFrame_fieldsRef
///
/// returns a sequence of named parameters that holds those of both arguments; a parameter that is in both takes its
/// value from `np2`, as the later one does in a chain.
///
/// Chains that start in `CGAL::parameters` cannot continue with the parameters of this package; this function brings
/// such a chain together with one that starts in `CGAL::Frame_fields::parameters`.
template <typename T1, typename Tag1, typename Base1, typename T2, typename Tag2>
Named_parameters<T2, Tag2, CGAL::Named_function_parameters<T1, Tag1, Base1> >
join(const CGAL::Named_function_parameters<T1, Tag1, Base1>& np1,
     const CGAL::Named_function_parameters<T2, Tag2>& np2)
{
  return { np2.v, np1 };
}

/// \cond SKIP_IN_MANUAL
template <typename T1, typename Tag1, typename Base1, typename T2, typename Tag2, typename Base2>
auto join(const CGAL::Named_function_parameters<T1, Tag1, Base1>& np1,
          const CGAL::Named_function_parameters<T2, Tag2, Base2>& np2)
{
  const auto joined_base = parameters::join(np1, static_cast<const Base2&>(np2));
  typedef typename decltype(joined_base)::Pack Pack;
  return Named_parameters<T2, Tag2, Pack>(np2.v, joined_base);
}
/// \endcond

} // namespace parameters
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_PARAMETERS_H
