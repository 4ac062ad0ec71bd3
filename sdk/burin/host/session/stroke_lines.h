#pragma once
#include <burin/refine/given_shape.h>
#include <burin/stroke/stroke_settings.h>
#include <burin/surface/picker.h>

#include <span>
#include <vector>

namespace burin {

/// What a stroke is drawn on.
struct StrokeGround {
  const Surface& surface;
  const Picker& picker;
  const GivenShape& given;
};

/// About the length of the edges into which a stroke refines a surface before it is drawn, object units.
double refined_edge(const StrokeSettings& settings);

/// How far from the curve triangles matter, object units.
double reach_of(const StrokeSettings& settings);

/// [vertex] The positions by which a stroke judges the lengths of edges.
std::span<const Vec3f> judged_positions(const StrokeGround& ground, const StrokeSettings& settings);

/// Where the stroke and its images go.
struct StrokeLines {
  std::vector<std::vector<Vec3d>> points;
  std::vector<Index> triangles;  ///< in which these lie
};

/// Those of the curve that a stroke through some places will have on the surface as it is. A line ends where
/// the next place is across a gap.
StrokeLines lines_through(const StrokeGround& ground, const StrokeSettings& settings,
                          std::span<const Vec3d> path);

}  // namespace burin
