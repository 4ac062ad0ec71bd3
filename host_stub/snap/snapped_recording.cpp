// Snaps recorded strokes, or follows lines, and says what became of them.
#include "snap/snapped_recording.h"

#include <burin/base/error.h>
#include <burin/stroke/curve/stroke_trace.h>
#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace burin::command {
namespace {

Json snapped_json(const SurfaceCurve& stroke, const SnapResult& result) {
  Json ranges = Json::array();
  for (const SnapRange& range : result.ranges)
    ranges.push_back({{"from", range.from}, {"to", range.to}, {"significance", range.significance}});
  return {{"length", stroke.length()},
          {"points", result.curve.points.size()},
          {"significance", result.significance},
          {"snapped_share", result.snapped_share},
          {"snapped", ranges},
          {"mean_move", result.mean_move},
          {"scale", result.scale},
          {"iterations", result.iterations}};
}

std::string snapped_text(const SurfaceCurve& stroke, const SnapResult& result) {
  if (result.ranges.empty())
    return fmt::format("stays, nothing stands out (significance {:.3g})", result.significance);
  std::string parts;
  for (const SnapRange& range : result.ranges)
    parts += fmt::format("{}{:.4g} to {:.4g}", parts.empty() ? "" : ", ", range.from, range.to);
  return fmt::format("snapped from {} of {:.4g}, moved by {:.3g} in the mean, significance {:.3g}", parts,
                     stroke.length(), result.mean_move, result.significance);
}

const char* name_of(LossKind kind) {
  switch (kind) {
    case LossKind::ended:
      return "ended";
    case LossKind::split:
      return "split";
    case LossKind::jumped:
      return "jumped";
  }
  throw ContractError("no such loss");
}

Json followed_json(const SurfaceCurve& before, const TrackStep& step) {
  Json followed = Json::array(), lost = Json::array();
  for (const TrackedLine& line : step.lines)
    followed.push_back({{"from", line.start_t.front()},
                        {"to", line.start_t.back()},
                        {"length", line.curve.length()},
                        {"closed", line.curve.closed}});
  for (const Loss& loss : step.losses)
    lost.push_back({{"why", name_of(loss.kind)}, {"from", loss.from}, {"to", loss.to}});
  return {{"length", before.length()},
          {"followed", followed},
          {"lost", lost},
          {"most_moved", step.most_moved},
          {"scale", step.snapped.scale}};
}

std::string followed_text(const SurfaceCurve& before, const TrackStep& step) {
  std::string text = step.lines.empty()
                         ? "not followed"
                         : fmt::format("followed in {} part{}, moved by at most {:.3g}", step.lines.size(),
                                       step.lines.size() > 1 ? "s" : "", step.most_moved);
  for (const Loss& loss : step.losses)
    text += fmt::format("; {} from {:.4g} to {:.4g} of {:.4g}", name_of(loss.kind), loss.from, loss.to,
                        before.length());
  return text;
}

/// A stroke like another one, without samples. Those of a moved curve do not tell of the pen's buttons.
RecordedStroke like(const RecordedStroke& stroke) {
  RecordedStroke made{stroke.settings, stroke.fields, {}};
  made.fields.barrel = false;
  made.drawn_by = stroke.drawn_by;
  return made;
}

}  // namespace

SnappedRecording::SnappedRecording(const SnapJob& job, const LoadedSurface& loaded, const Picker& picker,
                                   const Feature& feature)
    : job_(job),
      loaded_(loaded),
      picker_(picker),
      feature_(feature),
      snapper_(loaded.surface, picker),
      tracker_(loaded.surface, picker) {}

void SnappedRecording::add(const Recording& recording, std::size_t number) {
  const RecordedStroke& stroke = recording.strokes[number];
  const ReplaySettings settings = settings_to_trace(job_.strokes, stroke, number, job_.settings);
  const CurveGround ground(loaded_.surface, picker_);
  const auto pieces = trace_stroke(ground, recording, stroke, trace_options(settings, stroke.fields, number));
  if (pieces.empty())
    throw FileError(job_.strokes, fmt::format("stroke {} does not meet the surface", number + 1));
  radius_ = std::max(radius_, settings.radius);
  number_ = number + 1;
  SnapOptions how = job_.snap;
  how.radius = settings.radius;
  for (const SurfaceCurve& piece : pieces) {
    if (job_.most_edges)
      follow(piece, {how, *job_.most_edges}, stroke);
    else
      snap(piece, how, stroke);
  }
}

void SnappedRecording::snap(const SurfaceCurve& piece, const SnapOptions& how, const RecordedStroke& stroke) {
  SnapResult result = snapper_.snap(piece, feature_, how);
  write(stroke, result.curve);
  say(snapped_json(piece, result), snapped_text(piece, result));
  snapped_.push_back({piece, {std::move(result.curve)}, std::move(result.images)});
}

void SnappedRecording::follow(const SurfaceCurve& piece, const TrackOptions& how,
                              const RecordedStroke& stroke) {
  TrackStep step = tracker_.follow(tracked(piece), feature_, how);
  say(followed_json(piece, step), followed_text(piece, step));
  snapped_.push_back({piece, {}, std::move(step.snapped.images)});
  for (TrackedLine& line : step.lines) {
    RecordedStroke part = like(stroke);
    if (piece.closed && !line.curve.closed) part.settings[&ReplaySettings::closure] = Closure::open;
    write(part, line.curve);
    snapped_.back().moved.push_back(std::move(line.curve));
  }
}

void SnappedRecording::write(const RecordedStroke& stroke, const SurfaceCurve& curve) {
  RecordedStroke result = like(stroke);
  for (const CurvePoint& point : curve.points) {
    const Vec3d position = point.at.position.cast<double>() + loaded_.from.origin;
    result.samples.push_back({point.time, position, point.pen});
  }
  recording_.strokes.push_back(std::move(result));
}

void SnappedRecording::say(const Json& json, const std::string& text) {
  json_.push_back({{"stroke", number_}});
  json_.back().update(json);
  text_ += fmt::format("stroke {}: {}\n", number_, text);
}

}  // namespace burin::command
