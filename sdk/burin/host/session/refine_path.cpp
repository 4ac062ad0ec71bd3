// Asks for edges that suit a stroke within its radius of the curve that it will have.
#include <burin/base/error.h>
#include <burin/base/segment.h>
#include <burin/host/session/refine_path.h>
#include <burin/refine/displacement_error.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <numbers>
#include <utility>
#include <vector>

namespace burin {
namespace {

constexpr std::size_t most_triangles = 10'000'000;

/// About how many triangles get edges of this length within a distance of the lines.
double expected_triangles(const StrokeLines& lines, double reach, double edge) {
  // Measured: about 3.5 in the area of the square of an edge, with those of the transition.
  constexpr double triangles_per_square = 3.5;
  double length = 0;
  for (const std::vector<Vec3d>& line : lines.points)
    for (std::size_t i = 1; i < line.size(); ++i) length += (line[i] - line[i - 1]).norm();
  const double ends = std::numbers::pi * reach * static_cast<double>(lines.points.size());
  const double area = reach * (2 * length + ends);
  return triangles_per_square * area / (edge * edge);
}

bool is_automatic(const StrokeSettings& settings) {
  return settings.refining.kind == Refining::Kind::automatic;
}

/// The greatest gap between vertices that an automatic refinement leaves, object units.
double greatest_gap(const StrokeSettings& settings) { return settings.radius / Refining::coarse; }

/// Whether there may be anything to refine.
bool may_refine(const GivenShape& given, const StrokeSettings& settings) {
  return !is_automatic(settings) || may_refine_if_coarse(given, settings);
}

/// How coarse a surface is for a stroke, but for what was drawn on it.
enum class Coarseness {
  fine,     ///< as it was given
  refined,  ///< it was coarse, and refinements have ended that
  coarse    ///< vertices are too far from each other
};

/// Of the vertices within places, and of triangles. Those of an explicit length or error are always coarse.
template <class IsWithin>
Coarseness coarseness(const StrokeGround& ground, const StrokeSettings& settings,
                      std::span<const Index> triangles, NearVertices& near, const IsWithin& is_within) {
  if (!is_automatic(settings)) return Coarseness::coarse;
  bool was_refined = false;
  const bool has_gap = near.any(ground.surface, triangles, is_within, [&](Index vertex) {
    was_refined |= ground.given.is_refined(vertex);
    return static_cast<double>(ground.given.gap(vertex)) > greatest_gap(settings);
  });
  if (has_gap) return Coarseness::coarse;
  return was_refined ? Coarseness::refined : Coarseness::fine;
}

/// Whether such a vertex has an edge for which the surface is refined.
template <class IsWithin>
bool has_long_edge(const StrokeGround& ground, const StrokeSettings& settings,
                   std::span<const Index> triangles, NearVertices& near, const IsWithin& is_within) {
  const double longest = longest_edge_factor * refined_edge(settings);
  const std::span<const Vec3f> given = judged_positions(ground, settings);
  return near.any(ground.surface, triangles, is_within, [&](Index a) {
    return std::ranges::any_of(ground.surface.neighbours[a], [&](Index b) {
      return judged_squared(ground.surface.positions, given, a, b) > longest * longest;
    });
  });
}

PathRefinement with_edges(const Surface& surface, const EdgeLength& lengths, std::span<const Index> seeds,
                          std::span<const Vec3f> given = {}) {
  PathRefinement result{.is_coarse = true, .edge = lengths.edge()};
  SurfaceRefinement made = refine_surface(surface, lengths, seeds, most_triangles, given);
  if (!made.patch.triangles.empty()) result.made = std::move(made);
  return result;
}

/// The most triangles that a refinement comes to.
double most_of(const StrokeSettings& settings) {
  return is_automatic(settings) ? most_automatic : static_cast<double>(most_triangles);
}

PathRefinement refined(const StrokeGround& ground, const StrokeSettings& settings, const StrokeLines& lines,
                       double reach, std::size_t added) {
  const double edge = refined_edge(settings);
  const double expected = static_cast<double>(added) + expected_triangles(lines, reach, edge);
  if (!(expected <= most_of(settings))) {
    if (is_automatic(settings)) return {.declined = expected};
    throw Error(
        fmt::format("refining the surface to edges of {:g} would take about {:.2g} triangles, more "
                    "than {}",
                    edge, expected, most_triangles));
  }
  return with_edges(ground.surface, EdgeLength(lines.points, reach, edge), lines.triangles,
                    judged_positions(ground, settings));
}

/// Where a stroke will go, and how coarse the surface is for it there; `fine` also if there is nowhere.
struct Prospect {
  StrokeLines lines;
  Coarseness found = Coarseness::fine;
  bool is_refined() const { return found == Coarseness::coarse; }
};

/// Coarse only if there are edges to split.
Prospect prospect(const StrokeGround& ground, const StrokeSettings& settings, std::span<const Vec3d> path,
                  NearVertices& near) {
  Prospect made{lines_through(ground, settings, path)};
  if (made.lines.points.empty()) return made;
  const EdgeLength reached(made.lines.points, reach_of(settings), refined_edge(settings));
  const auto is_within = [&](const Vec3d& place) { return reached.at(place) <= reached.edge(); };
  made.found = coarseness(ground, settings, made.lines.triangles, near, is_within);
  if (made.is_refined() && !has_long_edge(ground, settings, made.lines.triangles, near, is_within))
    made.found = Coarseness::refined;
  return made;
}

/// Whether what refines a surface for one stroke may refine it for another.
bool refine_alike(const StrokeSettings& a, const StrokeSettings& b) {
  return a.refining.kind == b.refining.kind && refined_edge(a) == refined_edge(b) &&
         reach_of(a) == reach_of(b);
}

/// Appends the lines of later strokes for which the surface is to be refined too.
void append_later(const StrokeGround& ground, const StrokeSettings& settings,
                  const std::vector<PlannedStroke>& later, std::size_t added, NearVertices& near,
                  StrokeLines& lines) {
  const double reach = reach_of(settings), edge = refined_edge(settings);
  double expected = static_cast<double>(added) + expected_triangles(lines, reach, edge);
  for (const PlannedStroke& planned : later) {
    if (!refine_alike(settings, planned.settings)) continue;
    Prospect at = prospect(ground, planned.settings, planned.path, near);
    if (!at.is_refined()) continue;
    expected += expected_triangles(at.lines, reach, edge);
    if (!(expected <= most_of(settings))) return;
    std::ranges::move(at.lines.points, std::back_inserter(lines.points));
    std::ranges::copy(at.lines.triangles, std::back_inserter(lines.triangles));
  }
}

}  // namespace

bool may_refine_if_coarse(const GivenShape& given, const StrokeSettings& settings) {
  return is_automatic(settings) && static_cast<double>(given.greatest_gap()) > greatest_gap(settings);
}

PathRefinement refined_along(const StrokeGround& ground, const StrokeSettings& settings,
                             std::span<const Vec3d> path, const LaterStrokes& later, std::size_t added,
                             NearVertices& near) {
  if (path.empty() || !may_refine(ground.given, settings)) return {};
  Prospect at = prospect(ground, settings, path, near);
  if (!at.is_refined()) return {.is_coarse = at.found == Coarseness::refined};
  if (later) append_later(ground, settings, later(), added, near, at.lines);
  return refined(ground, settings, at.lines, reach_of(settings), added);
}

PathRefinement refined_at(const StrokeGround& ground, const StrokeSettings& settings, const PenStep& step,
                          std::size_t added, NearVertices& near) {
  if (!may_refine(ground.given, settings)) return {};
  // Ahead of the pen in radii; and how much wider than the stroke, so that it may bend.
  constexpr double least_ahead = 4, leeway = 1.75;
  const double length = step.length(), ahead = std::max(least_ahead * settings.radius, step.drawn / 2);
  const double reach = reach_of(settings);
  StrokeLines lines;
  bool is_coarse = false;
  for (const SymmetryInstance& image : symmetry_instances(settings.symmetry)) {
    const Vec3d from = image(step.from), to = image(step.to);
    const auto at = ground.picker.closest(to.cast<float>(), static_cast<float>(settings.radius));
    const auto is_within = [&](const Vec3d& place) {
      const double share = share_on_segment(from, to, place);
      return (place - from - share * (to - from)).squaredNorm() <= reach * reach;
    };
    if (!at) continue;
    const std::array triangle{at->triangle};
    const Coarseness found = coarseness(ground, settings, triangle, near, is_within);
    is_coarse |= found != Coarseness::fine;
    if (found != Coarseness::coarse || !has_long_edge(ground, settings, triangle, near, is_within)) continue;
    lines.points.push_back({from, to});
    if (length > 0) lines.points.back().push_back(to + ahead / length * (to - from));
    lines.triangles.push_back(at->triangle);
  }
  if (lines.points.empty()) return {.is_coarse = is_coarse};
  return refined(ground, settings, lines, leeway * reach, added);
}

PathRefinement refined_to_error(const Surface& surface, const StrokeSettings& settings,
                                std::span<const Vec3f> displaced, std::span<const Index> vertices) {
  const DisplacementBound bound{.share = settings.refining.error,
                                .least_edge = settings.radius / Refining::finest};
  DisplacementError found = displacement_error(surface, displaced, vertices, bound);
  if (found.empty()) return {};
  PathRefinement result = with_edges(surface, EdgeLength(std::move(found.lengths)), found.triangles);
  if (result.made)
    for (float& edge : result.made->edges) edge = std::max(edge, static_cast<float>(refined_edge(settings)));
  return result;
}

}  // namespace burin
