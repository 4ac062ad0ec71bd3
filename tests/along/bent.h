#pragma once
#include <burin/along/along_parts.h>
#include <burin/surface/polygon_mesh.h>

#include <memory>
#include <utility>
#include <vector>

#include "support/charted.h"
#include "support/closed_curve.h"

namespace burin::test {

/// A stroke over a surface, to bend meshes along.
struct Laid {
  Charted charted;
  Chart chart;
  double radius;

  Laid(TriangleMesh mesh, double stroke_radius, const std::vector<Vec3d>& samples, bool closed = false)
      : charted(std::move(mesh)), radius(stroke_radius) {
    charted.builder.begin({.radius = AlongParts::chart_radii * radius});
    charted.curve = traced(CurveGround(charted.surface, charted.picker, charted.builder.base()),
                           charted.picker, radius, samples);
    if (closed) close(charted.curve);
    chart = charted.builder.draw(charted.curve).sorted();
  }

  SolidGround ground() const {
    return {charted.surface, chart, [this](Index v) { return charted.surface.positions[v]; }};
  }

  TriangleMesh bend(const AlongSettings& settings, const std::function<double(double)>& width = {},
                    bool mirrored = false) const {
    const SolidGround on = ground();
    return AlongParts(settings).bend({.ground = on, .radius = radius, .width = width, .mirrored = mirrored});
  }
};

inline MeshSource source(PolygonMesh mesh) {
  return {std::make_shared<const PolygonMesh>(std::move(mesh)), ""};
}

/// A box of these sizes in x, y and z from the origin, of six faces.
inline PolygonMesh box(double length, double height, double width) {
  PolygonMesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.positions.push_back(
        Vec3d((i & 1 ? 1 : 0) * length, (i & 2 ? 1 : 0) * height, (i & 4 ? 1 : 0) * width).cast<float>());
  mesh.face_sizes.assign(6, 4);
  mesh.face_vertices = {0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
  return mesh;
}

/// The four sides of such a box, open at both ends of x, with texture coordinates: u along, v around.
inline PolygonMesh pipe(double length, double height, double width) {
  PolygonMesh mesh = box(length, height, width);
  mesh.face_sizes.assign(4, 4);
  mesh.face_vertices = {0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3};
  // Around from y = z = 0 over z, then over y, back to 1.
  const auto v_of = [](Index corner, bool last) {
    switch (corner >> 1) {
      case 0:
        return last ? 1.F : 0.F;
      case 2:
        return 0.25F;
      case 3:
        return 0.5F;
      default:
        return 0.75F;
    }
  };
  for (std::size_t face = 0; face < 4; ++face)
    for (std::size_t i = 0; i < 4; ++i) {
      const Index corner = mesh.face_vertices[4 * face + i];
      mesh.corner_uv.emplace_back(corner & 1 ? 1.F : 0.F, v_of(corner, face == 0));
    }
  return mesh;
}

}  // namespace burin::test
