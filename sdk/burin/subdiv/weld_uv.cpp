// Finds equal texture coordinates at a vertex by sorting.
#include <burin/subdiv/weld_uv.h>
#include <burin/surface/topology/weld.h>

#include <bit>

namespace burin {

WeldedUv weld_uv(const PolygonMesh& cage) {
  std::vector<Vec3f> places(cage.corner_uv.size());  // the vertex number's bits as a float, u, v
  for (std::size_t corner = 0; corner < places.size(); ++corner) {
    const Vec2f& uv = cage.corner_uv[corner];
    places[corner] = {std::bit_cast<float>(cage.face_vertices[corner]), uv.x(), uv.y()};
  }
  const std::vector<Index> first = first_at_position(places);
  WeldedUv welded;
  welded.corners.resize(first.size());
  for (Index corner = 0; corner < first.size(); ++corner) {
    if (first[corner] == corner) {
      welded.corners[corner] = static_cast<Index>(welded.values.size());
      welded.values.push_back(cage.corner_uv[corner]);
    } else {
      welded.corners[corner] = welded.corners[first[corner]];
    }
  }
  return welded;
}

}  // namespace burin
