// Counts each edge at both of its ends, by the lists of neighbours.
#include <burin/surface/topology/euler.h>

namespace burin {

long euler_characteristic(const Surface& surface) {
  long vertices = 0, ends = 0;
  for (Index v = 0; v < surface.vertex_count(); ++v) {
    if (!surface.incident[v].empty()) ++vertices;
    ends += static_cast<long>(surface.neighbours[v].size());
  }
  return vertices - ends / 2 + static_cast<long>(surface.triangles.size());
}

}  // namespace burin
