// Hashes what strokes made. Values of vertices are taken in the order of the mesh file, so that the hash does
// not depend on how a surface orders its vertices.
#include <burin/base/hash.h>
#include <burin/host/session.h>

#include <algorithm>
#include <cstddef>
#include <ranges>
#include <vector>

namespace burin {
namespace {

template <class Values>
std::uint64_t hash_of(const Values& values) {
  return hash_bytes(values.data(), values.size() * sizeof values[0]);
}

/// The values of vertices in the order of the mesh file.
template <class Values>
auto in_source_order(const Values& values, const Surface& surface) {
  std::vector<std::ranges::range_value_t<Values>> ordered(values.size());
  for (std::size_t v = 0; v < values.size(); ++v) ordered[surface.source_vertex[v]] = values[v];
  return ordered;
}

/// Whether a vertex has another value than those that are not painted.
template <class Value>
bool painted(const std::vector<Value>& values, const Value& bare) {
  return std::ranges::any_of(values, [&](const Value& value) { return value != bare; });
}

}  // namespace

std::uint64_t Session::result_hash() const {
  const auto ordered = [this](const auto& values) { return hash_of(in_source_order(values, surface())); };
  std::vector<std::uint64_t> hashes{ordered(positions())};
  // Whether arrays are there depends on strokes that were dropped or undone.
  const bool coloured = painted(paint().colour, Paint::bare()), masked = painted(paint().mask, 1.F);
  if (coloured || masked) {
    hashes.push_back(coloured ? ordered(paint().colour) : hash_of(std::vector<Vec4f>()));
    hashes.push_back(masked ? ordered(paint().mask) : hash_of(std::vector<float>()));
  }
  for (const StrokeSolid& part : parts()) hashes.push_back(hash_of(part.blocks()));
  for (const TriangleMesh& mesh : bent_meshes()) {
    hashes.push_back(hash_of(mesh.positions));
    hashes.push_back(hash_of(mesh.triangles));
  }
  return hashes.size() == 1 ? hashes.front() : hash_of(hashes);
}

}  // namespace burin
