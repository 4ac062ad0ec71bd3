// Splits edges that the bend has elsewhere, and by the longest-edge rule [M. C. Rivara, Algorithms for
// Refining Triangular Grids, 1984] others around them, so that triangles keep their shape.
#include <burin/along/refine_bent.h>
#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

namespace burin {
namespace {

/// An edge, by its lower and its higher vertex.
using Edge = std::pair<Index, Index>;

Edge edge_of(const Triangle& triangle, std::size_t from) {
  return std::minmax(triangle[from], triangle[(from + 1) % 3]);
}

/// Refines a mesh in rounds. Edges that were found near enough once are so for ever.
class Refinement {
 public:
  Refinement(LaidMesh& mesh, const BendPoint& bend, const BendTolerance& tolerance)
      : mesh_(mesh), bend_(bend), tolerance_(tolerance), settled_(mesh.triangles.size()) {
    bend_from(0);
  }

  std::vector<Vec3d> run() {
    // From the longest edges there are to the shortest that may be split.
    constexpr int most_rounds = 20;
    for (int round = 0; round < most_rounds; ++round) {
      collect();
      if (!test()) break;
      spread();
      add_middles();
      split_triangles();
    }
    return std::move(bent_);
  }

 private:
  /// All edges, and those of each triangle.
  void collect() {
    const std::size_t count = mesh_.triangles.size();
    edges_.resize(3 * count);
    parallel_blocks(count, 1024, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        for (std::size_t from = 0; from < 3; ++from) edges_[3 * i + from] = edge_of(mesh_.triangles[i], from);
    });
    parallel_sort(edges_.begin(), edges_.end());
    edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
    sides_.resize(count);
    parallel_blocks(count, 1024, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        for (std::size_t from = 0; from < 3; ++from)
          sides_[i][from] = static_cast<std::size_t>(
              std::ranges::lower_bound(edges_, edge_of(mesh_.triangles[i], from)) - edges_.begin());
    });
  }

