// Incremental remeshing [M. Botsch and L. Kobbelt, A remeshing approach to multiresolution modeling, 2004]:
// rounds of splitting long edges, collapsing short ones, flipping edges where that widens the least angle,
// and moving vertices along the surface. Nothing is done that turns a triangle over or folds the mesh.
#include <burin/math/elementary.h>
#include <burin/remesh/edge_mesh.h>
#include <burin/remesh/improve.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <queue>

namespace burin {
namespace {

using Vertex = EdgeMesh::VertexHandle;
using Edge = EdgeMesh::EdgeHandle;
using Half = EdgeMesh::HalfedgeHandle;
using Face = EdgeMesh::FaceHandle;

/// By how much the direction of a triangle may change when an edge is collapsed or a vertex moved, and two
/// triangles may differ across an edge that is flipped: cosines.
constexpr double least_turn = 0.5, least_flatness = 0.9;

class Remesher {
 public:
  Remesher(PatchMesh& patch, const Improvement& how) : patch_(&patch), how_(&how), mesh_(to_edges(patch)) {}

  void run() {
    constexpr int rounds = 4;
    find_creases();
    find_sizes();
    for (int round = 0; round < rounds; ++round) {
      choose([this](Vertex v) { return how_->smooth(mesh_.data(v).position); });
      split_long();
      collapse_short();
      flip();
      move();
    }
    for (int round = 0; round < rounds; ++round) {
      choose([this](Vertex v) { return is_at_sliver(v); });
      remove_slivers();
      flip();
      move();
    }
    *patch_ = to_patch(mesh_);
  }

 private:
  /// Sets which vertices the round may change.
  void choose(const auto& wanted) {
    for (const Vertex v : mesh_.vertices())
      mesh_.data(v).chosen =
          mesh_.data(v).kept == no_index && !mesh_.is_boundary(v) && (mesh_.data(v).added || wanted(v));
  }

  bool is_at_sliver(Vertex v) const {
    for (const Face face : mesh_.vf_range(v))
      if (worst_of(face) > well_shaped) return true;
    return false;
  }

  bool may_move(Vertex v) const { return mesh_.data(v).chosen; }
  bool may_change(Edge edge) const {
    if (mesh_.is_boundary(edge)) return false;
    const Half half = mesh_.halfedge_handle(edge, 0);
    return may_move(mesh_.from_vertex_handle(half)) || may_move(mesh_.to_vertex_handle(half));
  }
  double size_of(Edge edge) const {
    const Half half = mesh_.halfedge_handle(edge, 0);
    return std::min(mesh_.data(mesh_.from_vertex_handle(half)).size,
                    mesh_.data(mesh_.to_vertex_handle(half)).size);
  }

  Vec3d area(Face face) const {
    Vec3d corner[3];
    int i = 0;
    for (const Vertex v : mesh_.fv_range(face)) corner[i++] = mesh_.data(v).position;
    return (corner[1] - corner[0]).cross(corner[2] - corner[0]);
  }

  Vec3d area_around(Vertex v) const {
    Vec3d sum = Vec3d::Zero();
    for (const Face face : mesh_.vf_range(v)) sum += area(face);
    return sum;
  }

  void find_creases() {
    for (const Vertex v : mesh_.vertices()) mesh_.data(v).crease = how_->crease(mesh_.data(v).position);
  }

  bool is_crease(Edge edge) const {
    const Half half = mesh_.halfedge_handle(edge, 0);
    return mesh_.data(mesh_.from_vertex_handle(half)).crease &&
           mesh_.data(mesh_.to_vertex_handle(half)).crease;
  }

