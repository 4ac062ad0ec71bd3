#pragma once
#include <burin/remesh/patch_mesh.h>

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

namespace burin {

struct EdgeMeshTraits : OpenMesh::DefaultTraits {
  VertexAttributes(OpenMesh::Attributes::Status);
  EdgeAttributes(OpenMesh::Attributes::Status);
  FaceAttributes(OpenMesh::Attributes::Status);
  HalfedgeAttributes(OpenMesh::Attributes::PrevHalfedge | OpenMesh::Attributes::Status);
  VertexTraits {
    burin::Vec3d position = burin::Vec3d::Zero();  // object units
    burin::Index kept = burin::no_index;
    double size = 0;      // of the edges that it should have, object units
    bool added = false;   // to make edges shorter
    bool chosen = false;  // may change now
    bool crease = false;
  };
};

/// A patch with its half-edges.
using EdgeMesh = OpenMesh::TriMesh_ArrayKernelT<EdgeMeshTraits>;

inline EdgeMesh::VertexHandle add_vertex(EdgeMesh& mesh, const Vec3d& position) {
  const EdgeMesh::VertexHandle vertex = mesh.new_vertex();
  mesh.data(vertex).position = position;
  return vertex;
}

/// Throws Error with the place where the triangles are no manifold.
EdgeMesh to_edges(const PatchMesh& patch);

/// Leaves out what was removed.
PatchMesh to_patch(EdgeMesh& mesh);

inline double length(const EdgeMesh& mesh, EdgeMesh::EdgeHandle edge) {
  const auto half = mesh.halfedge_handle(edge, 0);
  return (mesh.data(mesh.to_vertex_handle(half)).position - mesh.data(mesh.from_vertex_handle(half)).position)
      .norm();
}

inline Vec3d middle(const EdgeMesh& mesh, EdgeMesh::EdgeHandle edge) {
  const auto half = mesh.halfedge_handle(edge, 0);
  return (mesh.data(mesh.to_vertex_handle(half)).position +
          mesh.data(mesh.from_vertex_handle(half)).position) /
         2;
}

}  // namespace burin
