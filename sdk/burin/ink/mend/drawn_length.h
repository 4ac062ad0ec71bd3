#pragma once
#include <burin/stroke/recording.h>

#include <cstddef>
#include <span>

namespace burin {

/// The distance between two samples, in the unit of their positions.
inline double step(const Sample& a, const Sample& b) { return (b.position - a.position).norm(); }

/// The length of the polyline through the samples.
inline double drawn_length(std::span<const Sample> samples) {
  double length = 0;
  for (std::size_t i = 1; i < samples.size(); ++i) length += step(samples[i - 1], samples[i]);
  return length;
}

}  // namespace burin
