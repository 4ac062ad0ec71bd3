// Replays a recording: repairs its times, stabilises its samples, completes the settings of each stroke, and
// draws the strokes piece by piece with the time and cost of every call.
#include <burin/base/error.h>
#include <burin/base/stopwatch.h>
#include <burin/host/replay.h>
#include <burin/host/stroke_pieces.h>
#include <burin/stroke/sample_times.h>
#include <burin/stroke/stabiliser.h>
#include <fmt/format.h>

#include <utility>

namespace burin {
namespace {

using Outcome = StrokeEvent::Outcome;

/// Those of radius and strength mean the same to another brush, those of parameters nothing.
std::vector<Dynamic> without_params(std::vector<Dynamic> dynamics) {
  std::erase_if(dynamics, [](const Dynamic& d) { return d.target != "radius" && d.target != "strength"; });
  return dynamics;
}

std::vector<ReplaySettings> all_settings(const Recording& recording, const GivenSettings& overrides) {
  std::vector<ReplaySettings> settings;
  for (const RecordedStroke& stroke : recording.strokes)
    settings.push_back(replay_settings(stroke, settings.size(), overrides));
  return settings;
}

/// The recording as the stabiliser lets it through.
Recording stabilised(Recording calm, const std::vector<ReplaySettings>& settings) {
  for (std::size_t i = 0; i < calm.strokes.size(); ++i) {
    RecordedStroke& stroke = calm.strokes[i];
    const Stabilising& stabilising = settings[i].stabilising;
    if (stabilising.kind == Stabilising::Kind::exponential && !stroke.fields.time)
      throw Error(fmt::format("stroke {} has no times, which the exponential stabiliser needs", i + 1));
    stroke.samples = stabilised(stroke.samples, stabilising);
  }
  return calm;
}

/// Draws one recorded stroke after the other, in as many pieces as it takes.
class Replayer {
 public:
  Replayer(Session& session, const Recording& recording, const std::vector<ReplaySettings>& settings,
           const ReplayObserver& observer)
      : session_(session), recording_(recording), settings_(settings), observer_(observer) {
    for (const RecordedStroke& stroke : recording.strokes) samples_ += stroke.samples.size();
  }

  void draw(std::size_t number);
  ReplayResult finish();

 private:
  void begin(std::size_t number);
  std::vector<Vec3d> places_of(const RecordedStroke& stroke) const;
  Outcome add(const Sample& sample);
  Ray ray_of(const Sample& sample) const {
    return pixel_ray(*recording_.camera, sample.position.x(), sample.position.y());
  }
  StrokeEvent add_to_session(const Sample& sample, Show show);
  void add_cost(double seconds);
  void record_event(std::vector<double>& latencies, std::vector<EventCost>& costs);
  template <class EndPiece>
  void end(const EndPiece& end_piece);
  template <class Call>
  auto told(const Call& call);
  void report_progress();

