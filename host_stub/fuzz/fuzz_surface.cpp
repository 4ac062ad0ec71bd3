// Makes the surfaces of trials by formulas.
#include "fuzz/fuzz_surface.h"

#include <burin/math/elementary.h>

#include <numbers>

#include "fuzz/draws.h"
#include "input/grid_mesh.h"

namespace burin {

Vec3d surface_point(const FuzzSurface& surface, double u, double v) {
  using std::numbers::pi;
  const double hill = surface.relief * math::sin(4 * u) * math::cos(5 * v), out = 1 + hill;
  // Neither goes all around: their borders do not touch.
  const double around = 0.9 * pi * u, up = 0.4 * pi * v;
  switch (surface.shape) {
    case FuzzSurface::Shape::tube:
      return {out * math::sin(around), v, out * math::cos(around)};
    case FuzzSurface::Shape::ball:
      return {out * math::cos(up) * math::sin(around), out * math::sin(up),
              out * math::cos(up) * math::cos(around)};
    default:
      return {u, v, hill};
  }
}

TriangleMesh surface_mesh(const FuzzSurface& surface) {
  TriangleMesh mesh = grid_mesh(surface.columns, surface.rows, [&](double u, double v) {
    return Vec3f(surface_point(surface, u, v).cast<float>());
  });
  Draws draws(surface.seed);
  std::erase_if(mesh.triangles, [&](const Triangle&) { return draws.between(0, 1) < surface.holes; });
  return mesh;
}

}  // namespace burin
