// Checks the topology of a cage by the faces around each vertex, in O(corners).
#include <burin/base/error.h>
#include <burin/subdiv/check_cage.h>
#include <burin/surface/csr.h>
#include <burin/surface/topology/vertex_star.h>
#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace burin {
namespace {

/// The index of each face's first corner in face_vertices, followed by the number of corners.
std::vector<Index> face_offsets(const PolygonMesh& cage) {
  std::vector<Index> offsets(cage.face_sizes.size() + 1, 0);
  std::inclusive_scan(cage.face_sizes.begin(), cage.face_sizes.end(), offsets.begin() + 1);
  return offsets;
}

void check_corners(const PolygonMesh& cage, const std::vector<Index>& offsets) {
  std::vector<Index> last_face(cage.positions.size(), no_index);
  for (Index face = 0; face < cage.face_sizes.size(); ++face)
    for (Index corner = offsets[face]; corner < offsets[face + 1]; ++corner) {
      const Index vertex = cage.face_vertices[corner];
      if (last_face[vertex] == face)
        throw Error(fmt::format("face {} names vertex {} twice", face + 1, vertex + 1));
      last_face[vertex] = face;
    }
}

Csr incident_faces(const PolygonMesh& cage, const std::vector<Index>& face_begin) {
  Csr incident;
  incident.offsets.assign(cage.positions.size() + 1, 0);
  for (const Index vertex : cage.face_vertices) ++incident.offsets[vertex + 1];
  std::inclusive_scan(incident.offsets.begin(), incident.offsets.end(), incident.offsets.begin());
  incident.items.resize(incident.offsets.back());
  std::vector<Index> next = incident.offsets;
  for (Index face = 0; face < cage.face_sizes.size(); ++face)
    for (Index corner = face_begin[face]; corner < face_begin[face + 1]; ++corner)
      incident.items[next[cage.face_vertices[corner]]++] = face;
  return incident;
}

/// Finds the faces around a vertex of a cage.
class CageStars {
 public:
  CageStars(const PolygonMesh& cage, std::vector<Index> face_begin)
      : cage_(cage), face_begin_(std::move(face_begin)), incident_(incident_faces(cage, face_begin_)) {}

  /// Valid until the next call.
  const VertexStar& around(Index vertex) {
    star_.clear();
    for (const Index face : incident_[vertex]) {
      const Index size = cage_.face_sizes[face];
      const Index* corners = cage_.face_vertices.data() + face_begin_[face];
      const auto at = static_cast<Index>(std::find(corners, corners + size, vertex) - corners);
      star_.add(face, corners[(at + size - 1) % size], corners[(at + 1) % size]);
    }
    star_.connect();
    return star_;
  }

 private:
  const PolygonMesh& cage_;
  std::vector<Index> face_begin_;
  Csr incident_;
  VertexStar star_;
};

void check_star(Index vertex, const VertexStar& star) {
  for (const StarEdge& edge : star.edges()) {
    if (edge.faces() > 2)
      throw Error(
          fmt::format("the cage is not a manifold: {} faces meet at the edge between vertices {} and {}",
                      edge.faces(), vertex + 1, edge.other + 1));
    if (edge.flipped())
      throw Error(
          fmt::format("faces {} and {} disagree on the outside at the edge between vertices {} and {}",
                      edge.face + 1, edge.other_face + 1, vertex + 1, edge.other + 1));
  }
  if (star.fans() > 1)
    throw Error(fmt::format(
        "the cage is not a manifold: {} separate fans of faces touch at vertex {}, face {} in one",
        star.fans(), vertex + 1, star.edges().front().face + 1));
}

}  // namespace

void check_cage(const PolygonMesh& cage) {
  std::vector<Index> face_begin = face_offsets(cage);
  check_corners(cage, face_begin);
  CageStars stars(cage, std::move(face_begin));
  for (Index vertex = 0; vertex < cage.positions.size(); ++vertex) check_star(vertex, stars.around(vertex));
  for (const CreaseEdge& crease : cage.creases)
    if (std::ranges::none_of(stars.around(crease.a).edges(),
                             [&](const StarEdge& edge) { return edge.other == crease.b; }))
      throw Error(
          fmt::format("the crease between vertices {} and {} is not on an edge", crease.a + 1, crease.b + 1));
}

}  // namespace burin
