#include <burin/base/parallel.h>
#include <burin/host/c/hidden_faces.h>
#include <burin/surface/geometry/triangle_shape.h>
#include <burin/surface/source_numbers.h>

#include <algorithm>
#include <compare>

namespace burin::c {
namespace {

/// A triangle of a surface; surfaces have them in this order.
struct Sorted {
  Index lowest;
  Triangle triangle;
  Index face;

  auto operator<=>(const Sorted&) const = default;
};

}  // namespace

HiddenFaces::HiddenFaces(const std::vector<Triangle>& triangles, const std::vector<Index>& triangle_face,
                         Index face_count, const Surface& surface)
    : face_count_(face_count) {
  const std::vector<Index> number = numbers_of_source(surface);
  std::vector<Sorted> sorted;
  sorted.reserve(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (has_repeated_vertex(triangles[i])) continue;
    const Triangle t{number[triangles[i][0]], number[triangles[i][1]], number[triangles[i][2]]};
    sorted.push_back({std::ranges::min(t), t, triangle_face[i]});
  }
  parallel_sort(sorted.begin(), sorted.end());
  face_.reserve(sorted.size());
  for (const Sorted& of : sorted) face_.push_back(of.face);
}

std::vector<bool> HiddenFaces::triangles(const std::uint8_t* hidden) const {
  std::vector<bool> triangles(face_.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) triangles[i] = hidden[face_[i]] != 0;
  return triangles;
}

}  // namespace burin::c
