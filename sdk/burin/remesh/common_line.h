#pragma once
#include <burin/remesh/border_loops.h>

#include <optional>

namespace burin {

/// A vertex of either of two closed polygons on the line that both run along.
struct OnLine {
  double along;  ///< arc length of the first polygon, object units
  bool of_first;
  std::size_t number;  ///< in its polygon
};

/// The vertices of both polygons in the order along the line; nothing where the second strays from the first
/// by more than the tolerance, object units, or turns back by more than it.
std::optional<std::vector<OnLine>> along_common_line(const std::vector<Vec3d>& first,
                                                     const std::vector<Vec3d>& second, double tolerance);

/// Two borders that run along the same line, in opposite directions.
struct LinePair {
  std::size_t first, second;  ///< numbers of the loops
  Loop turned;                ///< the second loop in the first's direction
  std::vector<OnLine> order;  ///< of the vertices of the first loop and of `turned`
};

/// Pairs of loops of two patches' borders that run along the same line; each loop is in one pair at most.
std::vector<LinePair> pair_lines(const PatchMesh& first, const std::vector<Loop>& first_loops,
                                 const PatchMesh& second, const std::vector<Loop>& second_loops,
                                 double tolerance);

}  // namespace burin
