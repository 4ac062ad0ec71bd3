#pragma once
#include <burin/base/vector.h>

namespace burin {

/// The direction of a node's shortest path away from the stroke, in the basis (e1, e2) of the node's frame.
///
/// Beside the stroke it is e2. Beyond a round end all shortest paths start at the end, and (t, d) are
/// geodesic normal coordinates around it: t, counted from the end, is r cos(a) and d is r sin(a), where r is
/// the geodesic distance from the end and a the angle at the end from the stroke's tangent. At a = +-90
/// degrees they agree with the Fermi coordinates beside the stroke. e1 is the stroke's tangent, parallel
/// transported along the ray. `stretch` is the length of a circle around the end over that of a circle of
/// radius r in the plane; `curvature` is 1 / r minus the circle's geodesic curvature. Near the end, and on
/// the plane, they are 1 and 0.
struct DistanceRay {
  float ahead = 0, left = 1;             ///< unit vector: components along e1 and e2
  float length = 0, inverse_length = 0;  ///< r, object units, and 1 / r; both 0 beside the stroke

  bool from_end() const { return length > 0; }
  bool operator==(const DistanceRay&) const = default;
};

/// A step in components across the ray and along it, object units. In the templates below a Ray is a
/// DistanceRay with float numbers, or a structure of arrays of several rays.
template <class Real>
struct RayParts {
  Real across, out;
};

template <class Ray, class Real>
RayParts<Real> in_parts(const Ray& ray, const Real& u, const Real& v) {
  return {ray.left * u - ray.ahead * v, ray.ahead * u + ray.left * v};
}

/// Curvature, in the (t, d) plane, of a geodesic of the surface that crosses the ray at a right angle; 1 /
/// length, positive when the geodesic bends back along the ray.
template <class Ray, class Real>
Real bend_across(const Ray& ray, const Real& curvature, const Real& inverse_stretch) {
  return curvature + (inverse_stretch * inverse_stretch - 1) * ray.inverse_length;
}

/// The change of (t, d) by a step (u, v) in the basis (e1, e2), to second order. Curvature and stretch are
/// those of the frame where the step starts.
inline Vec2f ray_step(const DistanceRay& ray, float curvature, float inverse_stretch, float u, float v) {
  const auto [across, out] = in_parts(ray, u, v);
  const float bend = bend_across(ray, curvature, inverse_stretch);
  const float beside = across * inverse_stretch * (1 + curvature * out),
              away = out - bend * across * across / 2;
  return {ray.left * beside + ray.ahead * away, ray.left * away - ray.ahead * beside};
}

/// The angle by which e1 turns to the left against parallel transport, per length of a step across the ray.
template <class Ray, class Real>
Real turn_across(const Ray& ray, const Real& curvature, const Real& inverse_stretch) {
  return curvature + (inverse_stretch - 1) * ray.inverse_length;
}

/// `curvature` and `stretch` of one or several frames beyond a round end; see DistanceRay.
template <class Real>
struct RoundShape {
  Real curvature, stretch;
};

/// Continues the shape along a ray from r = `from` to r = `to`, to third order in the step. The length G of
/// the circle's arc per radian obeys the Jacobi equation G'' = -K G; `gauss` is K along the way.
template <class Real>
RoundShape<Real> farther_out(const RoundShape<Real>& shape, const Real& from, const Real& to,
                             const Real& gauss) {
  const Real rise = to - from, g = shape.stretch * from, slope = shape.stretch - shape.curvature * g;
  const Real fall = gauss * rise * rise * (g / 2 + slope * rise / 6);
  const Real stretch = shape.stretch - (shape.curvature * g * rise + fall) / to;
  const Real lag = shape.curvature * g * from +
                   gauss * rise * (g * (from + rise / 2) + slope * rise * (from / 2 + rise / 3));
  return {lag / (to * to * stretch), stretch};
}

/// The shape at the distance r from the end, for a constant Gauss curvature between.
inline RoundShape<float> shape_around_end(float r, float gauss) {
  return {gauss * r / 3, 1 - gauss * r * r / 6};
}

}  // namespace burin
