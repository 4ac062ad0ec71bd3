// Splits polygons into triangles, in O(corners), or O(corners^3) at worst for a polygon with more than four
// corners (ear clipping).
#include <burin/surface/geometry/area_vector.h>
#include <burin/surface/geometry/quad_cuts.h>
#include <burin/surface/triangulate.h>

#include <Eigen/Geometry>
#include <array>
#include <numeric>
#include <span>

namespace burin {
namespace {

using Corners = std::span<const Index>;

/// Three corners of a polygon, as indices among its corners.
using Ear = std::array<std::size_t, 3>;

double cross(const Vec2d& a, const Vec2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Ear clipping [Meisters 1975] of one polygon, in the plane at right angles to its area vector.
class EarClipper {
 public:
  EarClipper(const std::vector<Vec3f>& positions, Corners corners) : left_(corners.size()) {
    std::iota(left_.begin(), left_.end(), std::size_t{0});
    const Vec3d normal = area_vector(positions, corners).normalized();
    const Vec3d across = normal.unitOrthogonal();
    const Vec3d along = normal.cross(across);
    for (const Index corner : corners) {
      const Vec3d p = (positions[corner] - positions[corners[0]]).cast<double>();
      points_.emplace_back(across.dot(p), along.dot(p));
    }
  }

  void clip(std::vector<Ear>& out) {
    // The search continues after the next corner, so that triangles do not fan out from one corner.
    for (std::size_t at = 0; left_.size() > 3; ++at) {
      at = find_ear(at % left_.size());
      out.push_back(ear(at));
      left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(at));
    }
    out.push_back(ear(1));
  }

 private:
  std::size_t before(std::size_t at) const { return left_[(at + left_.size() - 1) % left_.size()]; }
  std::size_t after(std::size_t at) const { return left_[(at + 1) % left_.size()]; }
  Ear ear(std::size_t at) const { return {before(at), left_[at], after(at)}; }

  /// The first ear from `start` on. A polygon that intersects itself may have none; then `start` is taken.
  std::size_t find_ear(std::size_t start) const {
    for (std::size_t i = 0; i < left_.size(); ++i)
      if (const std::size_t at = (start + i) % left_.size(); is_ear(at)) return at;
    return start;
  }

  bool is_ear(std::size_t at) const {
    const Vec2d &a = points_[before(at)], &b = points_[left_[at]], &c = points_[after(at)];
    if (!(cross(b - a, c - b) > 0)) return false;
    for (const std::size_t other : left_) {
      const Vec2d& p = points_[other];
      if (p == a || p == b || p == c) continue;
      if (cross(b - a, p - a) >= 0 && cross(c - b, p - b) >= 0 && cross(a - c, p - c) >= 0) return false;
    }
    return true;
  }

  std::vector<std::size_t> left_;  ///< corners not yet clipped
  std::vector<Vec2d> points_;
};

void split_quad(bool from_1, std::vector<Ear>& out) {
  const Ear across_02[] = {{0, 1, 2}, {0, 2, 3}};
  const Ear across_13[] = {{1, 2, 3}, {1, 3, 0}};
  const Ear* const ears = from_1 ? across_13 : across_02;
  out.insert(out.end(), ears, ears + 2);
}

void split(const std::vector<Vec3f>& positions, Corners corners, bool from_1, std::vector<Ear>& out) {
  if (corners.size() == 3) {
    out.push_back({0, 1, 2});
  } else if (corners.size() == 4) {
    split_quad(from_1, out);
  } else {
    EarClipper(positions, corners).clip(out);
  }
}

}  // namespace

TriangleMesh triangulate(const PolygonMesh& mesh) {
  TriangleMesh result;
  result.positions = mesh.positions;
  const std::size_t triangles = mesh.face_vertices.size() - 2 * mesh.face_sizes.size();
  result.triangles.reserve(triangles);
  if (!mesh.corner_uv.empty()) result.triangle_uv.reserve(triangles);
  std::size_t corner = 0;
  std::vector<Ear> ears;
  const std::vector<bool> from_1 = cut_from_1_to_3(mesh);
  std::vector<bool> is_hole(mesh.face_sizes.size());
  for (const Index hole : mesh.holes) is_hole[hole] = true;
  for (std::size_t face = 0; face < mesh.face_sizes.size(); ++face) {
    const Index size = mesh.face_sizes[face];
    const Corners corners = Corners(mesh.face_vertices).subspan(corner, size);
    ears.clear();
    if (!is_hole[face]) split(mesh.positions, corners, from_1[face], ears);
    for (const auto& [a, b, c] : ears) {
      result.triangles.push_back({corners[a], corners[b], corners[c]});
      if (mesh.corner_uv.empty()) continue;
      const Vec2f* uv = mesh.corner_uv.data() + corner;
      result.triangle_uv.push_back({uv[a], uv[b], uv[c]});
    }
    corner += size;
  }
  return result;
}

}  // namespace burin
