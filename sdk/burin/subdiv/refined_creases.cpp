// Follows edges from level to level: each becomes two, which meet at the vertex of the edge.
#include <burin/subdiv/refined_creases.h>
#include <burin/subdiv/refined_topology.h>

#include <algorithm>

namespace burin {

std::vector<std::array<Index, 2>> refined_creases(const PolygonMesh& cage, SubdivisionScheme scheme,
                                                  int level) {
  std::vector<std::array<Index, 2>> edges;
  for (const CreaseEdge& crease : cage.creases)
    if (crease.sharpness > 0) edges.push_back({crease.a, crease.b});
  if (level > 0 && !edges.empty()) {
    const auto refiner = refined_topology(cage, scheme, level);
    for (int i = 0; i < level; ++i) {
      const TopologyLevel& coarse = refiner->GetLevel(i);
      std::vector<std::array<Index, 2>> finer;
      for (const auto& [a, b] : edges) {
        const int from = static_cast<int>(a), to = static_cast<int>(b);
        const auto middle = static_cast<Index>(coarse.GetEdgeChildVertex(coarse.FindEdge(from, to)));
        finer.push_back({static_cast<Index>(coarse.GetVertexChildVertex(from)), middle});
        finer.push_back({middle, static_cast<Index>(coarse.GetVertexChildVertex(to))});
      }
      edges.swap(finer);
    }
  }
  for (auto& [a, b] : edges)
    if (a > b) std::swap(a, b);
  std::ranges::sort(edges);
  return edges;
}

}  // namespace burin
