// Texture coordinates for triangles that take the place of others. Around the middle of a new triangle they
// are taken as linear, as the surface's triangle there has them. A corner gets what the surface has at the
// corner's own closest place if that agrees with it, so that new triangles that share a vertex agree too; it
// does not agree where a seam lies between.
#include <burin/base/parallel.h>
#include <burin/surface/patch_uv.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

namespace burin {
namespace {

/// Texture coordinates over the plane of a triangle of the surface.
class LinearUv {
 public:
  LinearUv(const Surface& surface, Index triangle) : uv_(surface.triangle_uv[triangle]) {
    const Triangle& t = surface.triangles[triangle];
    origin_ = surface.positions[t[0]].cast<double>();
    const Vec3d ab = surface.positions[t[1]].cast<double>() - origin_,
                ac = surface.positions[t[2]].cast<double>() - origin_;
    const Vec3d area = ab.cross(ac);
    const double squared = area.squaredNorm();
    if (squared > 0) {
      along_b_ = ac.cross(area) / squared;
      along_c_ = area.cross(ab) / squared;
    }
    const double longest = std::max({ab.norm(), ac.norm(), (ac - ab).norm()});
    const double most = static_cast<double>(
        std::max({(uv_[1] - uv_[0]).norm(), (uv_[2] - uv_[0]).norm(), (uv_[2] - uv_[1]).norm()}));
    scale_ = longest > 0 ? most / longest : 0;
  }

  Vec2f at(const Vec3d& p) const {
    const auto b = static_cast<float>(along_b_.dot(p - origin_)),
               c = static_cast<float>(along_c_.dot(p - origin_));
    return (1 - b - c) * uv_[0] + b * uv_[1] + c * uv_[2];
  }

  /// How much they change at most over a length of 1.
  double scale() const { return scale_; }

 private:
  TriangleUv uv_;
  Vec3d origin_;
  Vec3d along_b_ = Vec3d::Zero(), along_c_ = Vec3d::Zero();  ///< gradients of the weights of two corners
  double scale_ = 0;
};

Vec2f uv_at(const Surface& surface, const SurfacePoint& place) {
  const TriangleUv& uv = surface.triangle_uv[place.triangle];
  return place.weights[0] * uv[0] + place.weights[1] * uv[1] + place.weights[2] * uv[2];
}

/// What the surface has at a point, by what it should be about.
class UvThere {
 public:
  UvThere(const Surface& surface, const Picker& picker, const SurfacePatch& patch)
      : surface_(&surface), picker_(&picker), patch_(&patch) {}

  TriangleUv of(const Triangle& triangle) const {
    Vec3f middle = Vec3f::Zero();
    for (const Index corner : triangle) middle += position(corner) / 3;
    const LinearUv linear(*surface_, closest(middle).triangle);
    TriangleUv uv;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec2f about = linear.at(position(triangle[i]).cast<double>());
      const Vec2f there = at(triangle[i], about);
      const auto far = static_cast<double>((position(triangle[i]) - middle).norm());
      uv[i] = static_cast<double>((there - about).norm()) <= linear.scale() * far ? there : about;
    }
    return uv;
  }

 private:
  Vec3f position(Index vertex) const {
    const Index old = surface_->vertex_count();
    return vertex < old ? surface_->positions[vertex] : patch_->positions[vertex - old];
  }

  SurfacePoint closest(const Vec3f& p) const {
    return *picker_->closest(p, std::numeric_limits<float>::max());
  }

  /// A vertex of the surface may have several, one of each island around it.
  Vec2f at(Index vertex, const Vec2f& about) const {
    if (vertex >= surface_->vertex_count()) return uv_at(*surface_, closest(position(vertex)));
    Vec2f nearest = Vec2f::Constant(std::numeric_limits<float>::infinity());
    for (const Index triangle : surface_->incident[vertex])
      for (std::size_t i = 0; i < 3; ++i) {
        const Vec2f& uv = surface_->triangle_uv[triangle][i];
        if (surface_->triangles[triangle][i] == vertex && (uv - about).norm() < (nearest - about).norm())
          nearest = uv;
      }
    return nearest;
  }

  const Surface* surface_;
  const Picker* picker_;
  const SurfacePatch* patch_;
};

}  // namespace

std::vector<TriangleUv> carried_uv(const Surface& surface, const Picker& picker, const SurfacePatch& patch) {
  if (surface.triangle_uv.empty()) return {};
  std::vector<TriangleUv> uv(patch.triangles.size());
  const UvThere there(surface, picker, patch);
  parallel_blocks(uv.size(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) uv[t] = there.of(patch.triangles[t]);
  });
  return uv;
}

}  // namespace burin
