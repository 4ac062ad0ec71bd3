// Longest-edge bisection [M.-C. Rivara, Algorithms for refining triangular grids suitable for adaptive and
// multigrid techniques, 1984]: always halving the longest of all edges keeps the angles of triangles from
// becoming much smaller than they are.
#include <burin/remesh/edge_mesh.h>
#include <burin/remesh/refine.h>

#include <algorithm>
#include <optional>
#include <queue>
#include <utility>

namespace burin {
namespace {

/// An edge that is too long, as it was when it was found to be.
struct LongEdge {
  double length;
  int edge;
  bool operator<(const LongEdge& other) const {
    return length != other.length ? length < other.length : edge > other.edge;
  }
};

/// Halves edges of a mesh; of a triangle always the longest side first.
class Bisection {
 public:
  Bisection(EdgeMesh& mesh, const PointField& size) : mesh_(&mesh), size_(&size) {}

  void run() {
    for (const auto edge : mesh_->edges()) look_at(edge);
    while (!longest_.empty()) {
      const LongEdge next = longest_.top();
      longest_.pop();
      const EdgeMesh::EdgeHandle edge(next.edge);
      if (length(*mesh_, edge) == next.length) split_after_longer(edge);
    }
  }

 private:
  void look_at(EdgeMesh::EdgeHandle edge) {
    const auto half = mesh_->halfedge_handle(edge, 0);
    const Vec3d &from = mesh_->data(mesh_->from_vertex_handle(half)).position,
                &to = mesh_->data(mesh_->to_vertex_handle(half)).position;
    const double is = length(*mesh_, edge);
    if (is > least_size(*size_, from, to)) longest_.push({is, edge.idx()});
  }

  /// The edges of the triangles beside one that are longer. Returns false, and leaves the edge, where such an
  /// edge cannot be split: halving one beside it again and again would pile up vertices there.
  bool split_after_longer(EdgeMesh::EdgeHandle edge) {
    if (mesh_->is_boundary(edge)) return false;
    while (const std::optional<EdgeMesh::EdgeHandle> longer = longer_beside(edge))
      if (!split_after_longer(*longer)) return false;
    const auto vertex = add_vertex(*mesh_, middle(*mesh_, edge));
    mesh_->split(edge, vertex);
    for (const auto around : mesh_->ve_range(vertex)) look_at(around);
    return true;
  }

  std::optional<EdgeMesh::EdgeHandle> longer_beside(EdgeMesh::EdgeHandle edge) const {
    const double is = length(*mesh_, edge);
    for (const unsigned side : {0U, 1U})
      for (const auto other : mesh_->fe_range(mesh_->face_handle(mesh_->halfedge_handle(edge, side))))
        if (length(*mesh_, other) > is) return EdgeMesh::EdgeHandle(other);
    return {};
  }

  EdgeMesh* mesh_;
  const PointField* size_;
  std::priority_queue<LongEdge> longest_;
};

}  // namespace

double least_size(const PointField& size, const Vec3d& from, const Vec3d& to) {
  constexpr int parts = 5;
  double least = size(from);
  for (int part = 1; part <= parts; ++part)
    least = std::min(least, size(from + static_cast<double>(part) / parts * (to - from)));
  return least;
}

void refine(PatchMesh& patch, const PointField& size) {
  EdgeMesh mesh = to_edges(patch);
  Bisection(mesh, size).run();
  patch = to_patch(mesh);
}

}  // namespace burin
