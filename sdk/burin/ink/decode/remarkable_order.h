#pragma once
#include <compare>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace burin {

/// Names an item of a page: who made it, and a count.
struct RemarkableId {
  std::uint8_t author = 0;
  std::uint64_t number = 0;
  auto operator<=>(const RemarkableId&) const = default;
};

/// The items that an item lies between. An id of no item stands for an end of the list.
struct RemarkableNeighbours {
  RemarkableId own, left, right;
};

/// The order of items in which each follows its left neighbour and goes before its right one; where several
/// may come next, that with the lowest id. Items that wait for each other, as damaged files have them, come
/// last.
std::vector<std::size_t> order_of(const std::vector<RemarkableNeighbours>& items);

}  // namespace burin
