#pragma once
#include <burin/base/vector.h>

#include <array>
#include <span>

namespace burin {

/// What a stroke is snapped to.
enum class FeatureKind {
  ridge,       ///< where the greatest principal curvature is greatest across the stroke; convex is positive
  valley,      ///< where the least principal curvature is least
  silhouette,  ///< where the surface turns away from the viewer: normal . direction of sight = 0
  border,      ///< the surface's open border
  high,        ///< where a value of the vertices is greatest across the stroke
  low,         ///< where it is least
  crease,      ///< edges at which two triangles meet at an angle, and edges that are given
  suggestive,  ///< where it would turn away from a viewer who moved a little [DeCarlo et al. 2003]
};

/// Where a surface is seen from.
struct Viewpoint {
  bool is_eye = false;         ///< perspective: `at` is the eye's position; else the direction of sight
  Vec3d at = Vec3d(0, 0, -1);  ///< object units; a direction has any length but 0
};

/// A kind of line on a surface.
struct Feature {
  FeatureKind kind = FeatureKind::ridge;
  Viewpoint view = {};                 ///< of silhouettes and suggestive contours
  std::span<const float> values = {};  ///< [vertex of the surface], of high and low; must outlive the object
  double least_angle = 30;             ///< of creases, between the normals of the triangles, degrees
  /// Edges that belong to creases whatever their angle, as pairs of vertices of the surface, the lower first,
  /// ascending, such as those of a cage; must outlive the object.
  std::span<const std::array<Index, 2>> creases = {};
};

/// Whether features of this kind consist of edges of the surface.
inline bool consists_of_edges(FeatureKind kind) {
  return kind == FeatureKind::border || kind == FeatureKind::crease;
}

/// Whether features of this kind are crests of values of the vertices.
inline bool has_values(FeatureKind kind) { return kind == FeatureKind::high || kind == FeatureKind::low; }

/// Whether features of this kind depend on the view.
inline bool is_seen(FeatureKind kind) {
  return kind == FeatureKind::silhouette || kind == FeatureKind::suggestive;
}

}  // namespace burin
