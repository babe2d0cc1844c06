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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_LAYOUT_FEATURE_NETWORK_H
#define CGAL_FRAME_FIELDS_INTERNAL_LAYOUT_FEATURE_NETWORK_H

#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// A maximal chain of constrained edges between two nodes, or a closed loop without node. The halfedges follow one
// another on one side of the chain; the other side has their twins in reverse order.
struct Feature_arc
{
  std::vector<int> halfedges;
  bool is_loop; // without node
};

// The feature and border edges as arcs between nodes. A vertex on constrained edges is a node if the number of these
// edges is not two, if one of its sectors has a nonzero index, or if the caller marked it.
struct Feature_network
{
  std::vector<Feature_arc> arcs;
  std::vector<int> arc;       // per halfedge: its arc, -1 if it is not constrained
  std::vector<int> place;     // per halfedge: its place in the list of its arc, or that of its twin; -1 likewise
  std::vector<char> is_node;  // per vertex of the surface's embedding
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_LAYOUT_FEATURE_NETWORK_H
