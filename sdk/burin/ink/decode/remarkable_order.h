#pragma once
#include <burin/ink/parse/remarkable_tagged.h>

#include <cstddef>
#include <vector>

namespace burin {

/// The items that an item lies between. An id of no item stands for an end of the list.
struct RemarkableNeighbours {
  RemarkableId own, left, right;
};

/// The order of items in which each follows its left neighbour and goes before its right one; where several
/// may come next, that with the lowest id. Items that wait for each other, as damaged files have them, come
/// last.
std::vector<std::size_t> order_of(const std::vector<RemarkableNeighbours>& items);

}  // namespace burin