  /// Sets the size wanted at each vertex: what the caller asks for, but near border edges, which stay, no
  /// more than what lets triangles grow evenly.
  void find_sizes() {
    std::priority_queue<std::pair<double, int>, std::vector<std::pair<double, int>>, std::greater<>> queue;
    for (const Vertex v : mesh_.vertices()) {
      double size = how_->size(mesh_.data(v).position);
      if (mesh_.is_boundary(v))
        for (const Edge edge : mesh_.ve_range(v))
          if (mesh_.is_boundary(edge)) size = std::min(size, length(mesh_, edge));
      mesh_.data(v).size = size;
      queue.emplace(size, v.idx());
    }
    while (!queue.empty()) {
      const auto [size, number] = queue.top();
      queue.pop();
      const Vertex v(number);
      if (size > mesh_.data(v).size) continue;
      for (const Edge edge : mesh_.ve_range(v)) {
        const Half half = mesh_.halfedge_handle(edge, 0);
        const Vertex other =
            mesh_.to_vertex_handle(half) == v ? mesh_.from_vertex_handle(half) : mesh_.to_vertex_handle(half);
        const double grown = size + growth * length(mesh_, edge);
        if (grown < mesh_.data(other).size) {
          mesh_.data(other).size = grown;
          queue.emplace(grown, other.idx());
        }
      }
    }
  }

  std::vector<Edge> edges_where(const auto& condition) {
    std::vector<Edge> edges;
    for (const Edge edge : mesh_.edges())
      if (may_change(edge) && condition(edge)) edges.push_back(edge);
    return edges;
  }

  void split_long() {
    constexpr double too_long = 4. / 3;
    for (const Edge edge : edges_where([&](Edge e) { return length(mesh_, e) > too_long * size_of(e); })) {
      const double size = size_of(edge) + growth * length(mesh_, edge) / 2;
      const bool crease = is_crease(edge);
      const Vertex vertex = add_vertex(mesh_, how_->bring(middle(mesh_, edge)));
      mesh_.split(edge, vertex);
      mesh_.data(vertex).size = std::min(size, how_->size(mesh_.data(vertex).position));
      mesh_.data(vertex).chosen = mesh_.data(vertex).added = true;
      mesh_.data(vertex).crease = crease;
    }
  }

  void collapse_short() {
    constexpr double too_short = 4. / 5;
    for (const Edge edge : edges_where([&](Edge e) { return length(mesh_, e) < too_short * size_of(e); }))
      if (!mesh_.status(edge).deleted()) collapse(edge, 4. / 3);
    mesh_.garbage_collection();
  }

  /// Along the better of the two directions that are allowed, if one is. No edge becomes longer than this
  /// many times the size.
  bool collapse(Edge edge, double longest) {
    const Half halves[] = {mesh_.halfedge_handle(edge, 0), mesh_.halfedge_handle(edge, 1)};
    double cost[2];
    for (int i = 0; i < 2; ++i) cost[i] = cost_of(halves[i], longest);
    const int better = cost[0] <= cost[1] ? 0 : 1;
    const Vertex gone = mesh_.from_vertex_handle(halves[better]);
    if (!(cost[better] < std::max(worst_around(gone, mesh_.data(gone).position), passable))) return false;
    mesh_.collapse(halves[better]);
    return true;
  }

  double longest_around(Vertex v) const {
    double longest = 0;
    for (const Edge edge : mesh_.ve_range(v)) longest = std::max(longest, length(mesh_, edge));
    return longest;
  }

  /// The worst cosine of an angle after moving the half-edge's first vertex onto its second; 2 where that is
  /// not allowed, also because an edge became longer than `longest` times the size of its ends and than
  /// `longest_now`.
  double cost_of(Half half, double longest, double longest_now = 0) {
    constexpr double refused = 2;
    const Vertex gone = mesh_.from_vertex_handle(half), stays = mesh_.to_vertex_handle(half);
    if (!may_move(gone) || !mesh_.is_collapse_ok(half)) return refused;
    if (mesh_.data(gone).crease && !mesh_.data(stays).crease) return refused;
    const Vec3d& target = mesh_.data(stays).position;
    double worst = -1;
    for (const Half around : mesh_.voh_range(gone)) {
      const Vertex other = mesh_.to_vertex_handle(around);
      const double most =
          std::max(longest * std::max(mesh_.data(other).size, mesh_.data(stays).size), longest_now);
      if (other != stays && (mesh_.data(other).position - target).norm() > most) return refused;
      const Face face = mesh_.face_handle(around);
      const Vertex next = mesh_.to_vertex_handle(mesh_.next_halfedge_handle(around));
      if (other == stays || next == stays) continue;
      if (!stays_upright(face, gone, target)) return refused;
      worst = std::max(worst, worst_cosine(target, mesh_.data(other).position, mesh_.data(next).position));
    }
    return worst;
  }

