// Keeps the lowest failing element, so that the message does not depend on the order of threads.
#include <burin/base/error.h>
#include <burin/deform/evaluate/first_failure.h>
#include <fmt/format.h>

#include <utility>

namespace burin {

void FirstFailure::note(std::size_t element, std::string what) {
  const std::lock_guard lock(mutex_);
  if (element >= element_.load(std::memory_order_relaxed)) return;
  element_.store(element, std::memory_order_relaxed);
  what_ = std::move(what);
}

void FirstFailure::throw_at(std::string_view brush, const Chart& chart, Index node) const {
  throw ContractError(
      fmt::format("{}: {} at t = {:.6g}, d = {:.6g}", brush, what_, chart.t[node], chart.d[node]));
}

}  // namespace burin
