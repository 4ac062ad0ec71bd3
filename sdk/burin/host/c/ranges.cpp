#include <burin/host/c/ranges.h>

#include <algorithm>
#include <numeric>

namespace burin::c {

std::vector<burin_range> Ranges::at_most(std::size_t most) const {
  if (ranges_.size() <= most) return ranges_;
  // Numbers of the ranges before which there is a gap; the widest gaps stay.
  std::vector<std::size_t> opens(ranges_.size() - 1);
  std::iota(opens.begin(), opens.end(), std::size_t{1});
  const auto width = [this](std::size_t i) { return ranges_[i].begin - ranges_[i - 1].end; };
  std::ranges::stable_sort(opens, std::greater<>(), width);
  opens.resize(most - 1);
  std::ranges::sort(opens);
  std::vector<burin_range> joined{ranges_.front()};
  for (const std::size_t i : opens) {
    joined.back().end = ranges_[i - 1].end;
    joined.push_back(ranges_[i]);
  }
  joined.back().end = ranges_.back().end;
  return joined;
}

}  // namespace burin::c
