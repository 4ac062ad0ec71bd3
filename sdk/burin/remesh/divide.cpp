// Divides a patch along a line of zeros of a field: finds the zeros on its edges by regula falsi, splits the
// edges there, and chooses the triangles on the positive side.
#include <burin/remesh/divide.h>
#include <burin/remesh/edge_mesh.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace burin {
namespace {

/// Where the field is 0 between two points of different signs, as a share of the way: regula falsi in the
/// Illinois variant [M. Dowell and P. Jarratt, A modified regula falsi method, 1971].
double crossing(const PointField& field, const Vec3d& from, const Vec3d& to, double at_from, double at_to) {
  double low = 0, high = 1, at_low = at_from, at_high = at_to;
  constexpr int most = 40;
  constexpr double close = 1e-10;
  int moved = 0;  // which end the last step moved: -1 the lower, 1 the higher one
  double share = 0, last = 1;
  for (int i = 0; i < most && std::abs(share - last) > close; ++i) {
    last = std::exchange(share, (low * at_high - high * at_low) / (at_high - at_low));
    const double value = field(from + share * (to - from));
    if (value == 0) break;
    if ((value > 0) == (at_from > 0)) {
      low = share;
      at_low = value;
      if (moved == -1) at_high /= 2;
      moved = -1;
    } else {
      high = share;
      at_high = value;
      if (moved == 1) at_low /= 2;
      moved = 1;
    }
  }
  return share;
}

/// Splits the edges on which the field changes its sign. Returns the field at the vertices.
std::vector<double> split_edges(EdgeMesh& mesh, const PointField& field, const BringPoint& bring) {
  std::vector<double> value;
  for (const auto vertex : mesh.vertices()) value.push_back(field(mesh.data(vertex).position));
  const auto at = [&](EdgeMesh::VertexHandle vertex) {
    return value[static_cast<std::size_t>(vertex.idx())];
  };
  // Only edges that were there before have ends of different signs: new ones end at the line.
  const std::size_t edges = mesh.n_edges();
  for (std::size_t e = 0; e < edges; ++e) {
    const EdgeMesh::EdgeHandle edge(static_cast<int>(e));
    const auto half = mesh.halfedge_handle(edge, 0);
    const auto from = mesh.from_vertex_handle(half), to = mesh.to_vertex_handle(half);
    if (!(at(from) > 0 && at(to) < 0) && !(at(from) < 0 && at(to) > 0)) continue;
    const Vec3d start = mesh.data(from).position, way = mesh.data(to).position - start;
    const double share = crossing(field, start, start + way, at(from), at(to));
    mesh.split(edge, add_vertex(mesh, bring(start + share * way)));
    value.push_back(0);
  }
  return value;
}

}  // namespace

std::vector<double> cut(PatchMesh& patch, const PointField& field, const BringPoint& bring) {
  EdgeMesh mesh = to_edges(patch);
  std::vector<double> value = split_edges(mesh, field, bring);
  patch = to_patch(mesh);
  return value;
}

DividedPatch divide(PatchMesh patch, const PointField& field, const BringPoint& bring) {
  DividedPatch divided;
  divided.field = cut(patch, field, bring);
  for (const Triangle& t : patch.triangles)
    divided.kept.push_back(std::ranges::all_of(t, [&](Index v) { return divided.field[v] >= 0; }));
  divided.patch = std::move(patch);
  return divided;
}

std::vector<Triangle> kept_triangles(const DividedPatch& divided) {
  std::vector<Triangle> kept;
  for (std::size_t t = 0; t < divided.kept.size(); ++t)
    if (divided.kept[t]) kept.push_back(divided.patch.triangles[t]);
  return kept;
}

PatchMesh kept_part(const DividedPatch& divided) {
  return without_unused_vertices({divided.patch.positions, kept_triangles(divided), divided.patch.kept});
}

}  // namespace burin
