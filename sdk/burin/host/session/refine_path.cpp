// Traces the curve that a stroke through some places will have, on the surface as it is, and asks for edges
// that suit the stroke within its radius of that.
#include <burin/along/along_parts.h>
#include <burin/base/error.h>
#include <burin/host/session/refine_path.h>
#include <burin/stroke/curve/surface_curve.h>
#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace burin {

double refined_edge(const StrokeSettings& settings) {
  const Refining& refining = settings.refining;
  return refining.kind == Refining::Kind::edge ? refining.edge : settings.radius / Refining::fine;
}

namespace {

constexpr std::size_t most_triangles = 10'000'000;

/// Where the stroke and its images go.
struct Lines {
  std::vector<std::vector<Vec3d>> points;
  std::vector<Index> triangles;  ///< in which these lie
};

void append(const SurfaceCurve& curve, const Picker& picker, const SymmetryInstance& image, double radius,
            Lines& lines) {
  std::vector<Vec3d> line;
  for (const CurvePoint& point : curve.points) {
    const Vec3d there = image(point.at.position.cast<double>());
    const auto at = picker.closest(there.cast<float>(), static_cast<float>(radius));
    if (!at) continue;
    line.push_back(there);
    lines.triangles.push_back(at->triangle);
  }
  if (!line.empty()) lines.points.push_back(std::move(line));
}

/// A line ends where the next place is across a gap.
Lines lines_through(std::span<const Vec3d> path, const Surface& surface, const Picker& picker,
                    const StrokeSettings& settings) {
  std::vector<SurfaceCurve> curves;
  std::optional<CurveTracer> tracer;
  double time = 0;
  for (const Vec3d& place : path) {
    const auto at = picker.closest(place.cast<float>(), static_cast<float>(settings.radius));
    if (tracer && !(at && tracer->connects(*at))) {
      curves.push_back(tracer->curve());
      tracer.reset();
    }
    if (!at) continue;
    if (!tracer) tracer.emplace(surface, picker, settings.radius);
    tracer->add(*at, time++, {});
  }
  if (tracer) curves.push_back(tracer->curve());
  Lines lines;
  for (const SymmetryInstance& image : symmetry_instances(settings.symmetry))
    for (const SurfaceCurve& curve : curves) append(curve, picker, image, settings.radius, lines);
  return lines;
}

/// About how many triangles the region gets.
double expected_triangles(const EdgeLength& lengths) {
  // Measured: about 3.5 in the area of the square of an edge, with those of the transition.
  constexpr double triangles_per_square = 3.5;
  return triangles_per_square * lengths.area() / (lengths.edge() * lengths.edge());
}

/// How far from the curve triangles matter, object units.
double reach_of(const StrokeSettings& settings) {
  const double wide = settings.along.given() ? AlongParts::chart_radii : 1;
  return wide * settings.radius + refined_edge(settings);
}

/// Edges that are not longer are left alone, object units.
double longest_left(const StrokeSettings& settings) {
  return settings.refining.kind == Refining::Kind::edge ? longest_edge_factor * settings.refining.edge
                                                        : settings.radius / Refining::coarse;
}

PathRefinement refined(const Surface& surface, const StrokeSettings& settings, const Lines& lines,
                       double reach, std::size_t added) {
  const EdgeLength lengths(lines.points, reach, refined_edge(settings));
  const double expected = static_cast<double>(added) + expected_triangles(lengths);
  if (settings.refining.kind == Refining::Kind::automatic) {
    if (!(expected <= most_automatic)) return {{}, expected};
  } else if (!(expected <= static_cast<double>(most_triangles))) {
    throw Error(
        fmt::format("refining the surface to edges of {:g} would take about {:.2g} triangles, more "
                    "than {}",
                    lengths.edge(), expected, most_triangles));
  }
  SurfacePatch made = refine_surface(surface, lengths, lines.triangles, most_triangles);
  if (made.triangles.empty()) return {};
  return {std::move(made)};
}

}  // namespace

PathRefinement refined_along(const Surface& surface, const Picker& picker, const StrokeSettings& settings,
                             std::span<const Vec3d> path) {
  if (settings.refining.kind == Refining::Kind::off || path.empty()) return {};
  const Lines lines = lines_through(path, surface, picker, settings);
  if (lines.points.empty()) return {};
  if (settings.refining.kind == Refining::Kind::automatic) {
    const EdgeLength enough(lines.points, reach_of(settings), longest_left(settings) / longest_edge_factor);
    if (!has_longer_edges(surface, enough, lines.triangles)) return {};
  }
  return refined(surface, settings, lines, reach_of(settings), 0);
}

PathRefinement refined_at(const Surface& surface, const Picker& picker, const StrokeSettings& settings,
                          const PenStep& step, std::size_t added, CoarseEdges& coarse) {
  // Ahead of the pen in radii; and how much wider than the stroke, so that it may bend.
  constexpr double least_ahead = 4, leeway = 1.75;
  const double length = step.length(), ahead = std::max(least_ahead * settings.radius, step.drawn / 2);
  Lines lines;
  for (const SymmetryInstance& image : symmetry_instances(settings.symmetry)) {
    const Vec3d from = image(step.from), to = image(step.to);
    const auto at = picker.closest(to.cast<float>(), static_cast<float>(settings.radius));
    if (!at || !coarse.are_near(surface, at->triangle, from, to, reach_of(settings), longest_left(settings)))
      continue;
    lines.points.push_back({from, to});
    if (length > 0) lines.points.back().push_back(to + ahead / length * (to - from));
    lines.triangles.push_back(at->triangle);
  }
  if (lines.points.empty()) return {};
  return refined(surface, settings, lines, leeway * reach_of(settings), added);
}

}  // namespace burin