  Session& session_;
  const Recording& recording_;
  const std::vector<ReplaySettings>& settings_;  ///< [stroke]
  std::size_t show_every_ = 1;                   ///< of the stroke being drawn
  const ReplayObserver& observer_;
  std::size_t samples_ = 0, samples_done_ = 0;
  std::size_t drawn_in_piece_ = 0;
  double seconds_ = 0;  ///< since the last event that was shown
  EventCost cost_;      ///< the same
  ReplayResult result_;
};

/// A stroke breaks into pieces where the pen leaves the surface. Of one that does, only pieces that come back
/// by themselves close.
void Replayer::draw(std::size_t number) {
  const RecordedStroke& stroke = recording_.strokes[number];
  const ReplaySettings& settings = settings_[number];
  ++result_.strokes;
  show_every_ = settings.show_every;
  const Closure closure = settings.closure;
  const std::size_t pieces_before = result_.pieces;
  const Closure of_a_piece = closure_of_piece(closure);
  const auto end_piece = [&] { end([&] { return session_.end_piece(of_a_piece); }); };
  begin(number);
  for (const Sample& sample : stroke.samples) {
    const Outcome outcome = add_in_pieces(
        drawn_in_piece_ > 0, [&] { return add(sample); }, end_piece);
    if (outcome == Outcome::off_surface) ++result_.samples_off_surface;
    report_progress();
  }
  const bool whole = result_.pieces == pieces_before;
  end([&] { return session_.end_stroke(whole ? closure : of_a_piece); });
  const bool drawn = result_.pieces > pieces_before;
  if (closure == Closure::closed && drawn && !(whole && session_.curve().closed)) ++result_.left_open;
}

/// Where strokes may refine the surface the session is told where they go.
void Replayer::begin(std::size_t number) {
  if (settings_[number].refining.kind == Refining::Kind::off) return session_.begin_stroke(settings_[number]);
  // It is asked until the stroke ends, when this call is over.
  const auto later = [this, number] {
    std::vector<PlannedStroke> planned;
    for (std::size_t i = number + 1; i < settings_.size(); ++i)
      planned.push_back({settings_[i], places_of(recording_.strokes[i])});
    return planned;
  };
  session_.begin_stroke(settings_[number], places_of(recording_.strokes[number]), later);
}

/// The places of the surface at which a stroke's samples point.
std::vector<Vec3d> Replayer::places_of(const RecordedStroke& stroke) const {
  std::vector<Vec3d> places;
  for (const Sample& sample : stroke.samples) {
    if (recording_.space == StrokeSpace::object)
      places.push_back(sample.position);
    else if (const auto at = session_.picker().pick(ray_of(sample)))
      places.push_back(at->position.cast<double>());
  }
  return places;
}

/// What a call of the session returns, once the observer was told of it.
template <class Call>
auto Replayer::told(const Call& call) {
  const auto tell = [&] {
    if (observer_.changed) observer_.changed(session_);
  };
  try {
    const auto result = call();
    tell();
    return result;
  } catch (...) {
    tell();
    throw;
  }
}

Outcome Replayer::add(const Sample& sample) {
  const bool shown = show_every_ > 0 && (drawn_in_piece_ + 1) % show_every_ == 0;
  const Stopwatch watch;
  const StrokeEvent event = told([&] { return add_to_session(sample, shown ? Show::now : Show::later); });
  const double seconds = watch.elapsed();
  if (event.outcome != Outcome::drawn) return event.outcome;
  add_cost(seconds);
  if (shown) record_event(result_.latencies, result_.costs);
  result_.vertices_changed += event.changed.size();
  ++result_.samples_drawn;
  ++drawn_in_piece_;
  return event.outcome;
}

/// Counts a call of the session towards the next event.
void Replayer::add_cost(double seconds) {
  seconds_ += seconds;
  cost_ += session_.cost();
}

void Replayer::record_event(std::vector<double>& latencies, std::vector<EventCost>& costs) {
  latencies.push_back(std::exchange(seconds_, 0));
  costs.push_back(std::exchange(cost_, {}));
}

StrokeEvent Replayer::add_to_session(const Sample& sample, Show show) {
  if (recording_.space == StrokeSpace::object)
    return session_.add_sample(sample.position, sample.time, sample.pen, show);
  return session_.add_sample(ray_of(sample), sample.time, sample.pen, show);
}

/// A piece, and perhaps the stroke with it.
template <class EndPiece>
void Replayer::end(const EndPiece& end_piece) {
  const Stopwatch watch;
  result_.vertices_changed += told(end_piece).size();
  const double seconds = watch.elapsed();
  if (drawn_in_piece_ == 0) return;
  add_cost(seconds);
  record_event(result_.end_latencies, result_.end_costs);
  ++result_.pieces;
  drawn_in_piece_ = 0;
  if (observer_.piece_ended) observer_.piece_ended(session_);
}

void Replayer::report_progress() {
  const std::size_t steps = 200;
  const std::size_t step_before = samples_done_ * steps / samples_;
  if (++samples_done_ * steps / samples_ == step_before) return;
  report(observer_.progress, "replaying strokes",
         static_cast<double>(samples_done_) / static_cast<double>(samples_));
}

ReplayResult Replayer::finish() {
  result_.hash = session_.result_hash();
  return std::move(result_);
}

/// Lets a session tell its progress during a replay, where that is asked for.
class ShownProgress {
 public:
  ShownProgress(Session& session, const Progress& progress) : session_(progress ? &session : nullptr) {
    if (session_) session_->set_progress(progress);
  }
  ~ShownProgress() {
    if (session_) session_->set_progress({});
  }
  ShownProgress(const ShownProgress&) = delete;
  ShownProgress& operator=(const ShownProgress&) = delete;

 private:
  Session* session_;
};

}  // namespace

ReplaySettings replay_settings(const RecordedStroke& stroke, std::size_t number,
                               const GivenSettings& overrides) {
  const ReplaySettings recorded = stroke.settings.complete();
  ReplaySettings settings = recorded, told;
  overrides.apply_to(settings);
  overrides.apply_to(told);
  if (settings.along.given()) settings.brush.clear();
  if (settings.brush.empty() && !settings.along.given())
    throw Error(fmt::format("stroke {} names no brush", number + 1));
  if (settings.radius == 0) throw Error(fmt::format("stroke {} has no radius", number + 1));
  const bool same_brush = !settings.along.given() && settings.brush == recorded.brush;
  settings.params = told.params;
  // Parameters of another brush mean nothing to this one.
  if (same_brush) settings.params.insert(recorded.params.begin(), recorded.params.end());
  settings.dynamics =
      replaced(same_brush ? recorded.dynamics : without_params(recorded.dynamics), told.dynamics);
  settings.fields = stroke.fields;
  settings.seed = number;
  return settings;
}

ReplayResult replay(Session& session, const Recording& recorded, const GivenSettings& overrides,
                    const ReplayObserver& observer, std::size_t first) {
  Recording timed = recorded;
  const std::size_t standing_clocks = repair_times(timed);
  const std::vector<ReplaySettings> settings = all_settings(timed, overrides);
  const Recording recording = stabilised(std::move(timed), settings);
  if (recording.space == StrokeSpace::screen && !recording.camera)
    throw ContractError("a recording in screen space without a camera");
  Replayer replayer(session, recording, settings, observer);
  const ShownProgress shown(session, observer.progress);
  for (std::size_t i = first; i < settings.size(); ++i) {
    const auto named = [&](const Error& error) { return fmt::format("stroke {}: {}", i + 1, error.what()); };
    try {
      replayer.draw(i);
    } catch (const ContractError& error) {
      throw ContractError(named(error));
    } catch (const Error& error) {
      throw Error(named(error));
    }
  }
  ReplayResult result = replayer.finish();
  result.standing_clocks = standing_clocks;
  return result;
}

}  // namespace burin
