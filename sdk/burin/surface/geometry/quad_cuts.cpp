// Chooses the diagonals of quads, in O(n). Hash sieves first exclude nearly all quads from the exact counting
// of vertex pairs that are joined more than once.
#include <burin/surface/geometry/area_vector.h>
#include <burin/surface/geometry/quad_cuts.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <cstdint>
#include <span>
#include <unordered_map>

namespace burin {
namespace {

using Corners = std::span<const Index>;

bool is_inside(const PolygonMesh& mesh, Corners quad, bool from_1) {
  const Vec3d normal = area_vector(mesh.positions, quad);
  const auto faces_out = [&](int a, int b, int c) {
    const auto at = [&](int corner) { return quad[static_cast<std::size_t>(corner)]; };
    return area_vector(mesh.positions, Triangle{at(a), at(b), at(c)}).dot(normal) > 0;
  };
  return from_1 ? faces_out(1, 2, 3) && faces_out(1, 3, 0) : faces_out(0, 1, 2) && faces_out(0, 2, 3);
}

bool is_better_from_1(const PolygonMesh& mesh, Corners quad) {
  const bool inside_02 = is_inside(mesh, quad, false), inside_13 = is_inside(mesh, quad, true);
  if (inside_02 != inside_13) return inside_13;
  const auto length = [&](std::size_t a, std::size_t b) {
    return (mesh.positions[quad[a]] - mesh.positions[quad[b]]).cast<double>().norm();
  };
  return length(1, 3) < length(0, 2) * (1 - 1e-6);
}

/// A pair of vertices that an edge or diagonal joins.
using Joint = std::uint64_t;

Joint joint(Index a, Index b) { return std::uint64_t{std::min(a, b)} << 32U | std::max(a, b); }

/// An approximate set of joints without false negatives (a Bloom filter with one hash), which excludes most
/// joints that are irrelevant.
class Sieve {
 public:
  explicit Sieve(std::size_t count) : bits_(std::bit_ceil(8 * count + 64)) {}
  void add(Joint j) { bits_[place(j)] = true; }
  bool may_hold(Joint j) const { return bits_[place(j)]; }

 private:
  std::size_t place(Joint j) const { return (j * 0x9e3779b97f4a7c15U >> 20U) & (bits_.size() - 1); }
  std::vector<bool> bits_;
};

/// Finds diagonals that coincide with an edge or another diagonal, and replaces them.
class Diagonals {
 public:
  explicit Diagonals(const PolygonMesh& mesh) : mesh_(mesh), from_1_(mesh.face_sizes.size()) {
    for_each_face([&](std::size_t face, Corners corners) {
      if (corners.size() == 4) from_1_[face] = is_better_from_1(mesh, corners);
    });
  }

  std::vector<bool> free_ones() {
    count_uses();
    for (const bool only_inside : {true, false}) {
      if (uses_.empty()) break;
      for_each_face([&](std::size_t face, Corners corners) {
        if (corners.size() == 4) mend(face, corners, only_inside);
      });
    }
    return std::move(from_1_);
  }

 private:
  template <class Body>
  void for_each_face(const Body& body) const {
    std::size_t corner = 0;
    for (std::size_t face = 0; face < mesh_.face_sizes.size(); ++face) {
      body(face, Corners(mesh_.face_vertices).subspan(corner, mesh_.face_sizes[face]));
      corner += mesh_.face_sizes[face];
    }
  }

  static Joint diagonal(Corners quad, bool from_1) {
    return from_1 ? joint(quad[1], quad[3]) : joint(quad[0], quad[2]);
  }

  /// Counts what runs where the diagonals of a quad do, of quads whose diagonal may not be alone.
  void count_uses() {
    if (std::ranges::find(mesh_.face_sizes, Index{4}) == mesh_.face_sizes.end()) return;
    Sieve once(mesh_.face_sizes.size()), twice(mesh_.face_sizes.size());
    for_each_face([&](std::size_t face, Corners corners) {
      if (corners.size() != 4) return;
      const Joint j = diagonal(corners, from_1_[face]);
      (once.may_hold(j) ? twice : once).add(j);
    });
    for_each_face([&](std::size_t, Corners corners) {
      for (std::size_t i = 0; i < corners.size(); ++i) {
        const Joint j = joint(corners[i], corners[(i + 1) % corners.size()]);
        if (once.may_hold(j)) twice.add(j);
      }
    });
    for_each_face([&](std::size_t face, Corners corners) {
      if (corners.size() == 4 && twice.may_hold(diagonal(corners, from_1_[face])))
        for (const bool from_1 : {false, true}) uses_[diagonal(corners, from_1)] = 0;
    });
    if (uses_.empty()) return;
    for_each_face([&](std::size_t face, Corners corners) {
      for (std::size_t i = 0; i < corners.size(); ++i)
        add_use(joint(corners[i], corners[(i + 1) % corners.size()]));
      if (corners.size() == 4) add_use(diagonal(corners, from_1_[face]));
    });
  }

  void add_use(Joint j) {
    if (const auto found = uses_.find(j); found != uses_.end()) ++found->second;
  }

  /// Takes the quad's other diagonal if the current one coincides with something and the other would not.
  void mend(std::size_t face, Corners quad, bool only_inside) {
    const auto taken = uses_.find(diagonal(quad, from_1_[face]));
    const auto other = uses_.find(diagonal(quad, !from_1_[face]));
    if (taken == uses_.end() || taken->second < 2 || other == uses_.end() || other->second > 0) return;
    if (only_inside && !is_inside(mesh_, quad, !from_1_[face])) return;
    --taken->second;
    ++other->second;
    from_1_[face] = !from_1_[face];
  }

  const PolygonMesh& mesh_;
  std::vector<bool> from_1_;
  std::unordered_map<Joint, int> uses_;  ///< use counts of the diagonals of suspicious quads
};

}  // namespace

std::vector<bool> cut_from_1_to_3(const PolygonMesh& mesh) { return Diagonals(mesh).free_ones(); }

}  // namespace burin
