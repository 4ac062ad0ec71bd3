#pragma once
#include <burin/stroke/recording.h>

#include <cstddef>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace burin {

/// What was mended in a stroke, a line each.
class MendLog {
 public:
  /// `stroke`: its number, from 1. `samples`: how many it has.
  MendLog(std::size_t stroke, std::size_t samples)
      : place_("stroke " + std::to_string(stroke)), numbers_(samples) {
    std::iota(numbers_.begin(), numbers_.end(), 1);
  }

  /// `begin` to `last`: places, from 0, in the stroke as it is now. The line has the numbers that the samples
  /// had in the recording, from 1.
  void add(std::size_t begin, std::size_t last, const std::string& what) {
    const std::size_t from = numbers_[begin], to = numbers_[last];
    const std::string samples = from == to ? "sample " + std::to_string(from)
                                           : "samples " + std::to_string(from) + " to " + std::to_string(to);
    lines_.push_back(place_ + ", " + samples + ": " + what);
  }

  /// Leaves the stroke only those of its samples at these places, in this order.
  void keep(const std::vector<std::size_t>& places, std::vector<Sample>& samples) {
    numbers_ = at(places, numbers_);
    samples = at(places, samples);
  }

  std::vector<std::string> lines() && { return std::move(lines_); }

 private:
  template <class Value>
  static std::vector<Value> at(const std::vector<std::size_t>& places, const std::vector<Value>& values) {
    std::vector<Value> chosen;
    chosen.reserve(places.size());
    for (const std::size_t place : places) chosen.push_back(values[place]);
    return chosen;
  }

  std::string place_;
  std::vector<std::size_t> numbers_;  ///< [place] of the sample in the recording
  std::vector<std::string> lines_;
};

}  // namespace burin