  /// Whether a triangle still faces to the same side when a corner is moved. Slivers, whose own direction
  /// says little, are compared with the triangles around that corner.
  bool stays_upright(Face face, Vertex moved, const Vec3d& to) const {
    const Vec3d before = worst_of(face) > sliver ? area_around(moved) : area(face);
    Vec3d corner[3];
    int i = 0;
    for (const Vertex v : mesh_.fv_range(face)) corner[i++] = v == moved ? to : mesh_.data(v).position;
    const Vec3d after = (corner[1] - corner[0]).cross(corner[2] - corner[0]);
    const double norms = before.norm() * after.norm();
    return norms > 0 ? before.dot(after) > least_turn * norms : after.norm() > 0;
  }

  /// Flips edges where the least angle of both triangles becomes greater.
  void flip() {
    constexpr int most_passes = 4;
    bool any = true;
    for (int pass = 0; pass < most_passes && any; ++pass) {
      any = false;
      for (const Edge edge : mesh_.edges())
        if (may_flip(edge) && is_flip_better(edge)) {
          mesh_.flip(edge);
          any = true;
        }
    }
  }

  /// Also an edge between vertices that stay, if a triangle beside it is a sliver. An edge of the crease only
  /// if it is the longest side of a sliver along the crease.
  bool may_flip(Edge edge) const {
    if (mesh_.is_boundary(edge) || !mesh_.is_flip_ok(edge)) return false;
    const bool crease = is_crease(edge);
    for (const unsigned side : {0U, 1U}) {
      const Half half = mesh_.halfedge_handle(edge, side);
      const Vertex opposite = mesh_.opposite_vh(half);
      const bool narrow = worst_of(mesh_.face_handle(half)) > well_shaped;
      if (crease ? narrow && mesh_.data(opposite).crease && is_longest(edge, half) : narrow) return true;
    }
    return !crease && may_change(edge);
  }

  bool is_longest(Edge edge, Half half) const {
    return std::ranges::none_of(mesh_.fe_range(mesh_.face_handle(half)),
                                [&](Edge other) { return length(mesh_, other) > length(mesh_, edge); });
  }

  bool is_flip_better(Edge edge) const {
    const Half half = mesh_.halfedge_handle(edge, 0), back = mesh_.halfedge_handle(edge, 1);
    const Vec3d &a = mesh_.data(mesh_.from_vertex_handle(half)).position,
                &b = mesh_.data(mesh_.to_vertex_handle(half)).position,
                &left = mesh_.data(mesh_.opposite_vh(half)).position,
                &right = mesh_.data(mesh_.opposite_vh(back)).position;
    const double now = std::max(worst_cosine(a, b, left), worst_cosine(b, a, right)),
                 then = std::max(worst_cosine(right, left, a), worst_cosine(left, right, b));
    constexpr double by = 1e-6;
    if (!(then < now - by)) return false;
    const Vec3d n0 = (b - a).cross(left - a), n1 = (right - a).cross(b - a),
                m0 = (left - right).cross(a - right), m1 = (right - left).cross(b - left);
    const auto agree = [](const Vec3d& p, const Vec3d& q, double cosine) {
      return p.dot(q) >= cosine * p.norm() * q.norm();
    };
    // Triangles without area have no direction.
    const bool flat = now > 1 - 1e-4;
    const Vec3d both = n0 + n1;
    return agree(both, m0, least_turn) && agree(both, m1, least_turn) &&
           (flat || agree(n0, n1, least_flatness));
  }

  /// Towards the mean of the triangles around, weighted by their areas, and back to the surface.
  void move() {
    constexpr int steps = 2;
    for (int step = 0; step < steps; ++step)
      for (const Vertex v : mesh_.vertices())
        if (may_move(v) && !mesh_.data(v).crease) move(v);
  }

