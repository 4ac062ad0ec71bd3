#include "painted.h"

namespace burin {
namespace {

/// Of clay, where nothing may be moved.
constexpr float protected_brightness = 0.35f;

Tint tint_at(const Paint& paint, const SurfacePoint& point) {
  Tint tint = Tint::Zero();
  for (std::size_t i = 0; i < 3; ++i) {
    const Index vertex = point.corners[i];
    tint += point.weights[i] * tint_of(paint.colour_of(vertex), paint.mask_of(vertex));
  }
  return tint;
}

}  // namespace

Albedo painted(const Paint& paint) {
  if (paint.colour.empty() && paint.mask.empty()) return clay;
  return [&paint](const SurfacePoint& point) -> Vec3f {
    const Tint tint = tint_at(paint, point);
    const Vec3f colour = tint.head<3>() + (1 - tint[3]) * clay(point);
    return colour * (protected_brightness + (1 - protected_brightness) * tint[4]);
  };
}

}  // namespace burin
