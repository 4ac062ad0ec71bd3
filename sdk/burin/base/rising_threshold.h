#pragma once
#include <burin/base/vector.h>

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace burin {

/// Which of many slots have a value of at least a threshold that mostly rises, at a cost in proportion to
/// these and to the slots whose values change. Where it falls all slots are looked at.
class RisingThreshold {
 public:
  /// `slack`: by how much the threshold may fall from one call to the next for nothing.
  explicit RisingThreshold(double slack) : slack_(slack) {}

  /// The slots below `count` that have a value(slot) of `threshold` or more, and some others. `changed` names
  /// at least all whose values changed since the last call. Valid until the next call.
  template <class Value>
  std::span<const Index> find(double threshold, std::span<const Index> changed, Index count,
                              const Value& value) {
    listed_.resize(count);
    const bool falls = threshold < from_;
    from_ = threshold - slack_;
    std::size_t kept = 0;
    for (const Index slot : slots_) {
      listed_[slot] = !falls && value(slot) >= from_;
      if (listed_[slot]) slots_[kept++] = slot;
    }
    slots_.resize(kept);
    const auto add = [&](Index slot) {
      if (listed_[slot] || !(value(slot) >= from_)) return;
      listed_[slot] = 1;
      slots_.push_back(slot);
    };
    if (falls)
      for (Index slot = 0; slot < count; ++slot) add(slot);
    else
      for (const Index slot : changed) add(slot);
    return slots_;
  }

 private:
  double slack_;
  double from_ = -std::numeric_limits<double>::infinity();  ///< all slots from here on are listed
  std::vector<Index> slots_;
  std::vector<std::uint8_t> listed_;  ///< [slot]
};

}  // namespace burin
