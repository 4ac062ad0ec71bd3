#pragma once
#include <burin/stroke/recording.h>

#include <span>

// The functions may be called on any thread, also on several at once for different samples.
namespace burin {

/// Whether there are several samples and all have the same time stamp, so that times are useless.
bool has_constant_time(std::span<const Sample> samples);

/// Spreads equal time stamps, for tablets that deliver samples in packets. The stamp is the time of the last
/// sample of its packet. The samples before it get the median interval of the stroke's packets, or less if
/// the time since the packet before is too short. Stamps that occur once keep their bits, and so do all
/// stamps if has_constant_time(). Times must not fall.
void spread_times(std::span<Sample> samples);

/// Spreads the times of all strokes. Strokes for which has_constant_time() become strokes without times;
/// returns their number.
std::size_t repair_times(Recording& recording);

}  // namespace burin
