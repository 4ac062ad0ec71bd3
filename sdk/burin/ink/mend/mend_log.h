#pragma once
#include <string>
#include <utility>
#include <vector>

namespace burin {

/// What was mended in a stroke, a line each.
class MendLog {
 public:
  /// `stroke`: its number, from 1.
  explicit MendLog(std::size_t stroke) : place_("stroke " + std::to_string(stroke)) {}

  /// Samples are counted from 1, as they are when the line is written.
  void add(std::size_t first, std::size_t last, const std::string& what) {
    const std::string samples = first == last
                                    ? "sample " + std::to_string(first)
                                    : "samples " + std::to_string(first) + " to " + std::to_string(last);
    lines_.push_back(place_ + ", " + samples + ": " + what);
  }

  std::vector<std::string> lines() && { return std::move(lines_); }

 private:
  std::string place_;
  std::vector<std::string> lines_;
};

}  // namespace burin
