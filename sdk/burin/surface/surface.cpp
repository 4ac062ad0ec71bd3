// Makes a surface of a mesh: sorts vertices along a Hilbert curve and triangles by their lowest vertex, then
// computes neighbourhoods, normals and curvature, all in O(n) for meshes of bounded valence, on all threads.
#include <burin/base/counting_sort.h>
#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/base/trees/bounding_box.h>
#include <burin/base/trees/spatial_order.h>
#include <burin/surface/connect_surface.h>
#include <burin/surface/geometry/triangle_shape.h>
#include <burin/surface/surface.h>

#include <algorithm>
#include <atomic>
#include <functional>
#include <span>
#include <tuple>

namespace burin {
namespace {

constexpr std::size_t elements_per_block = 16384;

/// Whether `good` is true for all elements; evaluated on all threads.
template <class Element, class Good>
bool all_of(const std::vector<Element>& elements, const Good& good) {
  std::atomic<bool> result = true;
  parallel_blocks(elements.size(), elements_per_block, [&](std::size_t begin, std::size_t end) {
    if (!std::ranges::all_of(std::span(elements).subspan(begin, end - begin), good)) result = false;
  });
  return result;
}

void check(const TriangleMesh& mesh) {
  const auto in_range = [&](Index vertex) { return vertex < mesh.positions.size(); };
  if (!all_of(mesh.triangles, [&](const Triangle& t) { return std::ranges::all_of(t, in_range); }))
    throw ContractError("a triangle names a vertex that is not there");
  if (!all_of(mesh.positions, [](const Vec3f& p) { return p.allFinite(); }))
    throw Error("a vertex has a coordinate that is not finite");
  if (std::ranges::none_of(mesh.triangles, [&](const Triangle& t) { return has_area(mesh.positions, t); }))
    throw Error("no triangle has an area");
}

/// Sorts the vertices along the space-filling curve and renumbers the triangles' corners.
void sort_vertices(TriangleMesh& mesh, Surface& surface) {
  surface.source_vertex = spatial_order(mesh.positions);
  const std::vector<Index>& source = surface.source_vertex;
  surface.positions.resize(source.size());
  UnsetVector<Index> sorted(source.size());
  parallel_blocks(source.size(), elements_per_block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      surface.positions[i] = mesh.positions[source[i]];
      sorted[source[i]] = static_cast<Index>(i);
    }
  });
  std::vector<Vec3f>().swap(mesh.positions);
  parallel_blocks(mesh.triangles.size(), elements_per_block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      for (Index& vertex : mesh.triangles[i]) vertex = sorted[vertex];
  });
}

/// What `item` makes of each triangle, sorted by the triangle's lowest vertex and then by `less`, without
/// triangles that have a vertex twice.
template <class Item, class MakeItem, class Less>
UnsetVector<Item> sorted_by_lowest(const std::vector<Triangle>& triangles, std::size_t vertices,
                                   const MakeItem& item, const Less& less) {
  UnsetVector<Item> sorted(triangles.size());
  const std::vector<Index> offsets = counting_sort(
      triangles.size(), vertices,
      [&](std::size_t i, const auto& emit) {
        const auto& [a, b, c] = triangles[i];
        if (!has_repeated_vertex(triangles[i])) emit(std::min(std::min(a, b), c));
      },
      [&](std::size_t i, std::size_t position) { sorted[position] = item(i); });
  sorted.resize(offsets.back());
  parallel_blocks(vertices, elements_per_block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t vertex = begin; vertex < end; ++vertex)
      std::sort(sorted.begin() + offsets[vertex], sorted.begin() + offsets[vertex + 1], less);
  });
  return sorted;
}

/// The values of these elements, in their order.
template <class Value>
std::vector<Value> chosen(const std::vector<Value>& values, const UnsetVector<Index>& elements) {
  std::vector<Value> result(elements.size());
  parallel_blocks(result.size(), elements_per_block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) result[i] = values[elements[i]];
  });
  return result;
}

/// Sorts triangles by lowest vertex, then lexicographically. Triangles that compare equal are identical, so
/// every sorting method gives the same result; with texture coordinates they keep their order.
void sort_triangles(TriangleMesh& mesh, Surface& surface) {
  const std::size_t vertices = surface.positions.size();
  if (mesh.triangle_uv.empty()) {
    const UnsetVector<Triangle> sorted = sorted_by_lowest<Triangle>(
        mesh.triangles, vertices, [&](std::size_t i) { return mesh.triangles[i]; }, std::less<>());
    mesh.triangles.resize(sorted.size());
    parallel_blocks(sorted.size(), elements_per_block, [&](std::size_t begin, std::size_t end) {
      std::copy(sorted.begin() + begin, sorted.begin() + end, mesh.triangles.begin() + begin);
    });
    surface.triangles = std::move(mesh.triangles);
    return;
  }
  const UnsetVector<Index> order = sorted_by_lowest<Index>(
      mesh.triangles, vertices, [](std::size_t i) { return static_cast<Index>(i); },
      [&](Index a, Index b) { return std::tie(mesh.triangles[a], a) < std::tie(mesh.triangles[b], b); });
  surface.triangles = chosen(mesh.triangles, order);
  surface.triangle_uv = chosen(mesh.triangle_uv, order);
}

}  // namespace

Surface make_surface(TriangleMesh mesh, const Progress& progress) {
  check(mesh);
  Surface surface;
  report(progress, "sorting the surface", 0);
  sort_vertices(mesh, surface);
  surface.scale = bounding_box_diagonal(surface.positions);
  report(progress, "sorting the surface", 0.3);
  sort_triangles(mesh, surface);
  mesh = {};
  connect_surface(surface, progress, 0.6);
  return surface;
}

}  // namespace burin
