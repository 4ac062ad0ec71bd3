// Computes base surfaces by moving least squares over clusters of vertices [Lancaster and Salkauskas 1981].
// The height over the plane at right angles to the mean normal is a weighted least-squares quadratic in (x,
// y). Its value in the middle preserves heights of third degree and nearly removes waves shorter than the
// reach. Clusters are weighted by their area projected along the normal, as an integral over (x, y) requires
// however steep the relief is. A fit costs O(samples).
#include <burin/surface/base_surface/base_fits.h>
#include <burin/surface/geometry/quadratic_fit.h>

#include <Eigen/Geometry>

namespace burin {
namespace {

/// The unit normal of a height field with these slopes over a plane.
Vec3f tilted(const Vec3f& normal, const Vec3f& axis_x, const Vec3f& axis_y,
             const QuadraticFit::Terms& height) {
  return (normal - static_cast<float>(height[1]) * axis_x - static_cast<float>(height[2]) * axis_y)
      .normalized();
}

}  // namespace

Vec3f normal_around(const Vec3f& origin, double reach, const SurfaceSamples& samples) {
  const auto whole = static_cast<float>(reach * reach);
  Vec3f area = Vec3f::Zero();
  for (const SurfaceSamples::Block& block : samples.blocks()) {
    const SurfaceSamples::Lanes counts = (4 * block.from(origin).squared_length() <= whole).cast<float>();
    area += Vec3f((counts * block.up.x).sum(), (counts * block.up.y).sum(), (counts * block.up.z).sum());
  }
  return area.squaredNorm() > 0 ? Vec3f(area.normalized()) : Vec3f(Vec3f::Zero());
}

SurfaceSample smoothed(const SurfaceSample& origin, double reach, const SurfaceSamples& samples) {
  using Lanes = SurfaceSamples::Lanes;
  if (origin.up.isZero(0)) return origin;
  const auto whole = static_cast<float>(reach * reach);
  const Vec3f normal = origin.up, axis_x = normal.unitOrthogonal(), axis_y = normal.cross(axis_x);
  QuadraticFit fit(reach);
  float spread = 0, area = 0;
  for (const SurfaceSamples::Block& block : samples.blocks()) {
    const SurfaceSamples::Vectors way = block.from(origin.position);
    const Lanes squared = way.squared_length();
    if (!(squared.minCoeff() <= whole)) continue;
    // Areas that face away from the normal belong to another sheet and do not count.
    const Lanes seen = block.up.dot(normal).max(0.F) * (squared <= whole).cast<float>();
    fit.add(way.dot(axis_x), way.dot(axis_y), way.dot(normal), seen);
    spread += (seen * block.spread).sum();
    area += seen.sum();
  }
  const QuadraticFit::Terms height = fit.solve();
  // The mean of a height over a cluster exceeds the height at its middle by half the spread times the
  // Laplacian.
  const double of_means = area > 0 ? static_cast<double>(spread / area) / 2 * (height[3] + height[5]) : 0;
  return {origin.position + static_cast<float>(height[0] - of_means) * normal,
          tilted(normal, axis_x, axis_y, height)};
}

BasePatch fitted_patch(const SurfaceSample& origin, double ring, const SurfaceSamples& samples) {
  using Lanes = SurfaceSamples::Lanes;
  constexpr float slight = 0.9999F;  // cosine
  const auto whole = static_cast<float>(ring * ring);
  Vec3f normal = origin.up.isZero(0) ? Vec3f::UnitZ() : origin.up;
  for (int round = 0;; ++round) {
    const Vec3f axis_x = normal.unitOrthogonal(), axis_y = normal.cross(axis_x);
    QuadraticFit fit(ring);
    for (const SurfaceSamples::Block& block : samples.blocks()) {
      const SurfaceSamples::Vectors way = block.from(origin.position);
      const Lanes counts =
          (way.squared_length() <= whole && block.up.dot(origin.up) > same_side).cast<float>();
      if (counts.maxCoeff() > 0) fit.add(way.dot(axis_x), way.dot(axis_y), way.dot(normal), counts);
    }
    const QuadraticFit::Terms height = fit.solve();
    const Vec3f before = normal;
    normal = tilted(normal, axis_x, axis_y, height);
    if (round == 0 && normal.dot(before) < slight) continue;
    return {origin.position,
            normal,
            (axis_x - axis_x.dot(normal) * normal).normalized(),
            static_cast<float>(height[3]),
            static_cast<float>(height[4]),
            static_cast<float>(height[5])};
  }
}

}  // namespace burin
