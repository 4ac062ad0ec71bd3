// Orders items by the neighbours that they name: a topological sort.
#include <burin/ink/decode/remarkable_order.h>

#include <map>
#include <set>
#include <utility>

namespace burin {
namespace {

/// What waits for what, by places in the list of items.
struct Waiting {
  std::vector<std::vector<std::size_t>> followers;
  std::vector<std::size_t> before;  ///< how many must come first
};

Waiting waiting_of(const std::vector<RemarkableNeighbours>& items) {
  std::map<RemarkableId, std::size_t> place_of;
  for (std::size_t i = 0; i < items.size(); ++i) place_of.emplace(items[i].own, i);
  Waiting waiting{std::vector<std::vector<std::size_t>>(items.size()),
                  std::vector<std::size_t>(items.size())};
  const auto add = [&](std::size_t first, std::size_t second) {
    waiting.followers[first].push_back(second);
    ++waiting.before[second];
  };
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (const auto left = place_of.find(items[i].left); left != place_of.end()) add(left->second, i);
    if (const auto right = place_of.find(items[i].right); right != place_of.end()) add(i, right->second);
  }
  return waiting;
}

}  // namespace

std::vector<std::size_t> order_of(const std::vector<RemarkableNeighbours>& items) {
  Waiting waiting = waiting_of(items);
  std::set<std::pair<RemarkableId, std::size_t>> ready;
  for (std::size_t i = 0; i < items.size(); ++i)
    if (waiting.before[i] == 0) ready.emplace(items[i].own, i);
  std::vector<std::size_t> order;
  while (!ready.empty()) {
    const std::size_t next = ready.extract(ready.begin()).value().second;
    order.push_back(next);
    for (const std::size_t follower : waiting.followers[next])
      if (--waiting.before[follower] == 0) ready.emplace(items[follower].own, follower);
  }
  for (std::size_t i = 0; i < items.size(); ++i)
    if (waiting.before[i] != 0) order.push_back(i);
  return order;
}

}  // namespace burin
