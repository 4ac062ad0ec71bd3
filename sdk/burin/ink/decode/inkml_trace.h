#pragma once
#include <optional>
#include <string_view>
#include <vector>

namespace burin {

/// Decodes the points of an InkML trace, whose values may be absolute, first or second differences, channel
/// by channel.
class InkmlTrace {
 public:
  /// `channels`: how many a point may have, of which the first `regular` are in all points.
  InkmlTrace(std::string_view text, std::size_t channels, std::size_t regular);

  /// Reads the next point: a value for each channel, nothing for those that it lacks or that are unknown
  /// ("?"). Returns false after the last one. Throws Error for a text that is no point.
  bool next(std::vector<std::optional<double>>& point);

 private:
  enum class Kind { absolute, first_difference, second_difference };
  struct Channel {
    Kind kind = Kind::absolute;
    double value = 0, difference = 0, second = 0;
  };
  std::optional<double> take_value(Channel& channel);
  static double advance(Channel& channel, std::optional<double> number);

  std::string_view text_;
  std::vector<Channel> channels_;
  std::size_t regular_;
};

}  // namespace burin
