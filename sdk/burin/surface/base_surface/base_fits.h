#pragma once
#include <burin/base/vector.h>
#include <burin/surface/base_surface/base_patch.h>
#include <burin/surface/base_surface/surface_samples.h>

namespace burin {

/// Nodes of a base surface whose normals have a lower cosine than this do not belong to one patch.
inline constexpr float same_side = 0.2F;

/// The unit direction of the summed area vectors within half the reach, object units; zero if they cancel
/// out.
Vec3f normal_around(const Vec3f& origin, double reach, const SurfaceSamples& samples);

/// Moves a point along its `up` onto the quadratic that best fits the samples within the reach; the result's
/// `up` is the normal there. A point whose `up` is zero stays as it is.
SurfaceSample smoothed(const SurfaceSample& origin, double reach, const SurfaceSamples& samples);

/// Fits the paraboloid over the tangent plane at a node to the samples within `ring`, object units. If the
/// fitted normal differs noticeably, the fit is repeated once over the new tangent plane.
BasePatch fitted_patch(const SurfaceSample& origin, double ring, const SurfaceSamples& samples);

}  // namespace burin
