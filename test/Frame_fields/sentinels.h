#ifndef TEST_FRAME_FIELDS_SENTINELS_H
#define TEST_FRAME_FIELDS_SENTINELS_H

#include "test_cad_mesh.h"

// Values that no function writes, by which a test sees what was not written.
namespace test {

constexpr int sentinel = -77;

template <typename Mesh>
void put_sentinels(const Mesh& mesh, const Maps<Mesh>& maps)
{
  for(const auto f : faces(mesh))
  {
    put(maps.alpha, f, sentinel);
    put(maps.rho, f, sentinel);
  }
  for(const auto h : halfedges(mesh))
  {
    put(maps.index, h, sentinel);
    put(maps.matching, h, sentinel);
    put(maps.omega, h, sentinel);
  }
}

template <typename Mesh>
bool hold_sentinels(const Mesh& mesh, const Maps<Mesh>& maps)
{
  for(const auto f : faces(mesh))
    if(get(maps.alpha, f) != sentinel || get(maps.rho, f) != sentinel)
      return false;
  for(const auto h : halfedges(mesh))
    if(get(maps.index, h) != sentinel || get(maps.matching, h) != sentinel || get(maps.omega, h) != sentinel)
      return false;
  return true;
}

} // namespace test

#endif // TEST_FRAME_FIELDS_SENTINELS_H