  void move(Vertex v) {
    Vec3d sum = Vec3d::Zero(), normal = Vec3d::Zero();
    double weights = 0;
    for (const Face face : mesh_.vf_range(v)) {
      Vec3d centre = Vec3d::Zero();
      for (const Vertex corner : mesh_.fv_range(face)) centre += mesh_.data(corner).position / 3;
      const Vec3d n = area(face);
      sum += n.norm() * centre;
      weights += n.norm();
      normal += n;
    }
    if (!(weights > 0 && normal.norm() > 0)) return;
    const Vec3d way = sum / weights - mesh_.data(v).position, n = normal.normalized();
    const Vec3d to = how_->bring(mesh_.data(v).position + way - way.dot(n) * n);
    const double before = worst_around(v, mesh_.data(v).position);
    if (worst_around(v, to) > std::max(before, well_shaped)) return;
    for (const Face face : mesh_.vf_range(v))
      if (!stays_upright(face, v, to)) return;
    mesh_.data(v).position = to;
  }

  double worst_around(Vertex v, const Vec3d& at) const {
    double worst = -1;
    for (const Half half : mesh_.voh_range(v)) {
      if (mesh_.is_boundary(half)) continue;
      worst = std::max(
          worst, worst_cosine(at, mesh_.data(mesh_.to_vertex_handle(half)).position,
                              mesh_.data(mesh_.to_vertex_handle(mesh_.next_halfedge_handle(half))).position));
    }
    return worst;
  }

  /// Collapses an edge of each triangle with a small angle where that makes it better, the shortest first.
  void remove_slivers() {
    std::vector<Edge> edges;
    for (const Face face : mesh_.faces()) {
      double worst = worst_of(face);
      if (worst < well_shaped) continue;
      for (const Edge edge : mesh_.fe_range(face))
        if (may_change(edge)) edges.push_back(edge);
    }
    std::ranges::stable_sort(edges, {}, [&](Edge edge) { return length(mesh_, edge); });
    for (const Edge edge : edges) {
      if (mesh_.status(edge).deleted()) continue;
      const Half half = mesh_.halfedge_handle(edge, 0), back = mesh_.halfedge_handle(edge, 1);
      const double now = std::max(worst_of(mesh_.face_handle(half)), worst_of(mesh_.face_handle(back)));
      const double costs[] = {cost_of(half, 2, longest_around(mesh_.from_vertex_handle(half))),
                              cost_of(back, 2, longest_around(mesh_.from_vertex_handle(back)))};
      if (std::min(costs[0], costs[1]) < now) mesh_.collapse(costs[0] <= costs[1] ? half : back);
    }
    mesh_.garbage_collection();
  }

  double worst_of(Face face) const {
    Vec3d corner[3];
    int i = 0;
    for (const Vertex v : mesh_.fv_range(face)) corner[i++] = mesh_.data(v).position;
    return worst_cosine(corner[0], corner[1], corner[2]);
  }

  /// The growth of sizes from vertex to vertex, as a share of the edge between them.
  static constexpr double growth = 0.5;
  /// Cosines of 25, 10 and 5 degrees.
  static constexpr double well_shaped = 0.9063, passable = 0.9848, sliver = 0.9962;

  PatchMesh* patch_;
  const Improvement* how_;
  EdgeMesh mesh_;
};

}  // namespace

void improve(PatchMesh& patch, const Improvement& how) { Remesher(patch, how).run(); }

std::vector<double> least_angles(const PatchMesh& patch) {
  std::vector<double> angles;
  for (const auto& [a, b, c] : patch.triangles) {
    const double cosine = worst_cosine(patch.positions[a], patch.positions[b], patch.positions[c]),
                 sine = std::sqrt(std::max(1 - cosine * cosine, 0.));
    angles.push_back(math::atan2(sine, cosine) * 180 / std::numbers::pi);
  }
  return angles;
}

}  // namespace burin
