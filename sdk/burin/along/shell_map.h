#pragma once
#include <burin/chart/box_grid.h>
#include <burin/volume/shell.h>
#include <burin/volume/solid.h>

#include <optional>
#include <vector>

namespace burin {

/// Maps points (t, d, h) of a stroke's coordinates to space, the other way around as Prism::find(): to x + h
/// n where x is the place of (t, d) on the base surface, within the sheet of that t, and n the unit normal
/// there. Both are interpolated in the chart's triangles, so that errors are of second order in their edges.
///
/// Where the chart ends, beyond the focal points of a bend or at the border of the surface, points keep their
/// t and h and come as near to their d as the chart does: they lie on the line where the stroke's legs meet,
/// as in a mitre, and do not fold. Over a gap of the surface along the stroke they lie at its nearer side.
///
/// Inside of a corner the chart may have a sheet of its own for each leg, see Visit. Then each goes on beyond
/// the line where they meet, into the other, as where the stroke crosses itself.
///
/// Heights are not limited: beyond the focal surface of a hollow the map turns inside out.
///
/// Surface and chart must outlive it. Any thread, concurrently.
class ShellMap {
 public:
  /// Throws Error where the chart has no triangle.
  explicit ShellMap(const SolidGround& ground);

  /// Object units; on a closed stroke t counts modulo the length.
  Vec3d operator()(double t, double d, double h) const;

 private:
  /// A place in a triangle, by the weights of its corners 1 and 2.
  struct Hit {
    const Prism* prism;
    double a, b;
  };

  /// A place on the stroke.
  struct Start {
    Hit on_stroke;
    double t;
  };

  /// What the chart covers of the stroke itself, without a gap: t, and the triangles at both ends.
  struct Covered {
    double begin, end;
    const Prism *first, *last;
  };

  std::optional<Hit> find(const Vec2d& place) const;
  void look_at(const Vec2d& place, std::optional<Hit>& best) const;
  Start start_of(double t) const;
  Hit last_before(const Start& start, double d) const;
  void find_covered();

  double length_;
  bool closed_;
  std::vector<Prism> prisms_;
  BoxGrid grid_;  ///< bounding boxes of prisms_ in the (t, d) plane
  std::vector<Covered> covered_;
};

}  // namespace burin
