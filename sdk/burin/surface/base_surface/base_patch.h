#pragma once
#include <burin/base/vector.h>

namespace burin {

/// The base surface around one of its nodes: a paraboloid over the tangent plane there. (x, y) are along
/// axis_x and axis_y = normal x axis_x, object units. Numbers are floats or arrays of them, lane by lane.
struct BasePatch {
  Vec3f position, normal, axis_x;
  float xx = 0, xy = 0, yy = 0;  ///< second derivatives of the height, 1 / length

  template <class Number>
  struct Local {
    Number x, y;
  };

  Vec3f axis_y() const { return normal.cross(axis_x); }
  float gauss_curvature() const { return xx * yy - xy * xy; }

  template <class Number>
  Number height(const Local<Number>& at) const {
    return (xx * at.x * at.x + yy * at.y * at.y) / 2 + xy * at.x * at.y;
  }

  /// Of the height along both axes.
  template <class Number>
  Local<Number> slope(const Local<Number>& at) const {
    return {xx * at.x + xy * at.y, xy * at.x + yy * at.y};
  }

  /// The foot of a point on the paraboloid, to second order in its distance from the node. Points higher
  /// over the paraboloid than half the least distance at which normals of it may meet count as that high:
  /// farther up, on relief as high as the brush is wide, there is no foot nearby. So it is less than twice as
  /// far from the node as the point is along the tangent plane.
  Local<float> foot(const Vec3f& point) const;

  /// The foot, or where it lies beyond the distance `extent`, what of the paraboloid is there in its
  /// direction.
  Local<float> foot_within(const Vec3f& point, float extent) const;
  Vec3f place(const Local<float>& at) const;
  Vec3f normal_at(const Local<float>& at) const;
};

}  // namespace burin
