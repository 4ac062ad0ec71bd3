#pragma once
#include <burin/surface/mesh_file.h>
#include <burin/surface/polygon_mesh.h>

#include <optional>
#include <string>

#include "support/shared_data.h"

namespace burin::test {

inline constexpr auto catmull_clark = SubdivisionScheme::catmull_clark;
inline constexpr auto loop = SubdivisionScheme::loop;

inline PolygonMesh tetrahedron() {
  PolygonMesh cage;
  cage.positions = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  cage.face_sizes = {3, 3, 3, 3};
  cage.face_vertices = {0, 1, 2, 0, 2, 3, 0, 3, 1, 1, 3, 2};
  return cage;
}

/// cells x cells unit squares in the plane z = 0, normal +z, vertex (x, y) number y * (cells + 1) + x.
inline PolygonMesh plate(Index cells) {
  PolygonMesh cage;
  for (Index y = 0; y <= cells; ++y)
    for (Index x = 0; x <= cells; ++x)
      cage.positions.emplace_back(static_cast<float>(x), static_cast<float>(y), 0.0F);
  for (Index y = 0; y < cells; ++y)
    for (Index x = 0; x < cells; ++x) {
      const Index first = y * (cells + 1) + x;
      cage.face_sizes.push_back(4);
      for (const Index vertex : {first, first + 1, first + cells + 2, first + cells + 1})
        cage.face_vertices.push_back(vertex);
    }
  return cage;
}

/// The mesh of the shared data with this name; nothing where the data is absent.
inline std::optional<PolygonMesh> shared_mesh(const std::string& name) {
  const auto path = shared_data("meshes/" + name);
  if (!path) return std::nullopt;
  return read_mesh(*path);
}

}  // namespace burin::test
