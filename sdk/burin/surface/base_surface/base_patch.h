#pragma once
#include <burin/base/vector.h>

namespace burin {

/// The base surface around one of its nodes: a paraboloid over the tangent plane at the node. Local
/// coordinates (x, y) run along axis_x and axis_y = normal x axis_x, in object units. A Number is a float or
/// an array of floats, one per lane.
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

  /// The derivatives of the height along both axes.
  template <class Number>
  Local<Number> slope(const Local<Number>& at) const {
    return {xx * at.x + xy * at.y, xy * at.x + yy * at.y};
  }

  /// The foot point on the paraboloid, to second order in the point's distance from the node. The height over
  /// the paraboloid is clamped to half the least distance at which its normals may meet: above that, on
  /// relief as high as the brush is wide, there is no foot point nearby. So the foot is less than twice as
  /// far from the node as the point is, measured along the tangent plane.
  Local<float> foot(const Vec3f& point) const;

  /// The foot point, moved toward the node to the distance `extent` if it is farther away; object units.
  Local<float> foot_within(const Vec3f& point, float extent) const;
  /// The position of a point of the paraboloid, and its unit normal.
  Vec3f point_at(const Local<float>& at) const;
  Vec3f normal_at(const Local<float>& at) const;
};

}  // namespace burin
