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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_SURFACE_MESH_ELEMENTS_H
#define CGAL_FRAME_FIELDS_INTERNAL_SURFACE_MESH_ELEMENTS_H

#include <boost/functional/hash.hpp>
#include <boost/iterator/iterator_facade.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <iostream>
#include <memory>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The number of an element of a mesh, one type per kind of element.
template <typename Kind>
struct Element_index
{
  int value = -1;

  Element_index() = default;
  explicit Element_index(const int v) : value(v) {}

  friend bool operator==(const Element_index a, const Element_index b) { return a.value == b.value; }
  friend bool operator!=(const Element_index a, const Element_index b) { return a.value != b.value; }
  friend bool operator<(const Element_index a, const Element_index b) { return a.value < b.value; }
  friend std::size_t hash_value(const Element_index i) { return boost::hash<int>()(i.value); }
  friend std::ostream& operator<<(std::ostream& out, const Element_index i) { return out << i.value; }
};

// Runs over the elements 0, 1, 2, ...
template <typename Index>
class Element_iterator
  : public boost::iterator_facade<Element_iterator<Index>, Index, boost::random_access_traversal_tag, Index>
{
public:
  Element_iterator() = default;
  explicit Element_iterator(const int value) : m_value(value) {}

private:
  friend class boost::iterator_core_access;

  Index dereference() const { return Index(m_value); }
  bool equal(const Element_iterator& other) const { return m_value == other.m_value; }
  void increment() { ++m_value; }
  void decrement() { --m_value; }
  void advance(const std::ptrdiff_t n) { m_value += static_cast<int>(n); }
  std::ptrdiff_t distance_to(const Element_iterator& other) const { return other.m_value - m_value; }

  int m_value = 0;
};

// A property map with an array of values by the number of their element. The map refers to the array of another object,
// or shares one with its copies. An element without an entry has the value `Value()`. As put() may enlarge the array,
// only one thread may write.
template <typename Index, typename Value, typename Stored = Value>
class Element_map
{
public:
  typedef Index key_type;
  typedef Value value_type;
  typedef Value reference;
  typedef boost::read_write_property_map_tag category;

  // Makes an empty array that copies of the map share.
  Element_map() : m_values(std::make_shared<std::vector<Stored> >()) {}

  // Refers to an array that must outlive the map.
  explicit Element_map(std::vector<Stored>& values) : m_values(&values, [](std::vector<Stored>*) {}) {}

  friend Value get(const Element_map& map, const Index i)
  {
    const std::size_t place = static_cast<std::size_t>(i.value);
    return place < map.m_values->size() ? static_cast<Value>((*map.m_values)[place]) : Value();
  }

  friend void put(const Element_map& map, const Index i, const Value& value)
  {
    const std::size_t place = static_cast<std::size_t>(i.value);
    if(place >= map.m_values->size())
      map.m_values->resize(place + 1);
    (*map.m_values)[place] = static_cast<Stored>(value);
  }

private:
  std::shared_ptr<std::vector<Stored> > m_values;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_SURFACE_MESH_ELEMENTS_H
