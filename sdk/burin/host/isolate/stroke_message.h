#pragma once
#include <burin/abi/ext/curve_filter.h>
#include <burin/abi/param.h>
#include <burin/host/isolate/message.h>

#include <array>
#include <deque>
#include <string>
#include <vector>

namespace burin::isolate {

/// What a brush offers besides evaluation: bits of the answer to Request::create.
enum : std::uint32_t { offers_state = 1, offers_curve_filter = 2, offers_volume = 4 };

/// Appends the values of all parameters as begin() gets them: numbers have stride 0.
void write_params(MessageWriter& to, const burin_params& params);

/// Parameters that came in a message, with all that they point to.
class ReceivedParams {
 public:
  explicit ReceivedParams(MessageReader& from);
  ReceivedParams(const ReceivedParams&) = delete;
  ReceivedParams& operator=(const ReceivedParams&) = delete;

  const burin_params& abi() const { return params_; }

 private:
  std::deque<std::array<float, 5>> numbers_;  ///< number and colour of each
  std::deque<std::string> texts_;
  std::deque<std::vector<float>> knots_;
  std::vector<burin_param_value> values_;
  burin_params params_{};
};

/// Appends the points of a curve: columns of t, position, normal and e1.
void write_points(MessageWriter& to, const burin_curve_points& points);

/// Points that came in a message.
class ReceivedPoints {
 public:
  explicit ReceivedPoints(MessageReader& from);
  ReceivedPoints(const ReceivedPoints&) = delete;
  ReceivedPoints& operator=(const ReceivedPoints&) = delete;

  const burin_curve_points& abi() const { return points_; }

 private:
  std::array<std::vector<float>, 10> columns_;
  burin_curve_points points_{};
};

}  // namespace burin::isolate
