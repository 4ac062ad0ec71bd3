#include <burin/deform/shown_surface.h>
#include <burin/surface/curvature.h>
#include <burin/surface/normals.h>

#include <cstddef>
#include <cstring>

namespace burin {
namespace {

/// Bits, not values: -0 and 0 must not be taken for each other, or results would depend on history.
bool same_bits(const Vec3f& a, const Vec3f& b) {
  return std::memcmp(a.data(), b.data(), 3 * sizeof(float)) == 0;
}

}  // namespace

ShownSurface::ShownSurface(const Surface& base)
    : positions_(base.positions), normals_(base.normals), dirty_(base.vertex_count()) {}

std::span<const Index> ShownSurface::move(const Surface& base, std::span<const Index> vertices,
                                          std::span<const Vec3f> places) {
  moved_.clear();
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (same_bits(positions_[vertices[i]], places[i])) continue;
    positions_[vertices[i]] = places[i];
    moved_.push_back(vertices[i]);
  }
  collect_with_neighbours(base, moved_);
  update_normals(base, positions_, changed_, normals_);
  return changed_;
}

std::vector<Index> ShownSurface::displaced_among(const Surface& base, std::span<const Index> vertices) const {
  std::vector<Index> displaced;
  for (const Index vertex : vertices) {
    if (!displaced.empty() && displaced.back() == vertex) continue;
    if (!same_bits(positions_[vertex], base.positions[vertex])) displaced.push_back(vertex);
  }
  return displaced;
}

void ShownSurface::commit(Surface& base, std::span<const Index> vertices) {
  collect_with_neighbours(base, vertices);
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
