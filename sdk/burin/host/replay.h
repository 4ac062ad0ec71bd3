#pragma once
#include <burin/base/progress.h>
#include <burin/host/session.h>
#include <burin/stroke/given_settings.h>
#include <burin/stroke/recording.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

// replay() is to be called on the session's thread, replay_settings() on any, also on several at once.
namespace burin {

/// Who watches a replay; all may be empty.
struct ReplayObserver {
  Progress progress;
  /// Called when a piece of a stroke has been drawn and ended; session.chart() is its chart.
  std::function<void(const Session& session)> piece_ended;
  /// Called after each sample and end of a piece or stroke, and where one threw: Session::changed() tells
  /// what it changed.
  std::function<void(const Session& session)> changed = {};
};

/// What a replay did.
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

/// What a recorded stroke is drawn with: `overrides` before its own settings, of parameters name by name and
/// of dynamics target by target. What is recorded for another brush than the chosen one is left out.
/// `number`: of the stroke, from 0. Throws Error, naming the stroke's number from 1, when brush or radius are
/// given by neither.
ReplaySettings replay_settings(const RecordedStroke& stroke, std::size_t number,
                               const GivenSettings& overrides);

/// Draws all strokes of a recording, or those from `first` on, with its times as repair_times() leaves them.
/// Throws Error naming the stroke's number, from 1, before anything is drawn, when a stroke has no brush or
/// radius, or not the times that stabilising needs; else as Session.
ReplayResult replay(Session& session, const Recording& recording, const GivenSettings& overrides = {},
                    const ReplayObserver& observer = {}, std::size_t first = 0);

}  // namespace burin
