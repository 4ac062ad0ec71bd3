#pragma once
#include <burin/deform/blend/sheet.h>

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

namespace burin {

/// The sheets of the finished pieces of a stroke, which falls into pieces where the pen leaves the surface.
/// All start from the surface before the stroke. Costs what the pieces cover.
class EarlierPieces {
 public:
  /// Adds a finished piece: the sheets of its instances. `radius`: of the stroke, object units.
  void add(std::span<const InstanceSheets> instances, double radius);

  /// How many there are.
  std::uint32_t count() const { return count_; }

  /// Piece by piece. Valid until the next is added.
  std::span<const Sheet> at(Index vertex) const;

 private:
  std::unordered_map<Index, std::vector<Sheet>> sheets_;
  std::uint32_t count_ = 0;
};

}  // namespace burin
