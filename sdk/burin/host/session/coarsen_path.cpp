// Asks which vertices that finer strokes added may go, along the curve of a stroke that has ended.
#include <burin/host/session/coarsen_path.h>
#include <burin/refine/coarsen_surface.h>
#include <burin/refine/edge_length.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace burin {
namespace {

/// The greatest length for which vertices were added that a stroke does not need, object units.
double finest_needed(const StrokeSettings& settings) {
  // Lengths of vertices are rounded to floats.
  constexpr double rounding = 1 + 1e-6;
  return refined_edge(settings) / coarsen_factor * rounding;
}

StrokeLines lines_of(const StrokeGround& ground, const StrokeSettings& settings, const DrawnStroke& stroke) {
  StrokeLines all;
  for (const std::vector<Vec3d>& piece : stroke.pieces) {
    StrokeLines lines = lines_through(ground, settings, piece);
    std::ranges::move(lines.points, std::back_inserter(all.points));
    std::ranges::copy(lines.triangles, std::back_inserter(all.triangles));
  }
  return all;
}

/// Vertices within the reach of lines that the stroke does not need, ascending.
std::vector<Index> finer_within(const StrokeGround& ground, const StrokeSettings& settings,
                                const StrokeLines& lines, NearVertices& near) {
  std::vector<Index> found;
  if (lines.points.empty()) return found;
  const EdgeLength lengths(lines.points, reach_of(settings), refined_edge(settings));
  const auto is_within = [&](const Vec3d& place) { return lengths.at(place) <= lengths.edge(); };
  const double finest = finest_needed(settings);
  near.any(ground.surface, lines.triangles, is_within, [&](Index vertex) {
    if (ground.given.is_finer(vertex, finest) && is_within(ground.surface.positions[vertex].cast<double>()))
      found.push_back(vertex);
    return false;
  });
  std::ranges::sort(found);
  return found;
}

/// Leaves out what later strokes need.
void keep_for_later(const StrokeGround& ground, const StrokeSettings& settings,
                    const std::vector<PlannedStroke>& later, std::vector<Index>& vertices) {
  for (const PlannedStroke& planned : later) {
    const double edge = refined_edge(planned.settings);
    if (planned.settings.refining.kind == Refining::Kind::off || !(edge < refined_edge(settings))) continue;
    const StrokeLines lines = lines_through(ground, planned.settings, planned.path);
    if (lines.points.empty()) continue;
    const EdgeLength lengths(lines.points, reach_of(planned.settings), edge);
    std::erase_if(vertices, [&](Index vertex) {
      return lengths.at(ground.surface.positions[vertex].cast<double>()) <= edge;
    });
  }
}

/// How far the surface may be off without vertices, object units.
double most_apart(const Surface& surface, const StrokeSettings& settings, const DrawnStroke& stroke) {
  constexpr double share_of_edge = 0.01, share_of_error = 0.25;
  const double by_edge = share_of_edge * refined_edge(settings);
  float squared = 0;
  for (const Index vertex : stroke.displaced)
    squared = std::max(squared, (stroke.positions[vertex] - surface.positions[vertex]).squaredNorm());
  if (settings.refining.kind != Refining::Kind::error || squared == 0) return by_edge;
  const double amplitude = std::sqrt(static_cast<double>(squared));
  return std::min(by_edge, share_of_error * settings.refining.error * amplitude);
}

/// Whether colours and masks are about those of the corners, to what pictures of 8 bits tell apart.
IsLikeCorners is_like_corners(const Paint& paint) {
  if (paint.colour.empty() && paint.mask.empty()) return {};
  return [&paint](Index vertex, const Triangle& corners, const std::array<double, 3>& weights) {
    constexpr float level = 1.F / 255;
    Vec4f colour = Vec4f::Zero();
    float mask = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      colour += static_cast<float>(weights[i]) * paint.colour_of(corners[i]);
      mask += static_cast<float>(weights[i]) * paint.mask_of(corners[i]);
    }
    return (colour - paint.colour_of(vertex)).cwiseAbs().maxCoeff() <= level &&
           std::abs(mask - paint.mask_of(vertex)) <= level;
  };
}

}  // namespace

PathCoarsening coarsened_along(const StrokeGround& ground, const StrokeSettings& settings,
                               const DrawnStroke& stroke, const LaterStrokes& later, NearVertices& near) {
  PathCoarsening made;
  if (static_cast<double>(ground.given.least_edge()) > finest_needed(settings)) return made;
  std::vector<Index> vertices = finer_within(ground, settings, lines_of(ground, settings, stroke), near);
  if (!vertices.empty() && later) keep_for_later(ground, settings, later(), vertices);
  if (vertices.empty()) return made;
  made.drawn = ground.surface;
  made.drawn.positions.assign(stroke.positions.begin(), stroke.positions.end());
  const CoarsenBounds bounds{.edge = refined_edge(settings),
                             .apart = most_apart(ground.surface, settings, stroke),
                             .is_like = is_like_corners(stroke.paint)};
  // As the next stroke will judge them.
  const std::span<const Vec3f> given = judged_positions({made.drawn, ground.picker, ground.given}, settings);
  made.patch = coarsen_surface(made.drawn, vertices, bounds, given);
  made.kept.edges.assign(vertices.size(), static_cast<float>(bounds.edge));
  made.kept.vertices = std::move(vertices);
  return made;
}

}  // namespace burin
