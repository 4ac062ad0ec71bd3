#pragma once
#include <burin/base/vector.h>
#include <burin/stroke/pen.h>

#include <cstdint>
#include <functional>
#include <vector>

namespace burin::samples {

/// A curve to draw: positions for u in [0, 1], in the units of the recording.
using PenPath = std::function<Vec3d(double u)>;

struct PenStyle {
  double speed;         ///< on straight parts, units a second
  double acceleration;  ///< greatest, units a second squared
  double bend_radius;   ///< of bends at which the hand begins to slow down, units
  double tremor;        ///< amplitude, units
  std::uint64_t seed;
};

/// What a tablet reports: where the pen is on the path and beside it.
struct PenEvent {
  double time;   ///< seconds
  double u;      ///< on the path
  Vec3d tremor;  ///< to be added to the place on the path
  Pen pen;
};

/// Draws the path as a hand does, reported 240 times a second: slower in bends by the one-third power law
/// of hand movement [Lacquaniti, Terzuolo and Viviani 1983], from rest to rest, pressed down harder where it
/// is slow, with the 8 to 12 Hz tremor of a hand. Events depend on the arguments alone.
std::vector<PenEvent> draw(const PenPath& path, const PenStyle& style);

}  // namespace burin::samples
