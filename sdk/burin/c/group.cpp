// Strokes over several sessions for C: each sample goes to the session whose surface the pen meets first, at
// the cost of a search in every session. Where that changes, a piece of the stroke ends on one session and
// another begins on the next.
#include <burin/host/c/drawing.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace burin::c {
namespace {

/// A session that a finished stroke has changed.
struct Change {
  burin_session* session;
  std::size_t finished;  ///< its strokes up to this one
};

/// The strokes of a session that are not undone.
std::size_t finished(const burin_session& session) {
  return session.session.undo_count() + session.session.undo_dropped();
}

/// A stroke that is undone and made again as one.
using GroupStep = std::vector<Change>;

/// Throws plugin::Error unless every session can take this stroke back, or make it again, as its next step.
void check(const GroupStep& step, bool undo) {
  for (const Change& change : step) {
    const Session& session = change.session->session;
    if (change.session->stroke) reject("a stroke is open");
    if (finished(*change.session) != change.finished - (undo ? 0 : 1))
      reject("a session has drawn, undone or made again a stroke by itself");
    if ((undo ? session.undo_count() : session.redo_count()) == 0)
      throw plugin::Error("a session holds the step no more", BURIN_NOT_FOUND);
  }
}

}  // namespace
}  // namespace burin::c

struct burin_group {
  explicit burin_group(std::vector<burin_session*> members) : sessions(std::move(members)) {}
  burin_group(const burin_group&) = delete;
  burin_group& operator=(const burin_group&) = delete;
  ~burin_group() { cancel(); }

  void begin(const burin_stroke* stroke);
  burin_group_event add(const std::vector<burin::c::PenSample>& samples);
  void end();
  void cancel();
  void take(bool undo);

  std::vector<burin_session*> sessions;
  std::optional<burin::c::PenInput> pen;  ///< of the open stroke

 private:
  std::optional<std::size_t> nearest(const burin::c::PenSample& given) const;
  burin::StrokeEvent::Outcome draw(const burin::c::PenSample& given, burin::Show show);
  void finish();

  double radius_ = 0;                                   ///< of the open stroke
  std::size_t current_ = 0;                             ///< the session that the pen was on last
  std::vector<burin::c::GroupStep> undoable_, undone_;  ///< newest last
};

using namespace burin;

/// The session whose surface the ray meets first, or which is closest to the position: of equal ones the
/// first.
std::optional<std::size_t> burin_group::nearest(const c::PenSample& given) const {
  std::optional<std::size_t> found;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < sessions.size(); ++i) {
    const Picker& picker = sessions[i]->session.picker();
    const auto at = given.is_ray()
                        ? picker.pick(given.ray())
                        : picker.closest(given.sample.position.cast<float>(), static_cast<float>(radius_));
    if (!at) continue;
    const double distance = (at->position.cast<double>() - given.sample.position).squaredNorm();
    if (distance < least) found = i;
    least = std::min(least, distance);
  }
  return found;
}

/// Opens the stroke in all sessions: what one of them refuses is told at once.
void burin_group::begin(const burin_stroke* stroke) {
  for (std::size_t i = 0; i < sessions.size(); ++i)
    if (sessions[i]->stroke) c::reject("session " + std::to_string(i) + " has an open stroke");
  std::vector<ReplaySettings> settings;
  for (const burin_session* session : sessions)
    settings.push_back(c::stroke_settings(stroke, *session->brushes, session->told.has_value()));
  pen.emplace(settings.front());
  radius_ = settings.front().radius;
  current_ = 0;
  std::vector<std::vector<c::PenSample>> paths(sessions.size());
  for (const c::PenSample& given : c::path_of(*stroke, settings.front()))
    if (const auto on = nearest(given)) paths[*on].push_back(given);
  for (std::size_t i = 0; i < sessions.size(); ++i) c::begin_stroke(*sessions[i], settings[i], paths[i], {});
}

StrokeEvent::Outcome burin_group::draw(const c::PenSample& given, Show show) {
  const std::size_t next = nearest(given).value_or(current_);
  if (next != current_) c::end_piece(*sessions[current_]);
  current_ = next;
  return c::draw(*sessions[current_], given, show);
}

burin_group_event burin_group::add(const std::vector<c::PenSample>& samples) {
  burin_group_event event{};
  for (const c::PenSample& given : samples) {
    const bool drawn = draw(pen->take(given), &given == &samples.back() ? Show::now : Show::later) ==
                       StrokeEvent::Outcome::drawn;
    event.outcome = drawn ? BURIN_OUTCOME_DRAWN : BURIN_OUTCOME_OFF_SURFACE;
    event.drawn += drawn;
  }
  event.session = current_;
  return event;
}

