// Draws the pictures of a replay. Strokes are undone to show the surface without them, plain and with their
// charts.
#include "replay/replay_pictures.h"

#include <algorithm>
#include <cmath>

#include "pictures/curve_overlay.h"
#include "pictures/painted.h"
#include "pictures/render.h"

namespace burin {
namespace {

double widest_in(const Chart& chart) {
  double widest = 0;
  for (const float d : chart.d) widest = std::max(widest, std::abs(static_cast<double>(d)));
  return widest;
}

}  // namespace

void StrokeExtent::piece_ended(const Session& session) {
  widest_ = std::max(widest_, widest_in(session.chart()));
  curves_.push_back(session.curve());
}

void StrokeRecorder::piece_ended(const Session& session) {
  const double widest = widest_in(session.chart());
  if (widest > 0) {
    // Vertices have other numbers than those of charts on the surface before.
    if (!checkerboard_ || generation_ != session.generation()) checkerboard_.emplace(session.surface());
    generation_ = session.generation();
    checkerboard_->add(session.chart(), widest);
  }
  extent_.piece_ended(session);
}

Vec3f StrokeRecorder::colour(const SurfacePoint& point) const {
  return checkerboard_ ? (*checkerboard_)(point) : clay(point);
}

Camera replay_view(const Surface& surface, const StrokeExtent& extent,
                   const std::vector<Recording>& recordings, const ViewOptions& options) {
  return recorded_view(recordings, surface, extent.curves(), extent.widest(), options);
}

ReplayPictures draw_replay(Session& session, const StrokeRecorder& recorder, const Camera& camera,
                           const Progress& progress) {
  ReplayPictures pictures;
  const Albedo checkers = [&](const SurfacePoint& point) { return recorder.colour(point); };
  const auto draw_chart = [&](const Albedo& albedo) {
    pictures.chart = render(session.surface(), session.picker(), camera, albedo, progress);
  };
  const bool refined = recorder.generation() != 0, is_there = recorder.generation() == session.generation();
  if (refined && is_there) draw_chart(checkers);
  while (session.undo()) {
  }
  pictures.before = render(session.surface(), session.picker(), camera, painted(session.paint()), progress);
  if (!refined) draw_chart(checkers);
  if (refined && !is_there) draw_chart(clay);
  // Later strokes run on the surface that earlier ones moved, which may lie below the surface in the picture.
  for (const SurfaceCurve& curve : recorder.extent().curves()) {
    draw_curve(pictures.chart, camera, session.picker(), curve, recorder.extent().widest());
  }
  return pictures;
}

}  // namespace burin
