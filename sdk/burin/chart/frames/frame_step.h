#pragma once
#include <burin/base/vector.h>
#include <burin/surface/geometry/parallel_transport.h>

#include <algorithm>
#include <cmath>

namespace burin {

/// A frame at q transported along the edge to x.
struct FrameStep {
  Vec2f step;  ///< T_q(x), the vector from q to x in the basis (e1, e2) of q, object units
  Vec3f e1;    ///< e1 of q transported to x
};

/// Computes T_q(x) of [Schmidt 2013, section 2.1]: the edge, projected to the tangent plane and scaled back
/// to its length. Two refinements make it exact to third order, and exact on cylinders and along great
/// circles. The plane of projection is half way between the tangent planes of q and x, and the chord c is
/// corrected to the geodesic over it: c = s T + s^3 / 24 T'' at the middle, T'' = -(T . S T) S T in the
/// tangent plane, and the difference of the normals is dn = s S T (S the shape operator), which gives c + (dn
/// . c) dn / 24. Normals that differ by more than 60 degrees cannot be samples of one arc and count as 60
/// degrees. An edge along the normal gives a step of zero.
inline FrameStep step_along_edge(const Vec3f& q, const Vec3f& normal_q, const Vec3f& e1_q, const Vec3f& x,
                                 const Vec3f& normal_x) {
  const Vec3f sum = normal_q + normal_x;
  const float size = sum.norm();
  const Vec3f middle = size > 0 ? Vec3f(sum / size) : normal_q;
  const Vec3f e1 = transport(e1_q, normal_q, middle), e2 = middle.cross(e1);

  const Vec3f chord = x - q, turn = normal_x - normal_q;
  const Vec2f flat(chord.dot(e1), chord.dot(e2));
  const float length = flat.norm();
  if (!(length > 0)) return {Vec2f(0, 0), transport(e1, middle, normal_x)};
  const float bend = turn.dot(chord) / (24 * std::max(turn.squaredNorm(), 1.F));
  return {flat * (chord.norm() / length) + bend * Vec2f(turn.dot(e1), turn.dot(e2)),
          transport(e1, middle, normal_x)};
}

}  // namespace burin
