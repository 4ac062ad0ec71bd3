// The difference of two lists as multisets: both are sorted, and passed in step.
#include <burin/base/parallel.h>
#include <burin/host/c/told_triangles.h>

#include <algorithm>
#include <compare>
#include <cstddef>
#include <utility>

namespace burin::c {
namespace {

struct Numbered {
  Triangle triangle;
  Index number;  ///< in its list

  auto operator<=>(const Numbered&) const = default;
};

std::vector<Numbered> sorted(const std::vector<Triangle>& triangles) {
  std::vector<Numbered> all;
  all.reserve(triangles.size());
  for (const Triangle& triangle : triangles) all.push_back({triangle, static_cast<Index>(all.size())});
  parallel_sort(all.begin(), all.end());
  return all;
}

}  // namespace

void ToldTriangles::update(const std::vector<Triangle>& now) {
  const std::vector<Numbered> before = sorted(list_), after = sorted(now);
  std::vector<Index> fresh;
  removed_.clear();
  for (std::size_t i = 0, k = 0; i < before.size() || k < after.size();) {
    const bool ended = i == before.size();
    if (!ended && (k == after.size() || before[i].triangle < after[k].triangle))
      removed_.push_back(before[i++].number);
    else if (ended || after[k].triangle < before[i].triangle)
      fresh.push_back(after[k++].number);
    else
      ++i, ++k;
  }
  std::ranges::sort(removed_);
  std::ranges::sort(fresh);
  added_.clear();
  for (const Index number : fresh) added_.push_back(now[number]);
  auto next = removed_.begin();
  Index number = 0;
  std::erase_if(list_, [&](const Triangle&) {
    const bool gone = next != removed_.end() && *next == number++;
    next += gone;
    return gone;
  });
  list_.insert(list_.end(), added_.begin(), added_.end());
}

}  // namespace burin::c
