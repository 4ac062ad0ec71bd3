#pragma once
#include <burin/base/vector.h>
#include <burin/stroke/pen.h>

#include <cstdint>
#include <functional>
#include <vector>

namespace burin::samples {

/// A curve to draw: maps u in [0, 1] to positions in the units of the recording.
using PenPath = std::function<Vec3d(double u)>;

/// How a hand draws. Lengths are in the units of the recording.
struct PenStyle {
  double speed;         ///< on straight parts, units per second
  double acceleration;  ///< greatest, units per second squared
  double bend_radius;   ///< radius of bends below which the hand slows down, units
  double tremor;        ///< amplitude, units
  std::uint64_t seed;
};

/// A report of a tablet: the pen's position on the path, and its offset from the path.
struct PenEvent {
  double time;   ///< seconds
  double u;      ///< parameter of the path
  Vec3d tremor;  ///< offset to add to the position on the path
  Pen pen;
};

/// Simulates a hand that draws the path, with 240 reports per second. The hand moves from rest to rest, slows
/// down in bends by the one-third power law of hand movement [Lacquaniti, Terzuolo and Viviani 1983], presses
/// harder where it is slow, and trembles with 8 to 12 Hz. Events depend on the arguments alone.
std::vector<PenEvent> draw(const PenPath& path, const PenStyle& style);

}  // namespace burin::samples
