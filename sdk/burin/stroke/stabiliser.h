#pragma once
#include <burin/stroke/recording.h>

#include <optional>
#include <span>
#include <vector>

namespace burin {

/// How the hand's trembling is kept out of a stroke.
struct Stabilising {
  enum class Kind {
    none,
    string,       ///< the brush hangs on a string that the pen pulls: it moves along a tractrix
    exponential,  ///< the brush follows the pen's mean, in which the past fades as exp(-age / amount)
  };
  Kind kind = Kind::none;
  double amount = 1;  ///< > 0; string: its length, units of the samples' space; exponential: seconds
};

/// Filters the samples of one stroke before they are drawn: places in object space or pixels alike. What
/// comes out is exact for a pen that moves straight and evenly from sample to sample, so it does not depend
/// on the sampling rate. The string leaves time and pen as they are; the exponential filter lets the pen lag
/// behind with the place, so that pressures stay where they were put down. Times must not fall.
class Stabiliser {
 public:
  explicit Stabiliser(const Stabilising& stabilising) : stabilising_(stabilising) {}

  /// The brush's sample at the time of this one.
  Sample add(const Sample& sample);

  /// What leads from the last add() to where the pen ended, so that strokes end there: a straight line at
  /// the mean speed of the brush so far. Nothing where the brush is there already, or without samples.
  std::optional<Sample> finish() const;

 private:
  Stabilising stabilising_;
  bool begun_ = false;
  Sample first_, pen_, brush_;
  double brush_path_ = 0;  ///< length
};

/// All samples of a stroke, with the finish.
std::vector<Sample> stabilised(std::span<const Sample> samples, const Stabilising& stabilising);

}  // namespace burin
