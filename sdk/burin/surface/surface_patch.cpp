// Makes a surface of the triangles that stay and those of a patch, with its vertices numbered in the order of
// the source.
#include <burin/surface/surface_patch.h>

#include <algorithm>
#include <utility>

namespace burin {
namespace {

/// The values of the surface's triangles that stay, then those of the new ones.
template <class Value>
std::vector<Value> kept_then_new(const std::vector<Value>& old, const std::vector<Index>& removed,
                                 const std::vector<Value>& fresh) {
  std::vector<Value> all;
  all.reserve(old.size() - removed.size() + fresh.size());
  auto next = removed.begin();
  for (Index t = 0; t < old.size(); ++t) {
    if (next != removed.end() && *next == t)
      ++next;
    else
      all.push_back(old[t]);
  }
  all.insert(all.end(), fresh.begin(), fresh.end());
  return all;
}

/// Old and new vertices in the order of the source, without those that had triangles and have none now.
std::vector<Index> vertices_left(const Surface& surface, const SurfacePatch& patch,
                                 const std::vector<Triangle>& triangles) {
  const std::size_t count = surface.vertex_count() + patch.positions.size();
  std::vector<bool> used(count, false);
  for (const Triangle& triangle : triangles)
    for (const Index vertex : triangle) used[vertex] = true;
  std::vector<Index> order(surface.vertex_count());
  for (Index v = 0; v < surface.vertex_count(); ++v) order[surface.source_vertex[v]] = v;
  std::erase_if(order, [&](Index v) { return !used[v] && !surface.incident[v].empty(); });
  for (std::size_t v = surface.vertex_count(); v < count; ++v)
    if (used[v]) order.push_back(static_cast<Index>(v));
  return order;
}

}  // namespace

PatchedSurface patched(const Surface& surface, const SurfacePatch& patch) {
  TriangleMesh mesh;
  mesh.triangles = kept_then_new(surface.triangles, patch.removed, patch.triangles);
  if (!surface.triangle_uv.empty())
    mesh.triangle_uv = kept_then_new(surface.triangle_uv, patch.removed, patch.triangle_uv);
  const std::vector<Index> order = vertices_left(surface, patch, mesh.triangles);
  std::vector<Index> number(surface.vertex_count() + patch.positions.size(), no_index);
  for (const Index vertex : order) {
    number[vertex] = static_cast<Index>(mesh.positions.size());
    mesh.positions.push_back(vertex < surface.vertex_count()
                                 ? surface.positions[vertex]
                                 : patch.positions[vertex - surface.vertex_count()]);
  }
  for (Triangle& triangle : mesh.triangles)
    for (Index& vertex : triangle) vertex = number[vertex];
  PatchedSurface result{make_surface(std::move(mesh)), {}};
  result.surface.scale = surface.scale;
  for (const Index source : result.surface.source_vertex) result.came_from.push_back(order[source]);
  return result;
}

}  // namespace burin
