#pragma once
#include <burin/base/vector.h>

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace burin {

/// Eight boxes side by side, so that a query computes what it asks of each in lanes. Boxes that were never
/// set are empty: their lower bounds are above all numbers and their upper bounds below.
class BoxLanes {
 public:
  static constexpr std::size_t count = 8;
  using Lane = Eigen::Array<float, static_cast<int>(count), 1>;
  using Box = Eigen::AlignedBox3f;

  BoxLanes() {
    low_.fill(Lane::Constant(std::numeric_limits<float>::max()));
    high_.fill(Lane::Constant(std::numeric_limits<float>::lowest()));
  }

  void set(std::size_t lane, const Box& box) {
    const auto at = static_cast<Eigen::Index>(lane);
    for (int axis = 0; axis < 3; ++axis) {
      low(axis)[at] = box.min()[axis];
      high(axis)[at] = box.max()[axis];
    }
  }

  Box box(std::size_t lane) const {
    const auto at = static_cast<Eigen::Index>(lane);
    return {Vec3f(low_[0][at], low_[1][at], low_[2][at]), Vec3f(high_[0][at], high_[1][at], high_[2][at])};
  }

  /// The box around all.
  Box whole() const {
    Box box;
    for (int axis = 0; axis < 3; ++axis) {
      box.min()[axis] = low(axis).minCoeff();
      box.max()[axis] = high(axis).maxCoeff();
    }
    return box;
  }

  /// The bounds of the boxes along an axis.
  const Lane& low(int axis) const { return low_[static_cast<std::size_t>(axis)]; }
  const Lane& high(int axis) const { return high_[static_cast<std::size_t>(axis)]; }

 private:
  Lane& low(int axis) { return low_[static_cast<std::size_t>(axis)]; }
  Lane& high(int axis) { return high_[static_cast<std::size_t>(axis)]; }

  std::array<Lane, 3> low_, high_;
};

/// Boxes one after the other, in lanes. Different ones may be set on different threads, if these are not of
/// the same run of eight.
class LanedBoxes {
 public:
  using Box = BoxLanes::Box;

  LanedBoxes() = default;
  /// Empty boxes.
  explicit LanedBoxes(std::size_t size)
      : size_(size), runs_((size + BoxLanes::count - 1) / BoxLanes::count) {}

  std::size_t size() const { return size_; }
  Box operator[](std::size_t i) const { return runs_[i / BoxLanes::count].box(i % BoxLanes::count); }
  void set(std::size_t i, const Box& box) { runs_[i / BoxLanes::count].set(i % BoxLanes::count, box); }
  void push_back(const Box& box) {
    if (size_ % BoxLanes::count == 0) runs_.emplace_back();
    set(size_++, box);
  }

  /// The boxes from number 8 i on.
  const BoxLanes& run(std::size_t i) const { return runs_[i]; }

  /// The box around all.
  Box whole() const {
    Box whole;
    for (const BoxLanes& run : runs_) whole.extend(run.whole());
    return whole;
  }

 private:
  std::size_t size_ = 0;
  std::vector<BoxLanes> runs_;
};

/// Lower bounds of the squared distances from a position to boxes, up to 1e-6 of them too small. Numbers that
/// floats cannot hold are the largest one.
inline BoxLanes::Lane squared_distances(const BoxLanes& boxes, const Vec3f& position) {
  BoxLanes::Lane sum = BoxLanes::Lane::Zero();
  for (int axis = 0; axis < 3; ++axis)
    sum += (boxes.low(axis) - position[axis]).max(position[axis] - boxes.high(axis)).max(0.F).square();
  return ((1 - 1e-6F) * sum).min(std::numeric_limits<float>::max());
}

}  // namespace burin
