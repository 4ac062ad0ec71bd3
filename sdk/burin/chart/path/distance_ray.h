#pragma once
#include <burin/base/vector.h>

namespace burin {

/// The direction in which the distance from the stroke grows at a node, in the basis (e1, e2) of its frame.
///
/// Beside the stroke it is e2. Beyond a round end all shortest ways come from the end, and (t, d) are
/// geodesic normal coordinates around it: t beyond the end and d are r cos(a) and r sin(a), r the geodesic
/// distance from the end and a the angle there, counted from the stroke's tangent. At right angles to the end
/// they are those from beside the stroke. e1 is the stroke's tangent carried along the ray; `stretch` is that
/// of circles around the end against circles of the same r on the plane, and `curvature` by how much less
/// than 1 / r they bend. Toward the end, and on the plane, these are 1 and 0.
struct DistanceRay {
  float ahead = 0, left = 1;             ///< unit vector
  float length = 0, inverse_length = 0;  ///< r, object units, and 1 / r; both 0 beside the stroke

  bool from_end() const { return length > 0; }
};

/// A step in parts at right angles to the ray and along it; object units. Here and below a ray is a
/// DistanceRay with floats, or several rays side by side with as many numbers.
template <class Real>
struct RayParts {
  Real across, out;
};

template <class Ray, class Real>
RayParts<Real> in_parts(const Ray& ray, const Real& u, const Real& v) {
  return {ray.left * u - ray.ahead * v, ray.ahead * u + ray.left * v};
}

/// Of lines at right angles to the ray in the plane of t and d that are straight on the surface, against it;
/// 1 / length.
template <class Ray, class Real>
Real bend_across(const Ray& ray, const Real& curvature, const Real& inverse_stretch) {
  return curvature + (inverse_stretch * inverse_stretch - 1) * ray.inverse_length;
}

/// What a step (u, v) in the basis (e1, e2) adds to (t, d), to second order. Curvature and stretch are those
/// of the frame where it begins.
inline Vec2f ray_step(const DistanceRay& ray, float curvature, float inverse_stretch, float u, float v) {
  const auto [across, out] = in_parts(ray, u, v);
  const float bend = bend_across(ray, curvature, inverse_stretch);
  const float beside = across * inverse_stretch * (1 + curvature * out),
              away = out - bend * across * across / 2;
  return {ray.left * beside + ray.ahead * away, ray.left * away - ray.ahead * beside};
}

/// By how much e1 turns to the left against parallel transport on a step across the ray; 1 / length.
template <class Ray, class Real>
Real turn_across(const Ray& ray, const Real& curvature, const Real& inverse_stretch) {
  return curvature + (inverse_stretch - 1) * ray.inverse_length;
}

/// `curvature` and `stretch` of the frames around an end, for one or several at a time.
template <class Real>
struct RoundShape {
  Real curvature, stretch;
};

/// Farther along a ray, from r = `from` to r = `to`: the length G of circles an angle apart obeys G'' = -K G,
/// of which this is the third order. `gauss`: K on the way.
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

/// At r from the end, where only the surface's curvature near by is known.
inline RoundShape<float> shape_around_end(float r, float gauss) {
  return {gauss * r / 3, 1 - gauss * r * r / 6};
}

}  // namespace burin
