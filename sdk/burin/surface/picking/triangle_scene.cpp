// Picking on meshes: searches a tree of triangles for the first hit of a ray or for the point closest to a
// position.
#include <burin/base/trees/box_tree.h>
#include <burin/surface/geometry/triangle_box.h>
#include <burin/surface/picking/box_ray.h>
#include <burin/surface/picking/closest_point.h>
#include <burin/surface/picking/pick_scene.h>
#include <burin/surface/picking/ray_triangle.h>
#include <burin/surface/picking/sliver_slabs.h>

#include <limits>
#include <utility>
#include <vector>

namespace burin {
namespace {

/// What the tree asks of triangles.
struct Triangles {
  const Surface& surface;

  std::size_t size() const { return surface.triangles.size(); }
  Eigen::AlignedBox3f box(Index triangle) const {
    return triangle_box(surface.positions, surface.triangles[triangle]);
  }
  void extend(Eigen::AlignedBox3f& whole, Index triangle) const { whole.extend(box(triangle)); }
};
using TriangleTree = BoxTree<Triangles>;
using Box = TriangleTree::Box;

/// The query for the nearest hit of a ray; among equally near triangles the one with the lowest index wins.
class NearestHit {
 public:
  NearestHit(const Surface& surface, const Box& whole, const Ray& ray)
      : surface_(surface), boxes_(whole, ray), ray_(ray) {}

  BoxLanes::Lane nearest(const BoxLanes& boxes) const { return boxes_.nearest(boxes); }

  /// Whether a box at this distance may hold the nearest hit. The margin covers the rounding of the distance
  /// to float.
  bool reaches(double distance) const {
    return distance < BoxRay::infinity && distance <= distance_ * (1 + 1e-6);
  }

  void meet(Index begin, Index end) {
    for (Index triangle = begin; triangle < end; ++triangle)
      if (const auto hit = ray_.meet(surface_, triangle)) keep_nearest(triangle, *hit);
  }

  std::optional<SurfacePoint> point() const {
    if (triangle_ == no_index) return std::nullopt;
    return point_on(surface_, triangle_, hit_.u, hit_.v);
  }

 private:
  void keep_nearest(Index triangle, const TriangleHit& hit) {
    const auto distance = static_cast<float>(hit.distance);
    if (!(distance < distance_ || (distance == distance_ && triangle < triangle_))) return;
    triangle_ = triangle;
    hit_ = hit;
    distance_ = distance;
  }

  const Surface& surface_;
  BoxRay boxes_;
  TriangleRay ray_;
  Index triangle_ = no_index;
  TriangleHit hit_{};
  /// Distance in multiples of the ray's direction vector. It is a float so that hits on a common edge are
  /// equally near.
  float distance_ = std::numeric_limits<float>::infinity();
};

/// The query for the closest point; among equally close triangles the one with the lowest index wins.
class ClosestPoint {
 public:
  ClosestPoint(const Surface& surface, const SliverSlabs& slabs, const Vec3f& query, double max_distance)
      : surface_(surface), slabs_(slabs), query_(query), squared_distance_(max_distance * max_distance) {}

  BoxLanes::Lane nearest(const BoxLanes& boxes) const { return squared_distances(boxes, query_); }

  /// Whether a box at this distance may hold the closest point. The margin keeps rounding from hiding an
  /// equally close triangle.
  bool reaches(double squared_distance) const { return squared_distance <= squared_distance_ * (1 + 1e-9); }

  void meet(Index begin, Index end) {
    if (!reaches(slabs_.nearest(begin, query_.cast<double>()))) return;
    for (Index triangle = begin; triangle < end; ++triangle) {
      // Rules out most triangles at a quarter of the cost.
      const Box box = Triangles{surface_}.box(triangle);
      if (!reaches(box.cast<double>().squaredExteriorDistance(query_.cast<double>()))) continue;
      const TrianglePoint found = closest_point(surface_, triangle, query_.cast<double>());
      const bool nearer = found.squared_distance < squared_distance_;
      const bool same = found.squared_distance == squared_distance_;
      if (!nearer && !(same && triangle < triangle_)) continue;
      squared_distance_ = found.squared_distance;
      triangle_ = triangle;
      u_ = found.u;
      v_ = found.v;
    }
  }

  std::optional<SurfacePoint> point() const {
    if (triangle_ == no_index) return std::nullopt;
    return point_on(surface_, triangle_, u_, v_);
  }

 private:
  const Surface& surface_;
  const SliverSlabs& slabs_;
  Vec3f query_;
  double squared_distance_;
  Index triangle_ = no_index;
  double u_ = 0, v_ = 0;
};

/// The query for the triangles whose boxes are within a distance, as long as they are not too many.
class WithinReach {
 public:
  WithinReach(const Surface& surface, const Vec3f& query, float max_distance, std::size_t most)
      : items_{surface},
        query_(query),
        squared_distance_((1 + margin) * max_distance * max_distance),
        most_(most) {}

  BoxLanes::Lane nearest(const BoxLanes& boxes) const { return squared_distances(boxes, query_); }
  bool reaches(float squared_distance) const {
    return squared_distance <= squared_distance_ && triangles_.size() <= most_;
  }

  void meet(Index begin, Index end) {
    for (Index triangle = begin; triangle < end; ++triangle)
      if (items_.box(triangle).squaredExteriorDistance(query_) <= squared_distance_)
        triangles_.push_back(triangle);
  }

  std::optional<std::vector<Index>> triangles() && {
    if (triangles_.size() > most_) return std::nullopt;
    return std::move(triangles_);
  }

 private:
  /// Above what floats round in a squared distance.
  static constexpr float margin = 2e-6F;

  Triangles items_;
  Vec3f query_;
  float squared_distance_;
  std::size_t most_;
  std::vector<Index> triangles_;
};

class TriangleScene : public PickScene {
 public:
  explicit TriangleScene(const Surface& surface)
      : surface_(surface), tree_(Triangles{surface}), slabs_(surface, TriangleTree::fan) {}

  std::optional<SurfacePoint> pick(const Ray& ray) const override {
    return found(NearestHit(surface_, tree_.box(), ray));
  }
  std::optional<SurfacePoint> closest(const Vec3f& position, float max_distance) const override {
    return found(ClosestPoint(surface_, slabs_, position, max_distance));
  }
  std::optional<std::vector<Index>> near(const Vec3f& position, float max_distance,
                                         std::size_t most) const override {
    WithinReach query(surface_, position, max_distance, most);
    tree_.search(query);
    return std::move(query).triangles();
  }
  void update(std::span<const Index> moved_vertices) override {
    moved_.clear();
    for (const Index vertex : moved_vertices)
      for (const Index triangle : surface_.incident[vertex]) moved_.push_back(triangle);
    tree_.update(moved_);
    for (const Index triangle : moved_) slabs_.update(triangle);
  }

 private:
  template <class Query>
  std::optional<SurfacePoint> found(Query query) const {
    tree_.search(query);
    return query.point();
  }

  const Surface& surface_;
  TriangleTree tree_;
  SliverSlabs slabs_;
  std::vector<Index> moved_;  ///< triangles of an update
};

}  // namespace

std::unique_ptr<PickScene> make_triangle_scene(const Surface& surface) {
  return std::make_unique<TriangleScene>(surface);
}

}  // namespace burin
