#pragma once
#include <burin/feature/chart_grid.h>
#include <burin/feature/feature.h>
#include <burin/feature/smoothed_image.h>

#include <optional>
#include <vector>

namespace burin {

/// Channels of an image of the surface's geometry: smoothed positions, then smoothed normals.
inline constexpr std::size_t geometry_channels = 6;

/// The geometry of samples, to be smoothed, with one of their normals.
std::vector<float> geometry_of(const ChartSamples& samples, Vec3f ChartSample::*normal);

/// The greatest principal curvature of the smoothed surface, 1 / length, convex positive; with `sign` -1 the
/// greatest of the opposite surface, which is that of valleys. It is the greatest eigenvalue of the
/// Weingarten map dn = S dP, with both differentials taken from the smoothed image, so that the chart's
/// stretch cancels out. Its crests lie in the middle of symmetric bumps along curves on planes and spheres,
/// whatever the geodesic curvature of the curve; those of the mean curvature are w^2 k / 3 off for Gaussian
/// bumps of width w along curves of geodesic curvature k.
LevelImage curvature_image(const SmoothedImage& geometry, float sign);

/// The cosine of the angle between the smoothed normal and the direction to the viewer.
LevelImage facing_image(const SmoothedImage& geometry, const Vec3f& origin, const Viewpoint& view);

/// The radial curvature of the smoothed surface, 1 / length, convex positive: its normal curvature in the
/// direction w of the view's projection onto the tangent plane [DeCarlo et al. 2003, Suggestive Contours for
/// Conveying Shape]. Only near suggestive contours, where it rises towards the viewer; else it is NaN.
LevelImage radial_image(const SmoothedImage& geometry, const Vec3f& origin, const Viewpoint& view);

/// The direction w in the image at a pixel, columns and rows per object unit; nothing where it is not known.
std::optional<Vec2f> radial_direction(const SmoothedImage& geometry, const Vec3f& origin,
                                      const Viewpoint& view, int column, int row);

/// The first channel times `sign`.
LevelImage channel_image(const SmoothedImage& image, float sign);

/// The vector from a position to an eye, or a unit vector against a direction of sight.
Vec3d way_to_viewer(const Viewpoint& view, const Vec3f& position);

/// The unit vector from a position to the viewer.
Vec3f to_viewer(const Viewpoint& view, const Vec3f& position);

}  // namespace burin
