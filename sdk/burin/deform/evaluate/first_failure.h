#pragma once
#include <burin/chart/chart.h>

#include <atomic>
#include <cstddef>
#include <limits>
#include <mutex>
#include <string>
#include <string_view>

namespace burin {

/// The failure with the lowest element among those that several threads report.
class FirstFailure {
 public:
  /// Whether an element before `begin` has failed, so that elements from `begin` on need not be computed.
  bool lies_before(std::size_t begin) const { return element_.load(std::memory_order_relaxed) < begin; }

  void note(std::size_t element, std::string what);

  bool any() const { return element_ != none; }

  /// The lowest element that failed. Requires any().
  std::size_t element() const { return element_; }

  /// Throws ContractError "BRUSH: WHAT at t = T, d = D" for the failure, which occurred at this node of the
  /// chart.
  [[noreturn]] void throw_at(std::string_view brush, const Chart& chart, Index node) const;

 private:
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  std::atomic<std::size_t> element_{none};
  std::mutex mutex_;
  std::string what_;
};

}  // namespace burin
