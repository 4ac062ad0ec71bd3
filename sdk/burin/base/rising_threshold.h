#pragma once
#include <burin/base/vector.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace burin {

/// Lists the slots whose value is at least a threshold, for a threshold that mostly rises. A call costs
/// O(listed + changed) slots. When the threshold falls by more than the slack, a call visits all slots.
class RisingThreshold {
 public:
  /// `slack`: how far the threshold may fall from one call to the next without a visit to all slots.
  explicit RisingThreshold(double slack) : slack_(slack) {}

  /// Returns all slots below `count` whose value(slot) is `threshold` or more, and perhaps some within the
  /// slack below it. `changed` must contain all slots whose values changed since the last call, new slots
  /// included. The span is valid until the next call.
  template <class Value>
  std::span<const Index> find(double threshold, std::span<const Index> changed, Index count,
                              const Value& value) {
    listed_.resize(count);
    const bool falls = threshold < from_;
    from_ = falls ? threshold - slack_ : std::max(from_, threshold - slack_);
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
  double from_ = -std::numeric_limits<double>::infinity();  ///< all slots with at least this value are listed
  std::vector<Index> slots_;
  std::vector<std::uint8_t> listed_;  ///< [slot]
};

}  // namespace burin
