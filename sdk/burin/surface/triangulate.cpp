#include <burin/surface/triangulate.h>

#include <Eigen/Geometry>
#include <array>
#include <numeric>
#include <span>

namespace burin {
namespace {

using Vec2d = Eigen::Vector2d;
using Corners = std::span<const Index>;

/// Twice the area of a polygon times its normal (Newell), from its first corner to spare digits.
Vec3d area_vector(const std::vector<Vec3f>& positions, Corners corners) {
  const Vec3d origin = positions[corners[0]].cast<double>();
  Vec3d sum = Vec3d::Zero();
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    sum += (positions[corners[i]].cast<double>() - origin)
               .cross(positions[corners[i + 1]].cast<double>() - origin);
  return sum;
}

/// Three corners of a polygon, as it counts them.
using Ear = std::array<std::size_t, 3>;

/// Splits along the diagonal 0-2 unless 1-3 is the one inside, or the shorter by more than rounding.
void split_quad(const std::vector<Vec3f>& positions, Corners quad, std::vector<Ear>& out) {
  const Ear across_02[] = {{0, 1, 2}, {0, 2, 3}};
  const Ear across_13[] = {{1, 2, 3}, {1, 3, 0}};
  const Vec3d normal = area_vector(positions, quad);
  const auto inside = [&](const Ear& e) {
    return area_vector(positions, Triangle{quad[e[0]], quad[e[1]], quad[e[2]]}).dot(normal) > 0;
  };
  const bool inside_02 = inside(across_02[0]) && inside(across_02[1]);
  const bool inside_13 = inside(across_13[0]) && inside(across_13[1]);
  const auto length = [&](int a, int b) {
    return (positions[quad[a]] - positions[quad[b]]).cast<double>().norm();
  };
  const bool shorter_13 = length(1, 3) < length(0, 2) * (1 - 1e-6);
  const bool take_13 = inside_02 == inside_13 ? shorter_13 : inside_13;
  out.insert(out.end(), take_13 ? across_13 : across_02, (take_13 ? across_13 : across_02) + 2);
}

double cross(const Vec2d& a, const Vec2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Ear clipping [Meisters 1975] of one polygon, in the plane across its area vector.
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
    // Going on behind the next corner after each ear keeps the triangles from fanning out of one corner.
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

  /// The first ear from `start` on; a polygon that crosses itself may have none, then `start` has to do.
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

void split(const std::vector<Vec3f>& positions, Corners corners, std::vector<Ear>& out) {
  if (corners.size() == 3) {
    out.push_back({0, 1, 2});
  } else if (corners.size() == 4) {
    split_quad(positions, corners, out);
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
  std::vector<bool> is_hole(mesh.face_sizes.size());
  for (const Index hole : mesh.holes) is_hole[hole] = true;
  for (std::size_t face = 0; face < mesh.face_sizes.size(); ++face) {
    const Index size = mesh.face_sizes[face];
    const Corners corners = Corners(mesh.face_vertices).subspan(corner, size);
    ears.clear();
    if (!is_hole[face]) split(mesh.positions, corners, ears);
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
