#pragma once
#include <burin/surface/triangle_mesh.h>

#include <string>

namespace burin::test {

/// What CGAL finds wrong with a mesh that should be closed, a manifold, and not intersect itself; empty where
/// that is nothing.
std::string mesh_fault(const TriangleMesh& mesh);

}  // namespace burin::test
