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


#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUANTIZATION_QUANTIZE_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUANTIZATION_QUANTIZE_H

#include <CGAL/Frame_fields/internal/quantization/Bidirected_network.h>
#include <CGAL/Frame_fields/internal/quantization/Quantization.h>
#include <CGAL/Frame_fields/internal/quantization/Quantizer.h>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The integers of a network; see `Quantizer`.
inline Quantization quantize(const Bidirected_network& network,
                             const Quantization_options& options = Quantization_options())
{
  return Quantizer(network, options).run();
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUANTIZATION_QUANTIZE_H
