#pragma once
#include <memory>

#include "subject.h"

namespace burin::paper {

/// The meshes that are there, refined to 700,000 triangles and more: the sample ewer always, those of
/// ../shared/data where that folder is. The ewer alone, with fewer triangles, when `quick`.
class Scenes {
 public:
  explicit Scenes(bool quick);

  const std::vector<std::unique_ptr<Scene>>& all() const { return scenes_; }

  /// Null for one that is not there.
  const Scene* find(const std::string& name) const;

 private:
  std::vector<std::unique_ptr<Scene>> scenes_;
};

/// A stroke as drawn on a flat sheet that is then projected onto the surface. Pattern: x to the right and y
/// up as seen along `direction`, in radii, its origin over the anchor.
struct Drawing {
  std::string name, scene;
  Vec3f anchor;     ///< in the bounding box, 0..1 from its lowest to its highest corner
  Vec3f direction;  ///< of sight
  double radius;    ///< in shares of the surface's scale
  std::vector<Vec2d> pattern;
};

Subject draw(const Scene& scene, const Drawing& drawing);

}  // namespace burin::paper
