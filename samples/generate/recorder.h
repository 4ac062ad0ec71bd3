#pragma once
#include <burin/stroke/recording.h>

#include <cstdint>
#include <string_view>
#include <vector>

#include "pen_motion.h"

namespace burin::samples {

/// How a device and its program record a hand: figures measured in recordings of real ones, which
/// docs/recordings.md lists.
struct Recorder {
  std::string_view name;
  std::string_view device;
  PenFields fields;
  /// Milliseconds between reports, in the order of their frequency; each report draws one.
  std::vector<double> intervals;
  double late = 0;           ///< share of reports that come late, by `gap` milliseconds
  double gap = 0;            ///< milliseconds
  double packed = 0;         ///< share of reports that come together with the next one, under its time
  double resting = 0;        ///< share of reports that repeat the position of the one before
  double pixel_step = 0;     ///< of positions, pixels
  double time_step = 0;      ///< of times, seconds
  int pressure_levels = 0;   ///< above 0; 0: no pressure
  double pressure_gain = 1;  ///< the greatest pressure, where above 1 the device saturates
  double hook = 0;           ///< pixels that the pen slips sideways as it lands and lifts
};

/// Records what the hand draws: reports at the recorder's times, with its steps, packets and hooks.
RecordedStroke record(const Recorder& recorder, const PenPath& path, const PenStyle& style);

/// The recorders that the sample recordings imitate.
std::vector<Recorder> recorders();

}  // namespace burin::samples
