// Strokes of one session for C.
#include <burin/host/c/drawing.h>
#include <burin/host/c/stroke_texts.h>
#include <burin/host/c/whole_recording.h>
#include <burin/host/replay.h>

#include <string>
#include <string_view>
#include <vector>

namespace burin::c {
namespace {

void require_stroke(const burin_session* session, bool open) {
  if (session->stroke && !open) reject("a stroke is open");
  if (!session->stroke && open) reject("no stroke is open");
  if (open && !session->stroke->pen) reject("the stroke is one of a group");
}

/// Draws samples, of which the last brings the surface up to date.
burin_event add_all(burin_session& session, const std::vector<PenSample>& samples) {
  burin_event event{};
  for (const PenSample& given : samples) {
    const StrokeEvent::Outcome outcome =
        draw(session, session.stroke->pen->take(given), &given == &samples.back() ? Show::now : Show::later);
    const bool drawn = outcome == StrokeEvent::Outcome::drawn;
    event.outcome = drawn ? BURIN_OUTCOME_DRAWN : BURIN_OUTCOME_OFF_SURFACE;
    event.drawn += drawn;
  }
  return event;
}

/// Undoes or makes again.
void take(burin_session* session, bool (Session::*one)(), const char* none) {
  require_stroke(session, false);
  const bool taken = noted(*session, [&](Session& to) { return (to.*one)(); });
  if (!taken) throw plugin::Error(none, BURIN_NOT_FOUND);
}

void replay_file(burin_session& session, const char* path, const char* const* settings) {
  const GivenSettings overrides = read_texts(settings, *session.brushes, session.told.has_value());
  const Recording recording = read_whole_recording(path);
  ReplayObserver observer;
  observer.progress = session.progress;
  observer.changed = [&](const Session&) { session.note_changed(); };
  const auto end = [&] {
    // One that its progress cancelled is still open.
    session.session.cancel_stroke();
    session.note_changed();
    session.session.set_progress(session.progress);
  };
  try {
    replay(session.session, recording, overrides, observer);
  } catch (...) {
    end();
    throw;
  }
  end();
}

/// Passes progress on to a function of C.
Progress progress_of(burin_progress_function progress, void* user) {
  if (!progress) return {};
  return [progress, user](std::string_view stage, double done) {
    if (progress(user, std::string(stage).c_str(), done) != 0) throw Error("cancelled");
  };
}

}  // namespace
}  // namespace burin::c

using namespace burin;

burin_status burin_session_begin(burin_session* session, const burin_stroke* stroke, burin_text* error) {
  return c::in_session(session, error, [&] {
    c::require_stroke(session, false);
    const ReplaySettings settings = c::stroke_settings(stroke, *session->brushes, session->told.has_value());
    c::begin_stroke(*session, settings, c::path_of(*stroke, settings), c::PenInput(settings));
  });
}

burin_status burin_session_add(burin_session* session, const burin_sample* samples, uint64_t count,
                               burin_event* event, burin_text* error) {
  return c::in_session(session, error, [&] {
    c::require_stroke(session, true);
    const bool has_first = !event || BURIN_HAS(event, burin_event, drawn);
    if (!has_first) c::reject("event is too small");
    const burin_event happened = c::add_all(*session, session->stroke->pen->read(samples, count));
    if (event) c::give(happened, event, has_first, "event");
  });
}

burin_status burin_session_end(burin_session* session, burin_text* error) {
  return c::in_session(session, error, [&] {
    c::require_stroke(session, true);
    if (const auto last = session->stroke->pen->finish()) c::draw(*session, *last, Show::later);
    c::end_stroke(*session);
  });
}

burin_status burin_session_cancel(burin_session* session, burin_text* error) {
  return c::in_session(session, error, [&] {
    if (session->stroke && !session->stroke->pen) c::reject("the stroke is one of a group");
    c::cancel_stroke(*session);
  });
}

burin_status burin_session_undo(burin_session* session, burin_text* error) {
  return c::in_session(session, error,
                       [&] { c::take(session, &Session::undo, "there is no stroke to undo"); });
}

burin_status burin_session_redo(burin_session* session, burin_text* error) {
  return c::in_session(session, error,
                       [&] { c::take(session, &Session::redo, "there is no stroke to make again"); });
}

burin_status burin_session_set_progress(burin_session* session, burin_progress_function progress, void* user,
                                        burin_text* error) {
  return c::in_session(session, error, [&] {
    session->progress = c::progress_of(progress, user);
    session->session.set_progress(session->progress);
  });
}

burin_status burin_session_limit_undo(burin_session* session, uint64_t bytes, burin_text* error) {
  return c::in_session(session, error, [&] { session->session.limit_undo(bytes); });
}

burin_status burin_session_replay(burin_session* session, const char* path, const char* const* settings,
                                  burin_text* error) {
  return c::in_session(session, error, [&] {
    c::require_stroke(session, false);
    c::require(path, "path");
    c::replay_file(*session, path, settings);
  });
}
