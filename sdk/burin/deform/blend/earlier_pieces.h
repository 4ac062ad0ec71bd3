#pragma once
#include <burin/deform/blend/sheet.h>

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

namespace burin {

/// The sheets of the finished pieces of a stroke. A stroke has several pieces if the pen leaves the surface
/// and returns. All pieces start from the surface before the stroke. Memory is proportional to the nodes of
/// the pieces.
class EarlierPieces {
 public:
  /// Adds a finished piece: the sheets of its instances. `radius` is that of the stroke, object units.
  void add(std::span<const InstanceSheets> instances, double radius);

  /// The number of pieces.
  std::uint32_t count() const { return count_; }

  /// The sheets of a vertex, piece by piece. Valid until the next piece is added.
  std::span<const Sheet> at(Index vertex) const;

 private:
  std::unordered_map<Index, std::vector<Sheet>> sheets_;
  std::uint32_t count_ = 0;
};

}  // namespace burin
