// Joins a mesh along coinciding edges, in four steps that cost O(n log n) together:
// 1. Rim: find the edges that have one face only.
// 2. Places: merge the ends of rim edges that lie within the tolerance of each other to places.
// 3. Pairs: pair rim edges between the same two places, in opposite directions where faces agree on the
// outside.
// 4. Vertices: unite the vertices at the ends of each pair. Every pair turns two rim edges into one inner
// edge, so a manifold stays a manifold.
#include <burin/surface/points/point_tree.h>
#include <burin/surface/topology/weld.h>
#include <burin/surface/weld_mesh.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <tuple>

namespace burin {
namespace {

constexpr double rounding = 4e-6;
constexpr double reach_of_edge = 0.25;       ///< greatest reach, as a share of a vertex's shortest edge
constexpr double folded = 1 - 1e-6;          ///< least cosine between two faces that lie on each other
constexpr std::size_t most_at_a_place = 64;  ///< most edges of a seam between two places

struct RimEdge {
  Index from, to;  ///< vertices of the mesh, in the order of the face
  Index face;
  Vec3d inward;  ///< unit vector across the edge toward the middle of the face; zero for a face without area
};

/// Disjoint sets of indices (union-find); the lowest index of a set represents it.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0u); }

  Index lowest(Index i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  void join(Index a, Index b) {
    a = lowest(a);
    b = lowest(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<Index> parent_;
};

/// Calls body(face, its corners) for all faces.
template <class Body>
void for_each_face(const PolygonMesh& mesh, const Body& body) {
  std::size_t corner = 0;
  for (Index face = 0; face < mesh.face_sizes.size(); ++face) {
    body(face, std::span(mesh.face_vertices).subspan(corner, mesh.face_sizes[face]));
    corner += mesh.face_sizes[face];
  }
}

/// Calls body(from, to, corners of the face, face) for all edges of all faces.
template <class Body>
void for_each_edge(const PolygonMesh& mesh, const Body& body) {
  for_each_face(mesh, [&](Index face, std::span<const Index> corners) {
    for (std::size_t i = 0; i < corners.size(); ++i)
      body(corners[i], corners[(i + 1) % corners.size()], corners, face);
  });
}

/// Maps each index to a distinct, well-mixed number (the finaliser of SplitMix64).
std::uint64_t scrambled(std::uint64_t index) {
  index += 0x9e3779b97f4a7c15u;
  index = (index ^ (index >> 30)) * 0xbf58476d1ce4e5b9u;
  index = (index ^ (index >> 27)) * 0x94d049bb133111ebu;
  return index ^ (index >> 31);
}

/// Marks the vertices that have an edge without its counterpart. At all other vertices the hashes of outgoing
/// and incoming edges cancel. This spares most of the mesh the sorting.
std::vector<bool> unbalanced(const PolygonMesh& mesh) {
  std::vector<std::uint64_t> sums(mesh.positions.size());
  for_each_edge(mesh, [&](Index from, Index to, auto&&, Index) {
    sums[from] += scrambled(to);
    sums[to] -= scrambled(from);
  });
  std::vector<bool> result(sums.size());
  for (std::size_t i = 0; i < sums.size(); ++i) result[i] = sums[i] != 0;
  return result;
}

Vec3d place(const PolygonMesh& mesh, Index vertex) { return mesh.positions[vertex].cast<double>(); }

/// The RimEdge::inward of an edge. Coordinates are first divided by the face's size, so that it works at
/// every scale.
Vec3d inward_of(const PolygonMesh& mesh, std::span<const Index> corners, Index from, Index to) {
  const Vec3d start = place(mesh, from);
  Vec3d middle = Vec3d::Zero();
  double size = 0;
  for (const Index corner : corners) {
    middle += (place(mesh, corner) - start) / static_cast<double>(corners.size());
    size = std::max(size, (place(mesh, corner) - start).cwiseAbs().maxCoeff());
  }
  const Vec3d along = (place(mesh, to) - start) / size;
  if (!(size > 0) || along.isZero(0)) return Vec3d::Zero();
  const Vec3d unit = along.normalized();
  const Vec3d across = middle / size - unit * unit.dot(middle / size);
  return across.norm() > 1e-12 ? Vec3d(across.normalized()) : Vec3d(Vec3d::Zero());
}

std::vector<RimEdge> rim_edges(const PolygonMesh& mesh, const std::vector<bool>& may_be) {
  struct Edge {
    Index low, high;
    bool rises;
    RimEdge edge;
  };
  std::vector<Edge> edges;
  for_each_edge(mesh, [&](Index from, Index to, std::span<const Index> corners, Index face) {
    if (may_be[from] && may_be[to] && from != to)
      edges.push_back({std::min(from, to),
                       std::max(from, to),
                       from < to,
                       {from, to, face, inward_of(mesh, corners, from, to)}});
  });
  const auto key = [](const Edge& e) { return std::tuple(e.low, e.high, e.edge.face); };
  std::ranges::sort(edges, {}, key);
  std::vector<RimEdge> rim;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const auto same = [&](std::size_t k) {
      return k < edges.size() && edges[k].low == edges[i].low && edges[k].high == edges[i].high;
    };
    if (!same(i + 1) && !(i > 0 && same(i - 1))) rim.push_back(edges[i].edge);
  }
  return rim;
}

/// Numbers the places at the ends of rim edges: vertices within the tolerance of each other have the same
/// number. All other vertices have no_index.
class Places {
 public:
  Places(const PolygonMesh& mesh, const std::vector<RimEdge>& rim, double tolerance)
      : number_(mesh.positions.size(), no_index) {
    for (const RimEdge& edge : rim)
      for (const Index vertex : {edge.from, edge.to}) {
        if (number_[vertex] != no_index) continue;
        number_[vertex] = static_cast<Index>(points_.size());
        points_.push_back(mesh.positions[vertex]);
      }
    const std::vector<Index> first = first_at_position(points_);
    for (Index& number : number_)
      if (number != no_index) number = first[number];
    if (tolerance > 0) join_near(mesh, first, tolerance);
  }

  Index of(Index vertex) const { return number_[vertex]; }

 private:
  void join_near(const PolygonMesh& mesh, const std::vector<Index>& first, double tolerance) {
    std::vector<Index> firsts;
    for (Index i = 0; i < first.size(); ++i)
      if (first[i] == i) firsts.push_back(i);
    const std::vector<double> reach = reaches(mesh, tolerance);
    std::vector<Vec3f> points(firsts.size());
    std::ranges::transform(firsts, points.begin(), [&](Index i) { return points_[i]; });
    const PointTree tree(points);
    DisjointSets sets(points_.size());
    std::vector<PointTree::Near> near;
    for (std::size_t i = 0; i < firsts.size(); ++i) {
      tree.within(points[i].cast<double>(), reach[firsts[i]], near);
      for (const auto& [other, squared_distance] : near)
        if (std::sqrt(squared_distance) <= reach[firsts[other]]) sets.join(firsts[i], firsts[other]);
    }
    for (Index& number : number_)
      if (number != no_index) number = sets.lowest(number);
  }

  /// For each point, how far away other points of the same place may lie.
  std::vector<double> reaches(const PolygonMesh& mesh, double tolerance) const {
    std::vector<double> reach(points_.size(), tolerance);
    for_each_edge(mesh, [&](Index from, Index to, auto&&, Index) {
      for (const Index end : {number_[from], number_[to]}) {
        if (end == no_index) continue;
        const double length = (place(mesh, to) - place(mesh, from)).norm();
        if (length > 0) reach[end] = std::min(reach[end], reach_of_edge * length);
      }
    });
    return reach;
  }

  std::vector<Index> number_;  ///< [vertex] number of its place
  std::vector<Vec3f> points_;
};

/// The rim edges between two places, by direction, in the order of the file.
struct Seam {
  std::vector<const RimEdge*> forward, backward;
};

bool are_folded(const RimEdge& a, const RimEdge& b) { return a.inward.dot(b.inward) > folded; }

/// Joins the vertices at the ends of pairs of edges.
class Zipper {
 public:
  explicit Zipper(std::size_t vertices) : sets(vertices) {}

  void close(Seam& seam) {
    if (seam.forward.size() + seam.backward.size() > most_at_a_place) return;
    in_order(seam) ? pair_in_order(seam) : pair_straightest(seam);
    pair_flipped(seam.forward);
    pair_flipped(seam.backward);
  }

  DisjointSets sets;

 private:
  static bool in_order(const Seam& seam) {
    if (seam.forward.size() != seam.backward.size()) return false;
    for (std::size_t i = 0; i < seam.forward.size(); ++i)
      if (are_folded(*seam.forward[i], *seam.backward[i])) return false;
    return true;
  }

  void pair_in_order(Seam& seam) {
    for (std::size_t i = 0; i < seam.forward.size(); ++i) join(*seam.forward[i], *seam.backward[i]);
    seam = {};
  }

  void pair_straightest(Seam& seam) {
    while (true) {
      const RimEdge *best_a = nullptr, *best_b = nullptr;
      for (const RimEdge* a : seam.forward)
        for (const RimEdge* b : seam.backward)
          if (!are_folded(*a, *b) &&
              (!best_a || a->inward.dot(b->inward) < best_a->inward.dot(best_b->inward)))
            std::tie(best_a, best_b) = std::tuple(a, b);
      if (!best_a) return;
      join(*best_a, *best_b);
      std::erase(seam.forward, best_a);
      std::erase(seam.backward, best_b);
    }
  }

  /// Joins two edges in the same direction if they are the only ones: their faces disagree on the outside.
  void pair_flipped(const std::vector<const RimEdge*>& edges) {
    if (edges.size() != 2 || are_folded(*edges[0], *edges[1])) return;
    sets.join(edges[0]->from, edges[1]->from);
    sets.join(edges[0]->to, edges[1]->to);
  }

  void join(const RimEdge& a, const RimEdge& b) {
    sets.join(a.from, b.to);
    sets.join(a.to, b.from);
  }
};

/// Returns the sets of vertices that become one.
DisjointSets joined(const PolygonMesh& mesh, const std::vector<RimEdge>& rim, const Places& places) {
  struct Placed {
    Index low, high;
    const RimEdge* edge;
  };
  std::vector<Placed> order;
  Zipper zipper(mesh.positions.size());
  for (const RimEdge& edge : rim) {
    const Index from = places.of(edge.from), to = places.of(edge.to);
    if (from == to) zipper.sets.join(edge.from, edge.to);
    if (from != to) order.push_back({std::min(from, to), std::max(from, to), &edge});
  }
  std::ranges::sort(order, {},
                    [](const Placed& p) { return std::tuple(p.low, p.high, p.edge->face, p.edge->from); });
  for (std::size_t i = 0; i < order.size();) {
    Seam seam;
    const std::size_t begin = i;
    for (; i < order.size() && order[i].low == order[begin].low && order[i].high == order[begin].high; ++i)
      (places.of(order[i].edge->from) == order[i].low ? seam.forward : seam.backward)
          .push_back(order[i].edge);
    zipper.close(seam);
  }
  return std::move(zipper.sets);
}

/// Removes corners whose next corner has the same vertex, and faces left with fewer than three corners.
void drop_repeated_corners(PolygonMesh& mesh) {
  PolygonMesh kept;
  std::vector<Index> face_of(mesh.face_sizes.size(), no_index);
  std::size_t corner = 0;
  for_each_face(mesh, [&](Index face, std::span<const Index> corners) {
    const std::size_t begin = kept.face_vertices.size();
    for (std::size_t i = 0; i < corners.size(); ++i, ++corner) {
      if (corners[i] == corners[(i + 1) % corners.size()]) continue;
      kept.face_vertices.push_back(corners[i]);
      if (!mesh.corner_uv.empty()) kept.corner_uv.push_back(mesh.corner_uv[corner]);
    }
    const std::size_t size = kept.face_vertices.size() - begin;
    if (size < 3) {
      kept.face_vertices.resize(begin);
      if (!mesh.corner_uv.empty()) kept.corner_uv.resize(begin);
    } else {
      face_of[face] = static_cast<Index>(kept.face_sizes.size());
      kept.face_sizes.push_back(static_cast<Index>(size));
    }
  });
  mesh.face_sizes = std::move(kept.face_sizes);
  mesh.face_vertices = std::move(kept.face_vertices);
  mesh.corner_uv = std::move(kept.corner_uv);
  for (Index& hole : mesh.holes) hole = face_of[hole];
  std::erase(mesh.holes, no_index);
}

/// Keeps the values of the vertices `firsts`, which are ascending.
template <class Value>
void keep_firsts(std::vector<Value>& values, const std::vector<Index>& firsts) {
  if (values.empty()) return;
  for (std::size_t i = 0; i < firsts.size(); ++i) values[i] = values[firsts[i]];
  values.resize(firsts.size());
}

}  // namespace

double rounding_tolerance(const PolygonMesh& mesh) {
  double greatest = 0;
  for (const Vec3f& position : mesh.positions)
    greatest = std::max(greatest, double{position.cwiseAbs().maxCoeff()});
  return rounding * greatest;
}

std::vector<Index> find_welds(const PolygonMesh& mesh, double tolerance) {
  const std::vector<RimEdge> rim = rim_edges(mesh, unbalanced(mesh));
  DisjointSets sets = joined(mesh, rim, Places(mesh, rim, tolerance));
  std::vector<Index> vertex_of(mesh.positions.size());
  Index vertices = 0;
  for (Index i = 0; i < vertex_of.size(); ++i)
    vertex_of[i] = sets.lowest(i) == i ? vertices++ : vertex_of[sets.lowest(i)];
  if (vertices == vertex_of.size()) vertex_of.clear();
  return vertex_of;
}

PolygonMesh weld(PolygonMesh mesh, const std::vector<Index>& vertex_of) {
  if (vertex_of.empty()) return mesh;
  std::vector<Index> firsts;
  for (Index i = 0; i < vertex_of.size(); ++i)
    if (vertex_of[i] == firsts.size()) firsts.push_back(i);
  keep_firsts(mesh.positions, firsts);
  keep_firsts(mesh.paint.colours, firsts);
  keep_firsts(mesh.paint.masks, firsts);
  for (Index& vertex : mesh.face_vertices) vertex = vertex_of[vertex];
  for (CreaseEdge& crease : mesh.creases)
    crease = {vertex_of[crease.a], vertex_of[crease.b], crease.sharpness};
  for (CornerVertex& corner : mesh.corners) corner.vertex = vertex_of[corner.vertex];
  drop_repeated_corners(mesh);
  return mesh;
}

}  // namespace burin
