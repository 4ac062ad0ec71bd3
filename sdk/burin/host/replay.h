#pragma once
#include <burin/base/progress.h>
#include <burin/host/session.h>
#include <burin/stroke/recording.h>
#include <burin/stroke/stabiliser.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace burin {

/// What is to hold instead of a recording's own settings.
struct StrokeOverrides {
  std::optional<std::string> brush;
  std::optional<double> radius;
  std::optional<double> strength;
  std::optional<Overlap> overlap;
  Accumulate accumulate = Accumulate::from_base;
  bool clamp_to_radius = false;  ///< as in StrokeSettings
  Symmetry symmetry;
  double dab_spacing = 0;          ///< as in StrokeSettings
  std::optional<Closure> closure;  ///< instead of what the recording marks
  std::optional<double> follow;    ///< as in StrokeSettings
  double pressure_width = 0;       ///< as in StrokeSettings
  std::size_t show_every = 1;      ///< samples shown: every so many; 0: the whole stroke at its end
  Join join = Join::round;
  std::vector<Dynamic> dynamics;  ///< target by target over the recording's
  Stabilising stabilising;        ///< of the samples, before anything else sees them
  ParamSettings params;  ///< name by name over the recording's, where the brush is the recording's own
};

/// Who watches a replay; both may be empty.
struct ReplayObserver {
  Progress progress;
  /// Called when a piece of a stroke has been drawn and ended; session.chart() is its chart.
  std::function<void(const Session& session)> piece_ended;
};

struct ReplayResult {
  std::size_t strokes = 0;    ///< of the recording
  std::size_t left_open = 0;  ///< of these, those that were to be closed but broke or are too short
  std::size_t pieces = 0;     ///< what they were drawn as: a stroke breaks where the pen leaves the surface
  std::size_t standing_clocks = 0;  ///< of these, those taken as without times, since all stamps are equal
  std::size_t samples_drawn = 0;
  std::size_t samples_off_surface = 0;
  std::uint64_t vertices_changed = 0;  ///< sum of StrokeEvent::changed over all samples and ends
  /// Wall time of add_sample for each sample shown, seconds, and Session::cost, with those before it that
  /// were not; and of end_stroke for each piece.
  std::vector<double> latencies;
  std::vector<EventCost> costs;
  std::vector<double> end_latencies;
  std::vector<EventCost> end_costs;
  std::uint64_t hash = 0;  ///< Session::result_hash at the end
};

/// Draws all strokes of a recording, with its times as mend_times() leaves them. Throws Error naming the
/// stroke's number, from 1, before anything is drawn, when a stroke has no brush or radius, or not the times
/// that stabilising needs; else as Session.
ReplayResult replay(Session& session, const Recording& recording, const StrokeOverrides& overrides = {},
                    const ReplayObserver& observer = {});

}  // namespace burin
