#include <burin/host/c/drawing.h>
#include <burin/host/stroke_pieces.h>

namespace burin::c {

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
