#pragma once
#include <burin/base/vector.h>
#include <burin/host/c/burin.h>
#include <burin/surface/triangle_mesh.h>

#include <vector>

/// A mesh of the library's.
struct burin_triangles {
  burin::TriangleMesh mesh;
  std::vector<burin::Vec4f> colours{};  ///< [vertex], or empty
  std::vector<float> masks{};           ///< the same
  burin::Vec3d origin = burin::Vec3d::Zero();
};
