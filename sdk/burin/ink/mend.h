#pragma once
#include <burin/stroke/recording.h>

#include <string>
#include <vector>

namespace burin {

/// Mends what can be mended in each stroke: the order of samples, duplicates, packets of equal stamps, wild
/// samples and hooks, in this order. Returns what it did, a line each. A recording without such faults keeps
/// its bits.
std::vector<std::string> mend(Recording& recording);

/// Begins a new stroke with the same settings at each sample that comes more than `gap` seconds after the one
/// before. Returns a line for each such sample.
std::vector<std::string> split(Recording& recording, double gap);

/// Joins strokes that begin at most `gap` seconds after the end of the one before, if both have the same
/// fields and tool; the settings are those of the first. Returns a line for each joined stroke.
std::vector<std::string> join(Recording& recording, double gap);

/// Replaces samples by those at even times, `rate` to the second from the first sample on, and the last one;
/// what is between two samples is linear. Strokes without times stay. Returns a line for each stroke. Throws
/// Error for times that fall, and for more than ten million samples.
std::vector<std::string> resample(Recording& recording, double rate);

}  // namespace burin
