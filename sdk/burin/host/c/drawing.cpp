#include <burin/host/c/drawing.h>
#include <burin/host/stroke_pieces.h>

#include <utility>
#include <vector>

namespace burin::c {
namespace {

/// The places at which samples point.
std::vector<Vec3d> places_of(std::span<const PenSample> samples, const Picker& picker) {
  std::vector<Vec3d> places;
  for (const PenSample& given : samples) {
    if (!given.is_ray())
      places.push_back(given.sample.position);
    else if (const auto at = picker.pick(given.ray()))
      places.push_back(at->position.cast<double>());
  }
  return places;
}

}  // namespace

void begin_stroke(burin_session& session, const ReplaySettings& settings, std::span<const PenSample> path,
                  std::optional<PenInput> pen) {
  const std::vector<Vec3d> places = places_of(path, session.session.picker());
  noted(session, [&](Session& to) {
    to.begin_stroke(settings, places);
    return true;
  });
  session.stroke = OpenStroke{settings.closure, std::move(pen)};
}

StrokeEvent::Outcome draw(burin_session& session, const PenSample& given, Show show) {
  const Sample& sample = given.sample;
  const auto add = [&] {
    return noted(session, [&](Session& to) {
      if (given.is_ray()) return to.add_sample(given.ray(), sample.time, sample.pen, show).outcome;
      return to.add_sample(sample.position, sample.time, sample.pen, show).outcome;
    });
  };
  const StrokeEvent::Outcome outcome =
      add_in_pieces(session.stroke->piece_begun, add, [&] { end_piece(session); });
  session.stroke->piece_begun |= outcome == StrokeEvent::Outcome::drawn;
  return outcome;
}

Closure closure_of_last_piece(const OpenStroke& stroke) {
  return stroke.whole ? stroke.closure : closure_of_piece(stroke.closure);
}

void end_piece(burin_session& session) {
  OpenStroke& stroke = *session.stroke;
  if (!stroke.piece_begun) return;
  noted(session, [&](Session& to) { return to.end_piece(closure_of_piece(stroke.closure)).size(); });
  stroke.piece_begun = stroke.whole = false;
}

void end_stroke(burin_session& session) {
  const Closure closure = closure_of_last_piece(*session.stroke);
  noted(session, [&](Session& to) { return to.end_stroke(closure).size(); });
  session.stroke.reset();
}

void cancel_stroke(burin_session& session) {
  session.session.cancel_stroke();
  session.note_changed();
  session.stroke.reset();
}

}  // namespace burin::c
