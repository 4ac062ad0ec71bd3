#pragma once
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace burin {

/// The parts of a stroke event, in the order in which they follow each other.
enum class Stage : std::uint8_t {
  pick,      ///< ray or closest point to surface point
  curve,     ///< the stroke's curve drawn on to it
  chart,     ///< the chart extended
  evaluate,  ///< the brush over the changed nodes, its inputs filled
  blend,     ///< overlapping sheets made one displacement a vertex
  move,      ///< positions, normals, list of changed vertices
  record,    ///< undo step, surface and picker brought up to date; when a stroke ends or is undone
};
constexpr std::size_t stage_count = 7;
constexpr std::array<std::string_view, stage_count> stage_names = {"pick",  "curve", "chart", "evaluate",
                                                                   "blend", "move",  "record"};

/// What one call of a session cost. The counts are a function of surface and stroke alone.
struct EventCost {
  std::array<double, stage_count> seconds{};  ///< wall time, [Stage]
  std::uint64_t settled = 0;                  ///< chart nodes whose coordinates were computed
  std::uint64_t pushes = 0;                   ///< entries that went through the front's queue
  std::uint64_t evaluated = 0;                ///< chart nodes that the brush computed
  std::uint64_t moved = 0;                    ///< vertices that were given a new place

  EventCost& operator+=(const EventCost& other) {
    for (std::size_t stage = 0; stage < stage_count; ++stage) seconds[stage] += other.seconds[stage];
    settled += other.settled;
    pushes += other.pushes;
    evaluated += other.evaluated;
    moved += other.moved;
    return *this;
  }

  double total() const {
    double sum = 0;
    for (const double stage : seconds) sum += stage;
    return sum;
  }
};

/// Divides the time of a call among its stages: each lap is the time since the one before.
class StageClock {
 public:
  explicit StageClock(EventCost& cost) : cost_(&cost), last_(std::chrono::steady_clock::now()) {}

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
