// Picking on point sets: the ray is intersected with discs around the points, then Newton's method finds
// the smooth surface near the disc (PointProjection).
#include <burin/base/error.h>
#include <burin/base/trees/box_tree.h>
#include <burin/surface/picking/box_ray.h>
#include <burin/surface/picking/pick_scene.h>
#include <burin/surface/points/point_projection.h>
#include <burin/surface/points/point_tree.h>

#include <algorithm>
#include <compare>
#include <vector>

namespace burin {
namespace {

/// Limits the discs per ray: a ray along the border of the points may hit many discs but never the surface.
constexpr int most_discs = 64;

/// What the tree asks of the discs around points.
struct Discs {
  const Surface& surface;
  std::vector<float> radii;  ///< [point] as far as its farthest neighbour: the discs of neighbours overlap

  explicit Discs(const Surface& points) : surface(points) {
    for (Index point = 0; point < points.vertex_count(); ++point) {
      float radius = 0;
      for (const Index neighbour : points.neighbours[point])
        radius = std::max(radius, (points.positions[neighbour] - points.positions[point]).norm());
      radii.push_back(radius);
    }
  }

  std::size_t size() const { return radii.size(); }
  void extend(Eigen::AlignedBox3f& box, Index point) const {
    const Vec3f half = Vec3f::Constant(radii[point]);
    box.extend(surface.positions[point] - half);
    box.extend(surface.positions[point] + half);
  }
};
using DiscTree = BoxTree<Discs>;

/// Where a ray meets a disc. Ordered: equally near ones by their numbers.
struct DiscHit {
  double distance;  ///< in lengths of the ray's direction
  Index point;

  auto operator<=>(const DiscHit&) const = default;
};
constexpr DiscHit no_disc{BoxRay::infinity, no_index};

/// The first disc that a ray meets after another.
class NextDisc {
 public:
  NextDisc(const DiscTree& discs, const Ray& ray, const DiscHit& after)
      : discs_(discs.items()),
        boxes_(discs.box(), ray),
        origin_(ray.origin.cast<double>()),
        direction_(ray.direction.cast<double>()),
        after_(after) {}

  BoxLanes::Lane nearest(const BoxLanes& boxes) const { return boxes_.nearest(boxes); }
  bool reaches(double distance) const { return distance < BoxRay::infinity && distance <= found_.distance; }
  void meet(Index begin, Index end) {
    for (Index point = begin; point < end; ++point) {
      const DiscHit hit = met(point);
      if (hit > after_ && hit < found_) found_ = hit;
    }
  }
  const DiscHit& found() const { return found_; }

 private:
  /// Discs that the ray runs along are not met.
  DiscHit met(Index point) const {
    const Vec3d centre = discs_.surface.positions[point].cast<double>() - origin_,
                normal = discs_.surface.normals[point].cast<double>();
    const double distance = centre.dot(normal) / direction_.dot(normal), radius = discs_.radii[point];
    const bool inside =
        distance >= 0 && (distance * direction_ - centre).squaredNorm() <= radius * radius;  // not for NaN
    return inside ? DiscHit{distance, point} : no_disc;
  }

  const Discs& discs_;
  BoxRay boxes_;
  Vec3d origin_, direction_;
  DiscHit after_, found_ = no_disc;
};

class PointScene : public PickScene {
 public:
  explicit PointScene(const Surface& surface)
      : tree_(surface.positions), projection_(surface, tree_), discs_(Discs(surface)) {}
  std::optional<SurfacePoint> pick(const Ray& ray) const override;
  std::optional<SurfacePoint> closest(const Vec3f& position, float max_distance) const override;
  std::optional<std::vector<Index>> near(const Vec3f&, float, std::size_t) const override {
    throw ContractError("a point set has no triangles");
  }
  void update(std::span<const Index>) override {
    throw ContractError("the picker of a point set cannot follow moved points");
  }

 private:
  PointTree tree_;
  PointProjection projection_;
  DiscTree discs_;
};

std::optional<SurfacePoint> PointScene::pick(const Ray& ray) const {
  if (!ray.origin.allFinite() || !ray.direction.allFinite() || ray.direction.isZero(0)) return std::nullopt;
  const Vec3d origin = ray.origin.cast<double>(), direction = ray.direction.cast<double>();
  DiscHit last{-1, 0};
  for (int disc = 0; disc < most_discs; ++disc) {
    NextDisc next(discs_, ray, last);
    discs_.search(next);
    last = next.found();
    if (last == no_disc) return std::nullopt;
    const auto met = projection_.meet(origin + last.distance * direction, direction);
    if (met && (met->position - ray.origin).dot(ray.direction) >= 0) return met;
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
