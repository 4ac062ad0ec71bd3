// Walks around a vertex from face to face, counter-clockwise, and from a border clockwise, too.
#include <burin/refine/vertex_fan.h>

#include <algorithm>

namespace burin {
namespace {

enum class Way { on, border, crowd };

/// Whether a vertex's fan goes on across a side; `across`: that of the next face.
Way way_across(const RegionMesh& mesh, Side side, Side& across) {
  if (mesh.next(side) == side) return Way::border;
  across = mesh.twin(side);
  return across != no_index && mesh.from(across) == mesh.to(side) ? Way::on : Way::crowd;
}

/// Goes on clockwise from a face that begins at a border or in the middle; puts what it finds before it.
bool find_before(RegionMesh& mesh, VertexFan& fan) {
  std::vector<Side> found;
  for (Side side = fan.leaving.front(), across = no_index;;) {
    const Way way = way_across(mesh, side, across);
    if (way == Way::crowd) return false;
    if (way == Way::border) break;
    side = RegionMesh::after(across);
    mesh.connect(side / 3);
    found.push_back(side);
  }
  std::ranges::reverse(found);
  fan.leaving.insert(fan.leaving.begin(), found.begin(), found.end());
  return true;
}

}  // namespace

bool find_fan(RegionMesh& mesh, Side side, VertexFan& fan) {
  fan.leaving.clear();
  fan.closed = false;
  if (mesh.vertices()[mesh.from(side)].is_crowded) return false;
  for (Side leaving = side;;) {
    mesh.connect(leaving / 3);
    fan.leaving.push_back(leaving);
    Side across = no_index;
    const Way way = way_across(mesh, RegionMesh::before(leaving), across);
    if (way == Way::crowd) return false;
    if (way == Way::border) return find_before(mesh, fan);
    fan.closed = across == side;
    if (fan.closed) return true;
    leaving = across;
  }
}

}  // namespace burin