  /// Finds the edges that are far from the bend; whether there are any.
  bool test() {
    std::vector<std::uint8_t> open(edges_.size());
    for (std::size_t i = 0; i < sides_.size(); ++i)
      for (std::size_t from = 0; from < 3; ++from)
        if (!settled_[i][from]) open[sides_[i][from]] = 1;
    splits_.assign(edges_.size(), 0);
    parallel_blocks(edges_.size(), 128, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) splits_[i] = open[i] && is_far(edges_[i]) ? 1 : 0;
    });
    return std::ranges::find(splits_, 1) != splits_.end();
  }

  /// Whether the bend has one of three points of the edge elsewhere. The order of the ends does not matter,
  /// as others may have the same edge the other way round.
  bool is_far(const Edge& edge) const {
    const Vec3d &a = mesh_.points[edge.first], &b = mesh_.points[edge.second];
    if ((b - a).squaredNorm() < tolerance_.shortest * tolerance_.shortest) return false;
    const Vec3d &at_a = bent_[edge.first], &at_b = bent_[edge.second];
    const auto far = [&](const Vec3d& point, const Vec3d& straight) {
      return (bend_(point) - straight).squaredNorm() > tolerance_.chord * tolerance_.chord;
    };
    const Vec3d half = (a + b) / 2, at_half = (at_a + at_b) / 2;
    return far(half, at_half) || far((a + half) / 2, (at_a + at_half) / 2) ||
           far((half + b) / 2, (at_half + at_b) / 2);
  }

  /// Splits the longest edge of every triangle that has one to split, until that holds: without it triangles
  /// would only get thinner. Edges at one t, as those where copies meet, are left as they are.
  void spread() {
    for (bool any = true; any;) {
      any = false;
      for (const auto& sides : sides_) {
        if (!splits_[sides[0]] && !splits_[sides[1]] && !splits_[sides[2]]) continue;
        const std::size_t longest = std::ranges::max(
            sides, {}, [&](std::size_t side) { return std::pair(length(edges_[side]), side); });
        if (splits_[longest] || at_one_t(edges_[longest])) continue;
        splits_[longest] = 1;
        any = true;
      }
    }
  }

  double length(const Edge& edge) const {
    return (mesh_.points[edge.first] - mesh_.points[edge.second]).squaredNorm();
  }
  bool at_one_t(const Edge& edge) const {
    return mesh_.points[edge.first].x() == mesh_.points[edge.second].x();
  }

  void add_middles() {
    middle_.assign(edges_.size(), no_index);
    const std::size_t before = mesh_.points.size();
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      if (!splits_[i]) continue;
      middle_[i] = static_cast<Index>(mesh_.points.size());
      const Vec3d middle = (mesh_.points[edges_[i].first] + mesh_.points[edges_[i].second]) / 2;
      mesh_.points.push_back(middle);
    }
    bend_from(before);
  }

  void bend_from(std::size_t first) {
    bent_.resize(mesh_.points.size());
    parallel_blocks(bent_.size() - first, 256, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = first + begin; i < first + end; ++i) bent_[i] = bend_(mesh_.points[i]);
    });
  }

  void split_triangles() {
    const std::size_t count = mesh_.triangles.size();
    for (std::size_t i = 0; i < count; ++i) {
      std::array<Index, 3> middles;
      for (std::size_t from = 0; from < 3; ++from) {
        middles[from] = middle_[sides_[i][from]];
        settled_[i][from] = middles[from] == no_index;
      }
      split(i, middles);
      if (mesh_.triangles.size() > tolerance_.most_triangles)
        throw Error(fmt::format("the mesh along the stroke would take more than {} triangles",
                                tolerance_.most_triangles));
    }
  }

  /// A corner of the triangle being split, or the middle of the edge that begins there.
  struct Piece {
    Index vertex;
    Vec2f uv;
  };

  /// The triangle itself becomes the first of its pieces.
  void split(std::size_t i, const std::array<Index, 3>& middles) {
    const auto splits = std::ranges::count_if(middles, [](Index m) { return m != no_index; });
    if (splits == 0) return;
    // Turned so that of two edges the unsplit one comes first, of one it is the first.
    std::size_t turn = 0;
    while (splits < 3 && (middles[turn] == no_index) != (splits == 2)) ++turn;
    std::array<Piece, 3> c, m;
    std::array<bool, 3> whole;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t from = (turn + k) % 3, to = (from + 1) % 3;
      const Vec2f uv = uv_of(i, from);
      c[k] = {mesh_.triangles[i][from], uv};
      m[k] = {middles[from], (uv + uv_of(i, to)) / 2};
      whole[k] = settled_[i][from];
    }
    if (splits == 1) {
      put(i, {c[0], m[0], c[2]}, {false, false, whole[2]});
      add({m[0], c[1], c[2]}, {false, whole[1], false});
    } else if (splits == 2) {
      put(i, {m[1], c[2], m[2]}, {false, false, false});
      split_quad({c[0], c[1], m[1], m[2]}, whole[0]);
    } else {
      put(i, {m[0], m[1], m[2]}, {false, false, false});
      for (std::size_t k = 0; k < 3; ++k) add({c[k], m[k], m[(k + 2) % 3]}, {false, false, false});
    }
  }

  /// Along the shorter diagonal; `whole`: whether its first edge has settled.
  void split_quad(const std::array<Piece, 4>& q, bool whole) {
    const auto apart = [&](const Piece& a, const Piece& b) {
      return (bent_[a.vertex] - bent_[b.vertex]).squaredNorm();
    };
    if (apart(q[0], q[2]) <= apart(q[1], q[3])) {
      add({q[0], q[1], q[2]}, {whole, false, false});
      add({q[0], q[2], q[3]}, {false, false, false});
    } else {
      add({q[0], q[1], q[3]}, {whole, false, false});
      add({q[1], q[2], q[3]}, {false, false, false});
    }
  }

  Vec2f uv_of(std::size_t i, std::size_t corner) const {
    return mesh_.triangle_uv.empty() ? Vec2f::Zero() : mesh_.triangle_uv[i][corner];
  }

  void put(std::size_t i, const std::array<Piece, 3>& pieces, const std::array<bool, 3>& settled) {
    mesh_.triangles[i] = {pieces[0].vertex, pieces[1].vertex, pieces[2].vertex};
    if (!mesh_.triangle_uv.empty()) mesh_.triangle_uv[i] = {pieces[0].uv, pieces[1].uv, pieces[2].uv};
    settled_[i] = settled;
  }

  void add(const std::array<Piece, 3>& pieces, const std::array<bool, 3>& settled) {
    mesh_.triangles.emplace_back();
    if (!mesh_.triangle_uv.empty()) mesh_.triangle_uv.emplace_back();
    settled_.emplace_back();
    put(mesh_.triangles.size() - 1, pieces, settled);
  }

  LaidMesh& mesh_;
  const BendPoint& bend_;
  BendTolerance tolerance_;
  std::vector<Vec3d> bent_;                   ///< [vertex]
  std::vector<std::array<bool, 3>> settled_;  ///< [triangle] whether the edge from a corner is near enough
  std::vector<Edge> edges_;                   ///< ascending
  std::vector<std::array<std::size_t, 3>> sides_;  ///< [triangle] edges from its corners
  std::vector<std::uint8_t> splits_;               ///< [edge]
  std::vector<Index> middle_;                      ///< [edge] the vertex there, or no_index
};

}  // namespace

std::vector<Vec3d> refine_bent(LaidMesh& mesh, const BendPoint& bend, const BendTolerance& tolerance) {
  return Refinement(mesh, bend, tolerance).run();
}

}  // namespace burin
