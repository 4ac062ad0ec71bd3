#include <burin/base/stopwatch.h>
#include <burin/host/session/merged_surface.h>
#include <burin/host/session/stroke_refining.h>
#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace burin {
namespace {

StrokeGround ground(const SculptedSurface& surface) {
  return {surface.base(), surface.picker(), surface.given()};
}

/// What `make` returns, with the seconds that it took.
template <class Make>
PathRefinement timed(const Make& make) {
  Stopwatch watch;
  PathRefinement made = make();
  made.seconds = watch.lap();
  return made;
}

}  // namespace

void StrokeRefining::begin(const BrushEntry* entry, const StrokeSettings& settings, std::size_t added,
                           LaterStrokes later) {
  given_.emplace(entry, settings);
  later_ = std::move(later);
  added_before_ = settings.refining.kind == Refining::Kind::automatic ? added : 0;
}

std::size_t StrokeRefining::added() const { return added_before_ + (report_ ? report_->triangles_added : 0); }

PathRefinement StrokeRefining::along(SculptedSurface& surface, std::span<const Vec3d> path) {
  if (may_refine_if_coarse(surface.given(), given_->settings)) surface.keep_given_positions();
  return timed(
      [&] { return refined_along(ground(surface), given_->settings, path, later_, added(), near_); });
}

PathRefinement StrokeRefining::at(const SculptedSurface& surface, const Vec3d& place) {
  return timed(
      [&] { return refined_at(ground(surface), given_->settings, given_->step_to(place), added(), near_); });
}

PathRefinement StrokeRefining::to_error(SculptedSurface& surface) {
  if (given_->settings.refining.kind != Refining::Kind::error) return {};
  return timed([&] {
    return refined_to_error(surface.base(), given_->settings, surface.shown().positions(),
                            surface.displaced());
  });
}

std::string StrokeRefining::declined(const PathRefinement& refinement) {
  if (refinement.declined == 0) return {};
  const double radius = given_->settings.radius;
  given_.reset();
  return fmt::format(
      "a stroke of radius {:.3g} is drawn on the triangles that are there: to refine them would take about "
      "{:.2g}, more than {:.0f}",
      radius, refinement.declined, most_automatic);
}

bool StrokeRefining::changes(const PathRefinement& refinement) const {
  return refinement.made || (refinement.is_coarse && !given_->on_fine);
}

void StrokeRefining::apply(const PathRefinement& refinement, SculptedSurface& surface) {
  given_->on_fine = true;
  if (!refinement.made) return surface.drop();
  const auto& [patch, given, edges] = *refinement.made;
  Stopwatch watch;
  surface.refine(with_patch(surface.base(), surface.picker(), surface.paint().base(), patch), {given, edges});
  if (!report_) report_.emplace();
  report_->edge = refinement.edge;
  report_->triangles_removed += patch.removed.size();
  report_->triangles_added += patch.triangles.size();
  report_->vertices_added += patch.positions.size();
  report_->split_seconds += refinement.seconds;
  report_->rebuild_seconds += watch.lap();
}

PathCoarsening StrokeRefining::coarser(SculptedSurface& surface) {
  if (!is_on() || surface.hides() || given_->settings.along.given()) return {};
  std::vector<std::vector<Vec3d>> pieces;
  for (const GivenSamples::Piece& piece : given_->pieces) pieces.push_back(piece.places);
  const std::vector<Index> displaced = surface.displaced();
  const DrawnStroke stroke{pieces, surface.shown().positions(), displaced, surface.paint().shown()};
  Stopwatch watch;
  PathCoarsening made = coarsened_along(ground(surface), given_->settings, stroke, later_, near_);
  made.seconds = watch.lap();
  return made;
}

void StrokeRefining::keep(MadePart made, PathCoarsening coarser, SculptedSurface& surface) {
  const SurfacePatch& patch = coarser.patch;
  if (patch.removed.empty()) return surface.keep(made, std::move(coarser.kept));
  if (!report_) report_.emplace();
  report_->edge = std::max(report_->edge, refined_edge(given_->settings));
  report_->triangles_removed += patch.removed.size();
  report_->triangles_added += patch.triangles.size();
  report_->collapse_seconds = coarser.seconds;
  const Index before = surface.base().vertex_count();
  Stopwatch watch;
  surface.keep_coarser(made, std::move(coarser));
  report_->vertices_removed = before - surface.base().vertex_count();
  report_->rebuild_seconds += watch.lap();
}

std::optional<RefineReport> StrokeRefining::take_report() { return std::exchange(report_, std::nullopt); }

}  // namespace burin
