#pragma once
#include <burin/host/c/call.h>
#include <burin/host/c/handles.h>
#include <burin/host/c/pen_input.h>

#include <optional>
#include <span>

namespace burin::c {

/// Runs a call of the session, and notes what it changed, also if it throws. Then the stroke is gone.
template <class Call>
auto noted(burin_session& session, const Call& call) {
  try {
    const auto result = call(session.session);
    session.note_changed();
    return result;
  } catch (...) {
    session.note_changed();
    session.stroke.reset();
    throw;
  }
}

/// Begins a stroke that will have these samples on the session's surface. `pen`: none for that of a group.
void begin_stroke(burin_session& session, const ReplaySettings& settings, std::span<const PenSample> path,
                  std::optional<PenInput> pen);

/// Draws a sample with the session's open stroke, which begins another piece where it must.
StrokeEvent::Outcome draw(burin_session& session, const PenSample& given, Show show);

/// How the last piece of a stroke is closed.
Closure closure_of_last_piece(const OpenStroke& stroke);

/// Ends the current piece of the open stroke, if it has begun.
void end_piece(burin_session& session);

/// Ends the open stroke.
void end_stroke(burin_session& session);

/// Drops the open stroke, if there is one.
void cancel_stroke(burin_session& session);

}  // namespace burin::c
