#pragma once
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace burin {

/// The stages of a stroke event, in order.
enum class Stage : std::uint8_t {
  pick,      ///< finds the surface point of the ray or position
  curve,     ///< extends the stroke's curve
  chart,     ///< extends the chart
  evaluate,  ///< fills the inputs of changed nodes and runs the brush
  blend,     ///< combines the sheets of each vertex to one displacement
  move,      ///< updates shown positions and normals, and the list of changed vertices
  record,    ///< updates undo journal, surface and picker when a stroke ends or is undone
};
constexpr std::size_t stage_count = 7;
constexpr std::array<std::string_view, stage_count> stage_names = {"pick",  "curve", "chart", "evaluate",
                                                                   "blend", "move",  "record"};

/// The cost of one call of a session. The counts depend on surface and stroke alone.
struct EventCost {
  std::array<double, stage_count> seconds{};  ///< [Stage] wall time, seconds
  std::uint64_t settled = 0;                  ///< number of chart nodes whose coordinates were computed
  std::uint64_t pushes = 0;                   ///< number of entries pushed to the front's queue
  std::uint64_t evaluated = 0;                ///< number of chart nodes that the brush computed
  std::uint64_t moved = 0;                    ///< number of vertices whose position was computed

  EventCost& operator+=(const EventCost& other) {
    for (std::size_t stage = 0; stage < stage_count; ++stage) seconds[stage] += other.seconds[stage];
    settled += other.settled;
    pushes += other.pushes;
    evaluated += other.evaluated;
    moved += other.moved;
    return *this;
  }

  double total() const {  ///< seconds of all stages
    double sum = 0;
    for (const double stage : seconds) sum += stage;
    return sum;
  }
};

/// Measures the stages of a call: lap() adds the time since the previous lap(), or since construction, to a
/// stage.
class StageClock {
 public:
  explicit StageClock(EventCost& cost) : cost_(&cost), last_(std::chrono::steady_clock::now()) {}  ///< starts
  /// Ends a stage.
  void lap(Stage stage) {
    const auto now = std::chrono::steady_clock::now();
    cost_->seconds[static_cast<std::size_t>(stage)] += std::chrono::duration<double>(now - last_).count();
    last_ = now;
  }

 private:
  EventCost* cost_;
  std::chrono::steady_clock::time_point last_;
};

}  // namespace burin
