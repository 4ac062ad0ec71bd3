#pragma once
#include <burin/stroke/recording.h>

#include <span>

namespace burin {

/// Whether all of several samples have the same time stamp, which then tells nothing.
bool clock_stands(std::span<const Sample> samples);

/// Gives samples of equal time stamps times of their own, for tablets whose samples come several at a time:
/// a stamp is the time of the last sample of its packet, and those before it are as far apart as the packets
/// of the stroke mostly have it, or as the time since the packet before allows. Stamps that occur once stay
/// as they are, to the bit, and so do all of a clock that stands. Times must not fall.
void spread_times(std::span<Sample> samples);

/// Spreads the times of all strokes. Those whose clock stands are then strokes without times; returns how
/// many.
std::size_t mend_times(Recording& recording);

}  // namespace burin
