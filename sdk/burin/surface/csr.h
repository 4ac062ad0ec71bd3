#pragma once
#include <burin/base/unset_vector.h>
#include <burin/base/vector.h>

#include <span>
#include <vector>

namespace burin {

/// Lists of indices in compressed rows: row i is items[offsets[i] .. offsets[i + 1]).
struct Csr {
  std::vector<Index> offsets;
  UnsetVector<Index> items;

  /// The entries of a row.
  std::span<const Index> operator[](Index row) const {
    return {items.data() + offsets[row], items.data() + offsets[row + 1]};
  }
  Index rows() const { return offsets.empty() ? 0 : static_cast<Index>(offsets.size() - 1); }
};

}  // namespace burin
