#pragma once
#include <burin/surface/base_surface/base_surface.h>
#include <burin/surface/picker.h>

#include <optional>

namespace burin {

/// The ground of the curves of strokes: a surface itself, or its base surface at the brush's scale. A point
/// of a base surface has its nearest node as all three corners. Does not own what its constructor is given.
class CurveGround {
 public:
  /// `base`: null for the surface itself.
  CurveGround(const Surface& surface, const Picker& picker, BaseSurface* base = nullptr)
      : surface_(&surface), picker_(&picker), base_(base) {}

  /// A point of the ground.
  struct Point {
    SurfacePoint at;
    Vec3f normal;             ///< unit
    SurfacePoint on_surface;  ///< the point of the surface that was projected to it, if there is one
  };

  /// The point of the ground that belongs to a point of the surface.
  Point point(const SurfacePoint& at) const;

  /// Intersects a ray that meets the surface with the ground, so that bumps do not shift the point that the
  /// pen points at, whatever the direction of view. A ray at less than 17 degrees to the base surface ends
  /// nearer to its intersection with the surface. Returns nothing if the ray misses the surface.
  std::optional<Point> pick(const Ray& ray) const;

  /// The point of the ground that is closest to a position, so that bumps do not attract it to their tops.
  /// Returns nothing if the surface is farther than `reach` (object units) from the position.
  std::optional<Point> closest(const Vec3f& position, float reach) const;

  /// Whether a pen whose brush has this radius (object units) can move from one point to the other without
  /// leaving the ground. Three points of the chord must be within a quarter of its length of the ground.
  /// Failing that, the same must hold for the chord between the points of the surface itself, since relief as
  /// wide as the brush makes the base surface ragged. Failing that too, points at most four radii apart may
  /// be joined by a path over the surface within half the radius of the chord, since the pen may go from one
  /// side of a groove to the other with one sample. Both points must have their point of the surface.
  bool connects(const Point& from, const Point& to, double radius) const;

  /// The point of the ground closest to a point, found by a search that starts at `near`. Returns nothing if
  /// it is farther than `reach` (object units).
  std::optional<Point> closest(const Vec3f& point, float reach, const SurfacePoint& near) const;

  /// Whether the surface lies within `reach` (object units) over or under a point of the ground, along its
  /// normal. False where the base surface goes on beyond the end of the surface.
  bool is_covered(const Point& point, double reach) const;

  /// The spacing of the points of a curve here: half an edge, object units.
  double point_spacing(const SurfacePoint& at) const;

  double scale() const { return surface_->scale; }

 private:
  Point on_base(Index near, const Vec3f& point) const;
  template <class OnPlane>
  Point settled(const SurfacePoint& at, const OnPlane& on_plane) const;

  const Surface* surface_;
  const Picker* picker_;
  BaseSurface* base_;
};

}  // namespace burin
