#include <burin/base/stopwatch.h>
#include <burin/host/session/merged_surface.h>
#include <burin/host/session/stroke_refining.h>
#include <fmt/format.h>

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

void StrokeRefining::begin(const BrushEntry* entry, const StrokeSettings& settings, std::size_t added) {
  given_.emplace(entry, settings);
  added_before_ = settings.refining.kind == Refining::Kind::automatic ? added : 0;
}

std::size_t StrokeRefining::added() const { return added_before_ + (report_ ? report_->triangles_added : 0); }

PathRefinement StrokeRefining::along(SculptedSurface& surface, std::span<const Vec3d> path,
                                     const LaterStrokes& later) {
  if (may_refine_if_coarse(surface.given(), given_->settings)) surface.keep_given_positions();
  return timed([&] { return refined_along(ground(surface), given_->settings, path, later, added(), near_); });
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
  const auto& [patch, given] = *refinement.made;
  Stopwatch watch;
  surface.refine(with_patch(surface.base(), surface.picker(), surface.paint().base(), patch), given);
  if (!report_) report_.emplace();
  report_->edge = refinement.edge;
  report_->triangles_removed += patch.removed.size();
  report_->triangles_added += patch.triangles.size();
  report_->vertices_added += patch.positions.size();
  report_->split_seconds += refinement.seconds;
  report_->rebuild_seconds += watch.lap();
}

std::optional<RefineReport> StrokeRefining::take_report() { return std::exchange(report_, std::nullopt); }

}  // namespace burin
