// Finds the border of a patch as loops: sides without a neighbour, followed from vertex to vertex.
#include <burin/base/error.h>
#include <burin/remesh/border_loops.h>

namespace burin {

std::map<Side, std::size_t> border_sides(const std::vector<Triangle>& triangles) {
  std::map<Side, std::size_t> sides;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const Side side{triangles[t][i], triangles[t][(i + 1) % 3]};
      if (const auto other = sides.find({side.second, side.first}); other != sides.end())
        sides.erase(other);
      else
        sides.emplace(side, t);
    }
  return sides;
}

std::vector<Loop> border_loops(const PatchMesh& patch) {
  std::map<Index, Index> next;
  for (const auto& [side, triangle] : border_sides(patch.triangles)) {
    if (patch.is_fixed(side.first) || patch.is_fixed(side.second)) continue;
    if (!next.emplace(side.first, side.second).second) throw Error("the border of a patch touches itself");
  }
  std::vector<Loop> loops;
  while (!next.empty()) {
    Loop& loop = loops.emplace_back();
    Index vertex = next.begin()->first;
    for (auto at = next.begin(); at != next.end(); at = next.find(vertex)) {
      loop.push_back(vertex);
      vertex = at->second;
      next.erase(at);
    }
  }
  return loops;
}

}  // namespace burin
