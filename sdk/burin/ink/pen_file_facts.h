#pragma once
#include <burin/ink/pen_file.h>

#include <optional>

namespace burin {

/// The least and the greatest of some values.
struct ValueRange {
  double least = 0, most = 0;
};

/// What the samples of a pen file are like. Ranges are absent where no stroke has the channel.
struct PenFileFacts {
  std::size_t strokes = 0, samples = 0;
  std::size_t pages = 0, layers = 0;                         ///< the last ones that have strokes
  std::size_t shortest = 0, median_length = 0, longest = 0;  ///< samples of a stroke
  std::size_t duplicates = 0;                                ///< samples at the position of the one before
  std::size_t equal_stamps = 0;                              ///< samples at the time of the one before
  std::size_t falling_times = 0;       ///< samples with an earlier time than the one before
  std::size_t gaps = 0;                ///< intervals longer than 5 times the median one
  std::size_t without_pressure = 0;    ///< samples in contact whose pressure is 0
  std::size_t made_pressure = 0;       ///< strokes whose pressure the program made
  std::size_t estimated_y = 0;         ///< strokes whose y is an estimate
  double ink_seconds = 0;              ///< from the first sample of each stroke to its last, summed
  double rate = 0;                     ///< samples per second within strokes; 0 without times
  double median_interval = 0;          ///< seconds
  double jitter = 0;                   ///< median of the intervals' distances from the median one, seconds
  std::optional<ValueRange> interval;  ///< seconds between samples of a stroke
  std::optional<ValueRange> pressure;  ///< 0..1
  std::optional<ValueRange> tilt_x, tilt_y;  ///< radians
  std::optional<ValueRange> x, y;            ///< PenFile::unit
};

PenFileFacts facts_of(const PenFile& file);

}  // namespace burin
