#pragma once
#include <burin/stroke/recording.h>
#include <burin/stroke/stroke_choices.h>

#include <optional>
#include <span>
#include <vector>

// The free functions may be called on any thread, also on several at once.
namespace burin {

/// Filters the samples of one stroke before they are drawn, in object space or in pixels. The result is exact
/// for a pen that moves straight and evenly from sample to sample, so it does not depend on the sampling
/// rate. The string does not change time and pen; the exponential filter delays the pen like the position, so
/// that pressures stay at the positions where they were applied. Times must not fall. One thread; O(1) per
/// sample.
class Stabiliser {
 public:
  explicit Stabiliser(const Stabilising& stabilising) : stabilising_(stabilising) {}

  /// Adds a sample of the pen and returns the sample of the brush at the same time.
  Sample add(const Sample& sample);

  /// The sample that takes the brush straight to the pen's last position, at the mean speed of the brush so
  /// far. Nothing if the brush is there already, or without samples.
  std::optional<Sample> finish() const;

 private:
  Stabilising stabilising_;
  bool begun_ = false;
  Sample first_, pen_, brush_;
  double brush_path_ = 0;  ///< length of the brush's path so far
};

/// Filters all samples of a stroke, and appends the finish.
std::vector<Sample> stabilised(std::span<const Sample> samples, const Stabilising& stabilising);

}  // namespace burin