/// Finishes what is drawn in every session before the stroke ends in the first, so that what fails fails in
/// all.
void burin_group::finish() {
  for (burin_session* session : sessions) {
    if (!session->stroke->piece_begun) continue;
    const Closure closure = c::closure_of_last_piece(*session->stroke);
    c::noted(*session, [&](Session& to) { return to.end_piece(closure).size(); });
  }
}

void burin_group::end() {
  if (const auto last = pen->finish()) draw(*last, Show::later);
  finish();
  c::GroupStep step;
  for (burin_session* session : sessions) {
    const std::size_t before = c::finished(*session);
    c::end_stroke(*session);
    if (c::finished(*session) != before) step.push_back({session, before + 1});
  }
  pen.reset();
  if (step.empty()) return;
  undoable_.push_back(std::move(step));
  undone_.clear();
}

void burin_group::cancel() {
  if (!pen) return;
  for (burin_session* session : sessions) c::cancel_stroke(*session);
  pen.reset();
}

void burin_group::take(bool undo) {
  auto [from, to] = undo ? std::tie(undoable_, undone_) : std::tie(undone_, undoable_);
  if (from.empty())
    throw plugin::Error(undo ? "there is no stroke to undo" : "there is no stroke to make again",
                        BURIN_NOT_FOUND);
  c::check(from.back(), undo);
  for (const c::Change& change : from.back())
    c::noted(*change.session, [&](Session& of) { return undo ? of.undo() : of.redo(); });
  to.push_back(std::move(from.back()));
  from.pop_back();
}

namespace burin::c {
namespace {

void require_stroke(const burin_group& group, bool open) {
  if (group.pen && !open) reject("a stroke is open");
  if (!group.pen && open) reject("no stroke is open");
}

/// Runs the body of a call of a group, which must be there, on the threads that its application lends.
template <class Body>
burin_status in_group(const burin_group* group, burin_text* error, const Body& body) {
  return plugin::guarded(error, [&] {
    require(group, "group");
    const TaskRunnerScope scope(group->sessions.front()->threads.get());
    body();
  });
}

/// Runs a call of the group's open stroke. If it throws, the stroke is gone.
template <class Call>
void dropping(burin_group& group, const Call& call) {
  try {
    call();
  } catch (...) {
    group.cancel();
    throw;
  }
}

}  // namespace
}  // namespace burin::c

burin_status burin_group_create(burin_session* const* sessions, uint64_t count, burin_group** group,
                                burin_text* error) {
  return plugin::guarded(error, [&] {
    c::require(sessions, "sessions");
    c::require(group, "group");
    if (count == 0) c::reject("a group wants a session");
    std::vector<burin_session*> members(sessions, sessions + count);
    for (const burin_session* member : members) c::require(member, "a session");
    std::vector<burin_session*> sorted = members;
    std::ranges::sort(sorted, std::less<>());
    if (std::ranges::adjacent_find(sorted) != sorted.end()) c::reject("a session is there twice");
    *group = new burin_group(std::move(members));
  });
}

void burin_group_destroy(burin_group* group) {
  if (!group) return;
  // An open stroke is dropped, which runs loops.
  const TaskRunnerScope scope(group->sessions.front()->threads.get());
  delete group;
}

burin_status burin_group_begin(burin_group* group, const burin_stroke* stroke, burin_text* error) {
  return c::in_group(group, error, [&] {
    c::require_stroke(*group, false);
    c::dropping(*group, [&] { group->begin(stroke); });
  });
}

burin_status burin_group_add(burin_group* group, const burin_sample* samples, uint64_t count,
                             burin_group_event* event, burin_text* error) {
  return c::in_group(group, error, [&] {
    c::require_stroke(*group, true);
    const bool has_first = !event || BURIN_HAS(event, burin_group_event, session);
    if (!has_first) c::reject("event is too small");
    const std::vector<c::PenSample> read = group->pen->read(samples, count);
    c::dropping(*group, [&] {
      const burin_group_event happened = group->add(read);
      if (event) c::give(happened, event, has_first, "event");
    });
  });
}

burin_status burin_group_end(burin_group* group, burin_text* error) {
  return c::in_group(group, error, [&] {
    c::require_stroke(*group, true);
    c::dropping(*group, [&] { group->end(); });
  });
}

burin_status burin_group_cancel(burin_group* group, burin_text* error) {
  return c::in_group(group, error, [&] { group->cancel(); });
}

burin_status burin_group_undo(burin_group* group, burin_text* error) {
  return c::in_group(group, error, [&] {
    c::require_stroke(*group, false);
    group->take(true);
  });
}

burin_status burin_group_redo(burin_group* group, burin_text* error) {
  return c::in_group(group, error, [&] {
    c::require_stroke(*group, false);
    group->take(false);
  });
}
