#pragma once
#include <burin/surface/base_surface/base_surface.h>
#include <burin/surface/picker.h>

#include <optional>

namespace burin {

/// Where the curves of strokes run: on a surface itself, or on its base surface at the brush's scale. There
/// a point's corners are the nearest node, three times. Looked at, not owned.
class CurveGround {
 public:
  /// `base`: null: on the surface itself.
  CurveGround(const Surface& surface, const Picker& picker, BaseSurface* base = nullptr)
      : surface_(&surface), picker_(&picker), base_(base) {}

  struct Place {
    SurfacePoint at;
    Vec3f normal;             ///< unit
    SurfacePoint on_surface;  ///< the point of the surface that it is the place of, where it is of one
  };

  /// Where a point of the surface is on the ground.
  Place place(const SurfacePoint& at) const;

  /// Where a ray that meets the surface meets the ground, so that bumps do not shift what the pen points at,
  /// from whatever side it is seen. Rays at less than 17 degrees to the base surface end before it, nearer to
  /// where they meet the surface. Nothing where the ray misses.
  std::optional<Place> pick(const Ray& ray) const;

  /// The ground nearest to a position of which the surface is not farther than `reach`, so that bumps do not
  /// draw it to their tops.
  std::optional<Place> closest(const Vec3f& position, float reach) const;

  /// Whether a pen may go from one place to the other without leaving the ground: no point of the chord is
  /// farther than a quarter of it from the ground, or none of the chord between the surface's own points from
  /// the surface, which tells where relief as wide as the brush makes the base surface ragged.
  bool connects(const Place& from, const Place& to) const;

  /// The ground nearest to a point not farther than `reach` from it, found from a place near by.
  std::optional<Place> closest(const Vec3f& point, float reach, const SurfacePoint& near) const;

  /// How far apart points of a curve are here: half an edge, object units.
  double point_spacing(const SurfacePoint& at) const;

  double scale() const { return surface_->scale; }

 private:
  Place on_base(Index near, const Vec3f& point) const;
  template <class OnPlane>
  Place settled(const SurfacePoint& at, const OnPlane& on_plane) const;

  const Surface* surface_;
  const Picker* picker_;
  BaseSurface* base_;
};

}  // namespace burin
