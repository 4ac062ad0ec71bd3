// Moves shown vertices and computes the normals of these and of their neighbours again; after the stroke also
// the Gauss curvature of the neighbours' neighbours.
#include <burin/deform/shown/same_bits.h>
#include <burin/deform/shown/shown_surface.h>
#include <burin/surface/geometry/curvature.h>
#include <burin/surface/geometry/normals.h>

#include <cstddef>

namespace burin {

ShownSurface::ShownSurface(const Surface& base)
    : positions_(base.positions),
      normals_(base.normals),
      touched_(base.vertex_count()),
      dirty_(base.vertex_count()) {}

std::span<const Index> ShownSurface::move(const Surface& base, std::span<const Index> vertices,
                                          std::span<const Vec3f> positions) {
  moved_.clear();
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (same_bits(positions_[vertices[i]], positions[i])) continue;
    positions_[vertices[i]] = positions[i];
    moved_.push_back(vertices[i]);
    touched_.insert(vertices[i]);
  }
  collect_with_neighbours(base, moved_);
  update_normals(base, positions_, changed_, normals_);
  return changed_;
}

std::vector<Index> ShownSurface::take_displaced(const Surface& base) {
  std::vector<Index> vertices;
  touched_.drain(vertices);
  std::erase_if(vertices, [&](Index v) { return same_bits(positions_[v], base.positions[v]); });
  return vertices;
}

std::vector<Index> ShownSurface::displaced(const Surface& base) {
  std::vector<Index> vertices = take_displaced(base);
  for (const Index vertex : vertices) touched_.insert(vertex);
  return vertices;
}

void ShownSurface::commit(Surface& base, std::span<const Index> vertices) {
  collect_with_neighbours(base, vertices);
  touched_.drain(moved_);
  for (const Index vertex : vertices) base.positions[vertex] = positions_[vertex];
  for (const Index vertex : changed_) base.normals[vertex] = normals_[vertex];
  // A vertex's curvature depends on the normals of its neighbours.
  moved_ = changed_;
  collect_with_neighbours(base, moved_);
  update_gauss_curvature(base, changed_);
}

void ShownSurface::collect_with_neighbours(const Surface& base, std::span<const Index> vertices) {
  for (const Index vertex : vertices) {
    dirty_.insert(vertex);
    for (const Index neighbour : base.neighbours[vertex]) dirty_.insert(neighbour);
  }
  dirty_.drain(changed_);
}

}  // namespace burin
