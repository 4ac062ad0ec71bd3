#include <burin/base/parallel.h>
#include <burin/surface/connect_surface.h>
#include <burin/surface/geometry/curvature.h>
#include <burin/surface/geometry/normals.h>
#include <burin/surface/topology/adjacency.h>

namespace burin {
namespace {

void compute_all_normals(Surface& surface) {
  surface.normals.resize(surface.positions.size());
  parallel_blocks(surface.positions.size(), 16384, [&](std::size_t begin, std::size_t end) {
    for (Index vertex = static_cast<Index>(begin); vertex < end; ++vertex)
      surface.normals[vertex] = vertex_normal(surface, surface.positions, vertex);
  });
}

}  // namespace

void connect_surface(Surface& surface, const Progress& progress, double done) {
  report(progress, "connecting the surface", done);
  surface.incident = incident_triangles(surface.positions.size(), surface.triangles);
  surface.neighbours = neighbour_vertices(surface.triangles, surface.incident);
  report(progress, "computing normals", done + (1 - done) / 2);
  compute_all_normals(surface);
  compute_gauss_curvature(surface);
  report(progress, "computing normals", 1);
}

}  // namespace burin
