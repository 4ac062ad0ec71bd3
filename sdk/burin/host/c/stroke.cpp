// Strokes for C. What the caller got wrong is found before the session is called, which would drop the open
// stroke.
#include <burin/host/c/call.h>
#include <burin/host/c/handles.h>
#include <burin/host/c/pen_fields.h>
#include <burin/host/c/stroke_texts.h>
#include <burin/host/c/whole_recording.h>
#include <burin/host/replay.h>
#include <burin/host/stroke_pieces.h>
#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace burin::c {
namespace {

/// A sample of the pen near the surface, or where a ray meets it.
struct PenSample {
  Sample sample;                    ///< position: where the ray begins, if there is one
  Vec3d direction = Vec3d::Zero();  ///< of the ray; zero: there is none

  bool is_ray() const { return !direction.isZero(0); }
};

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

void require_stroke(const burin_session* session, bool open) {
  require(session, "session");
  if (session->stroke && !open) reject("a stroke is open");
  if (!session->stroke && open) reject("no stroke is open");
}

ReplaySettings settings_of(const burin_stroke& given, const BrushLibrary& brushes) {
  require(given.settings, "settings");
  const GivenSettings texts = read_texts(given.settings, brushes);
  ReplaySettings settings = texts.complete();
  if (texts.find(&ReplaySettings::show_every))
    reject("show_every: is for recordings; how many samples a call has decides when they are shown");
  if (settings.brush.empty() && !settings.along.given()) reject("settings lack the brush");
  if (!texts.find(&StrokeSettings::radius)) reject("settings lack the radius");
  settings.fields = fields_of(given.fields);
  settings.seed = given.seed;
  if (settings.stabilising.kind == Stabilising::Kind::exponential && !settings.fields.time)
    reject("stabilise: the exponential filter wants BURIN_PEN_TIME");
  return settings;
}

/// Throws plugin::Error if there is no such brush.
void find_brush(const ReplaySettings& settings, const BrushLibrary& brushes) {
  if (settings.along.given()) return;
  try {
    brushes.find(settings.brush);
  } catch (const Error& fault) {
    throw plugin::Error(fault.what(), BURIN_NOT_FOUND);
  }
}

bool all_finite(const Vec3d& v) { return v.cast<float>().allFinite(); }

void check(const PenSample& given, std::uint64_t number, const OpenStroke& stroke, double& last_time) {
  const Pen& pen = given.sample.pen;
  const auto refuse = [&](const char* what) { reject(fmt::format("sample {}: {}", number, what)); };
  if (!all_finite(given.sample.position)) refuse("its position is not finite");
  if (!all_finite(given.direction)) refuse("its direction is not finite");
  if (!std::isfinite(given.sample.time) || given.sample.time < last_time) refuse("its time falls");
  if (!(pen.pressure >= 0 && pen.pressure <= 1)) refuse("its pressure is not from 0 to 1");
  if (!std::isfinite(pen.tilt_x) || !std::isfinite(pen.tilt_y) || !std::isfinite(pen.twist))
    refuse("its tilt or twist is not finite");
  if (given.is_ray() && stroke.stabilising.kind != Stabilising::Kind::none)
    refuse("rays cannot be stabilised");
  last_time = given.sample.time;
}

std::vector<PenSample> checked_samples(const burin_sample* given, std::uint64_t count,
                                       const OpenStroke& stroke) {
  std::vector<PenSample> samples(count);
  double last_time = stroke.last_time;
  read_samples(given, count, [&](const burin_sample& known, std::uint64_t i) {
    samples[i].sample.position = Vec3d(known.position[0], known.position[1], known.position[2]);
    samples[i].direction = Vec3d(known.direction[0], known.direction[1], known.direction[2]);
    read_pen(known, stroke.fields, samples[i].sample.time, samples[i].sample.pen);
    if (i == 0 && !stroke.has_samples) last_time = samples[i].sample.time;
    check(samples[i], i, stroke, last_time);
  });
  return samples;
}

/// Draws a sample as the stabiliser let it through.
StrokeEvent::Outcome draw(burin_session& session, const PenSample& given, Show show) {
  OpenStroke& stroke = *session.stroke;
  const Sample& sample = given.sample;
  const auto add = [&] {
    return noted(session, [&](Session& to) {
      if (!given.is_ray()) return to.add_sample(sample.position, sample.time, sample.pen, show).outcome;
      const Ray ray{sample.position.cast<float>(), given.direction.cast<float>()};
      return to.add_sample(ray, sample.time, sample.pen, show).outcome;
    });
  };
  const auto end_piece = [&] {
    noted(session, [&](Session& to) { return to.end_piece(closure_of_piece(stroke.closure)).size(); });
    stroke.piece_begun = stroke.whole = false;
  };
  const StrokeEvent::Outcome outcome = add_in_pieces(stroke.piece_begun, add, end_piece);
  stroke.piece_begun |= outcome == StrokeEvent::Outcome::drawn;
  return outcome;
}

/// Draws samples, of which the last brings the surface up to date.
burin_event add_all(burin_session& session, std::vector<PenSample> samples) {
  burin_event event{};
  for (PenSample& given : samples) {
    OpenStroke& stroke = *session.stroke;
    stroke.last_time = given.sample.time;
    stroke.has_samples = true;
    if (!given.is_ray()) given.sample = stroke.stabiliser.add(given.sample);
    const StrokeEvent::Outcome outcome =
        draw(session, given, &given == &samples.back() ? Show::now : Show::later);
    const bool drawn = outcome == StrokeEvent::Outcome::drawn;
    event.outcome = drawn ? BURIN_OUTCOME_DRAWN : BURIN_OUTCOME_OFF_SURFACE;
    event.drawn += drawn;
  }
  return event;
}

void end(burin_session& session) {
  const OpenStroke& stroke = *session.stroke;
  if (stroke.stabilising.kind != Stabilising::Kind::none)
    if (const std::optional<Sample> last = stroke.stabiliser.finish()) draw(session, {*last}, Show::later);
  const Closure closure = stroke.whole ? stroke.closure : closure_of_piece(stroke.closure);
  noted(session, [&](Session& to) { return to.end_stroke(closure).size(); });
  session.stroke.reset();
}

/// Undoes or makes again.
void take(burin_session* session, bool (Session::*one)(), const char* none) {
  require_stroke(session, false);
  const bool taken = noted(*session, [&](Session& to) { return (to.*one)(); });
  if (!taken) throw plugin::Error(none, BURIN_NOT_FOUND);
}

void replay_file(burin_session& session, const char* path, const char* const* settings) {
  const GivenSettings overrides = read_texts(settings, *session.brushes);
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
  return plugin::guarded(error, [&] {
    c::require_stroke(session, false);
    const burin_stroke known =
        c::known_members(stroke, stroke && BURIN_HAS(stroke, burin_stroke, seed), "stroke");
    const ReplaySettings settings = c::settings_of(known, *session->brushes);
    c::find_brush(settings, *session->brushes);
    session->session.begin_stroke(settings);
    session->stroke.emplace(settings);
  });
}

burin_status burin_session_add(burin_session* session, const burin_sample* samples, uint64_t count,
                               burin_event* event, burin_text* error) {
  return plugin::guarded(error, [&] {
    c::require_stroke(session, true);
    c::require(samples, "samples");
    const bool has_first = !event || BURIN_HAS(event, burin_event, drawn);
    if (!has_first) c::reject("event is too small");
    const burin_event happened = c::add_all(*session, c::checked_samples(samples, count, *session->stroke));
    if (event) c::give(happened, event, has_first, "event");
  });
}

burin_status burin_session_end(burin_session* session, burin_text* error) {
  return plugin::guarded(error, [&] {
    c::require_stroke(session, true);
    c::end(*session);
  });
}

burin_status burin_session_cancel(burin_session* session, burin_text* error) {
  return plugin::guarded(error, [&] {
    c::require(session, "session");
    session->session.cancel_stroke();
    session->note_changed();
    session->stroke.reset();
  });
}

burin_status burin_session_undo(burin_session* session, burin_text* error) {
  return plugin::guarded(error, [&] { c::take(session, &Session::undo, "there is no stroke to undo"); });
}

burin_status burin_session_redo(burin_session* session, burin_text* error) {
  return plugin::guarded(error,
                         [&] { c::take(session, &Session::redo, "there is no stroke to make again"); });
}

burin_status burin_session_set_progress(burin_session* session, burin_progress_function progress, void* user,
                                        burin_text* error) {
  return plugin::guarded(error, [&] {
    c::require(session, "session");
    session->progress = c::progress_of(progress, user);
    session->session.set_progress(session->progress);
  });
}

burin_status burin_session_limit_undo(burin_session* session, uint64_t bytes, burin_text* error) {
  return plugin::guarded(error, [&] {
    c::require(session, "session");
    session->session.limit_undo(bytes);
  });
}

burin_status burin_session_replay(burin_session* session, const char* path, const char* const* settings,
                                  burin_text* error) {
  return plugin::guarded(error, [&] {
    c::require_stroke(session, false);
    c::require(path, "path");
    c::replay_file(*session, path, settings);
  });
}
