// Makes a surface of a mesh: sorts vertices along a Hilbert curve and triangles by their lowest vertex, then
// computes neighbourhoods, normals and curvature, all in O(n) for meshes of bounded valence, on all threads.
#include <burin/base/counting_sort.h>
#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/surface/geometry/bounding_box.h>
#include <burin/surface/geometry/curvature.h>
#include <burin/surface/geometry/normals.h>
#include <burin/surface/geometry/triangle_shape.h>
#include <burin/surface/surface.h>
#include <burin/surface/topology/adjacency.h>
#include <burin/surface/topology/spatial_order.h>

#include <algorithm>
#include <atomic>
#include <span>

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
  if (std::ranges::none_of(mesh.triangles, [&](const Triangle& t) { return has_area(mesh, t); }))
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

/// Sorts triangles by lowest vertex, then lexicographically, and removes those that have a vertex twice.
/// Triangles that compare equal are identical, so every sorting method gives the same result.
void sort_triangles(std::vector<Triangle>& triangles, std::size_t vertices) {
  UnsetVector<Triangle> sorted(triangles.size());
  const std::vector<Index> offsets = counting_sort(
      triangles.size(), vertices,
      [&](std::size_t i, const auto& emit) {
        const auto& [a, b, c] = triangles[i];
        if (!has_repeated_vertex(triangles[i])) emit(std::min(std::min(a, b), c));
      },
      [&](std::size_t i, std::size_t position) { sorted[position] = triangles[i]; });
  triangles.resize(offsets.back());
  parallel_blocks(vertices, elements_per_block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t vertex = begin; vertex < end; ++vertex)
      std::sort(sorted.begin() + offsets[vertex], sorted.begin() + offsets[vertex + 1]);
    std::copy(sorted.begin() + offsets[begin], sorted.begin() + offsets[end],
              triangles.begin() + offsets[begin]);
  });
}

void compute_all_normals(Surface& surface) {
  surface.normals.resize(surface.positions.size());
  parallel_blocks(surface.positions.size(), elements_per_block, [&](std::size_t begin, std::size_t end) {
    for (Index vertex = static_cast<Index>(begin); vertex < end; ++vertex)
      surface.normals[vertex] = vertex_normal(surface, surface.positions, vertex);
  });
}

}  // namespace

Surface make_surface(TriangleMesh mesh, const Progress& progress) {
  check(mesh);
  Surface surface;
  report(progress, "sorting the surface", 0);
  sort_vertices(mesh, surface);
  surface.scale = bounding_box_diagonal(surface.positions);
  report(progress, "sorting the surface", 0.3);
  surface.triangles = std::move(mesh.triangles);
  sort_triangles(surface.triangles, surface.positions.size());
  report(progress, "connecting the surface", 0.6);
  surface.incident = incident_triangles(surface.positions.size(), surface.triangles);
  surface.neighbours = neighbour_vertices(surface.triangles, surface.incident);
  report(progress, "computing normals", 0.8);
  compute_all_normals(surface);
  compute_gauss_curvature(surface);
  report(progress, "computing normals", 1);
  return surface;
}

}  // namespace burin
