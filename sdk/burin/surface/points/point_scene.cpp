// Picking on point sets: Embree intersects the ray with discs around the points, then Newton's method finds
// the smooth surface near the disc (PointProjection).
#include <burin/base/error.h>
#include <burin/surface/picking/embree_handles.h>
#include <burin/surface/picking/pick_scene.h>
#include <burin/surface/points/point_projection.h>
#include <burin/surface/points/point_tree.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace burin {
namespace {

/// Limits the discs per ray: a ray along the border of the points may hit many discs but never the surface.
constexpr int most_discs = 64;

class PointScene : public PickScene {
 public:
  explicit PointScene(const Surface& surface);
  std::optional<SurfacePoint> pick(const Ray& ray) const override;
  std::optional<SurfacePoint> closest(const Vec3f& position, float max_distance) const override;
  void update(std::span<const Index>) override {
    throw ContractError("the picker of a point set cannot follow moved points");
  }

 private:
  void add_discs();

  const Surface& surface_;
  PointTree tree_;
  PointProjection projection_;
  std::vector<Eigen::Vector4f> discs_;  ///< [point] position and radius
  Device device_;
  EmbreeScene scene_;
};

/// Whether Embree accepts the ray; it aborts the program for others.
bool is_valid(const Ray& ray) {
  constexpr float farthest = 1e18F;  // Embree's own limit is 1.844e18
  const auto fits = [](const Vec3f& v) { return v.cwiseAbs().maxCoeff() < farthest; };
  return ray.origin.allFinite() && ray.direction.allFinite() && fits(ray.origin) && fits(ray.direction) &&
         !ray.direction.isZero(0);
}

/// The distance of the farthest neighbour, so that the discs of neighbours overlap.
float disc_radius(const Surface& surface, Index point) {
  float radius = 0;
  for (const Index neighbour : surface.neighbours[point]) {
    radius = std::max(radius, (surface.positions[neighbour] - surface.positions[point]).norm());
  }
  return radius;
}

PointScene::PointScene(const Surface& surface)
    : surface_(surface), tree_(surface.positions), projection_(surface, tree_), device_(new_device()) {
  scene_.reset(rtcNewScene(device_.get()));
  rtcSetSceneFlags(scene_.get(), RTC_SCENE_FLAG_COMPACT | RTC_SCENE_FLAG_ROBUST);
  for (Index point = 0; point < surface.vertex_count(); ++point) {
    discs_.push_back(surface.positions[point].homogeneous());
    discs_.back().w() = disc_radius(surface, point);
  }
  add_discs();
  rtcCommitScene(scene_.get());
  if (rtcGetDeviceError(device_.get()) != RTC_ERROR_NONE)
    throw Error("Embree cannot build its tree over the points");
}

void PointScene::add_discs() {
  const RTCGeometry discs = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_ORIENTED_DISC_POINT);
  rtcSetSharedGeometryBuffer(discs, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, discs_.data(), 0,
                             sizeof(discs_[0]), discs_.size());
  auto* normals = static_cast<Vec3f*>(rtcSetNewGeometryBuffer(
      discs, RTC_BUFFER_TYPE_NORMAL, 0, RTC_FORMAT_FLOAT3, sizeof(Vec3f), discs_.size()));
  if (normals) std::ranges::copy(surface_.normals, normals);
  rtcCommitGeometry(discs);
  rtcAttachGeometry(scene_.get(), discs);
  rtcReleaseGeometry(discs);
}

std::optional<SurfacePoint> PointScene::pick(const Ray& ray) const {
  if (!is_valid(ray)) return std::nullopt;
  RTCRayHit query = whole_ray(ray);
  for (int disc = 0; disc < most_discs; ++disc) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene_.get(), &context, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
    const float distance = query.ray.tfar;
    const Vec3d direction = ray.direction.cast<double>();
    const auto met =
        projection_.meet(ray.origin.cast<double>() + static_cast<double>(distance) * direction, direction);
    if (met && (met->position - ray.origin).dot(ray.direction) >= 0) return met;
    query = whole_ray(ray);
    query.ray.tnear = std::nextafter(distance, query.ray.tfar);
  }
  return std::nullopt;
}

std::optional<SurfacePoint> PointScene::closest(const Vec3f& position, float max_distance) const {
  if (!position.allFinite()) return std::nullopt;
  const SurfacePoint foot = projection_.foot(position.cast<double>());
  if (!((foot.position - position).norm() <= max_distance)) return std::nullopt;
  return foot;
}

}  // namespace

std::unique_ptr<PickScene> make_point_scene(const Surface& surface) {
  return std::make_unique<PointScene>(surface);
}

}  // namespace burin
