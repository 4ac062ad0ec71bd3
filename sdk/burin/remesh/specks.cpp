// Removes small closed pieces of a patch: finds the pieces by union-find over the triangles, and the volume
// of each by the divergence theorem.
#include <burin/remesh/specks.h>

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

/// The lowest number of the vertices that each vertex hangs together with.
std::vector<Index> pieces(const PatchMesh& patch) {
  std::vector<Index> lowest(patch.positions.size());
  for (Index v = 0; v < lowest.size(); ++v) lowest[v] = v;
  const auto root = [&](Index v) {
    while (lowest[v] != v) v = lowest[v] = lowest[lowest[v]];
    return v;
  };
  for (const Triangle& t : patch.triangles)
    for (const std::size_t i : {1, 2}) {
      const Index first = root(t[0]), second = root(t[i]);
      lowest[std::max(first, second)] = std::min(first, second);
    }
  for (Index v = 0; v < lowest.size(); ++v) lowest[v] = root(v);
  return lowest;
}

struct Piece {
  double volume = 0;
  Vec3d areas = Vec3d::Zero();  ///< sum of the area vectors: 0 where it is closed
  double area = 0;
  bool fixed = false;
};

}  // namespace

void remove_specks(PatchMesh& patch, double volume) {
  const std::vector<Index> piece_of = pieces(patch);
  std::vector<Piece> of(patch.positions.size());
  for (const Triangle& t : patch.triangles) {
    Piece& piece = of[piece_of[t[0]]];
    const Vec3d origin = patch.positions[piece_of[t[0]]], a = patch.positions[t[0]] - origin,
                b = patch.positions[t[1]] - origin, c = patch.positions[t[2]] - origin;
    const Vec3d area = (b - a).cross(c - a);
    piece.volume += a.dot(b.cross(c)) / 6;
    piece.areas += area;
    piece.area += area.norm();
    piece.fixed = piece.fixed || patch.is_fixed(t[0]) || patch.is_fixed(t[1]) || patch.is_fixed(t[2]);
  }
  constexpr double closed = 1e-6;
  std::erase_if(patch.triangles, [&](const Triangle& t) {
    const Piece& piece = of[piece_of[t[0]]];
    return !piece.fixed && piece.areas.norm() <= closed * piece.area && std::abs(piece.volume) < volume;
  });
  patch = without_unused_vertices(patch);
}

}  // namespace burin
