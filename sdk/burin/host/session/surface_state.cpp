#include <burin/base/hash.h>
#include <burin/base/parallel.h>
#include <burin/host/session/surface_state.h>

#include <array>
#include <atomic>
#include <bit>
#include <cstddef>

namespace burin {
namespace {

/// The hash of numbers of a vertex. `kind` keeps values of different kinds apart.
template <std::size_t size>
std::uint64_t hash_of(std::uint32_t kind, Index source, const float* numbers) {
  std::array<std::uint32_t, size + 2> words{kind, source};
  for (std::size_t i = 0; i < size; ++i) words[i + 2] = std::bit_cast<std::uint32_t>(numbers[i]);
  return hash_bytes(words.data(), sizeof words);
}

}  // namespace

std::uint64_t SurfaceState::term(Index source, const Vec3f& position) {
  return hash_of<3>(0, source, position.data());
}

std::uint64_t SurfaceState::term(Index source, const Vec4f& colour) {
  return colour == Paint::bare() ? 0 : hash_of<4>(1, source, colour.data());
}

std::uint64_t SurfaceState::term(Index source, float mask) {
  return mask == 1 ? 0 : hash_of<1>(2, source, &mask);
}

std::uint64_t SurfaceState::of(const Surface& surface, const Paint& paint) {
  if (sum_) return *sum_;
  std::atomic<std::uint64_t> sum = 0;
  parallel_blocks(surface.vertex_count(), 16384, [&](std::size_t begin, std::size_t end) {
    std::uint64_t part = 0;
    for (auto vertex = static_cast<Index>(begin); vertex < end; ++vertex) {
      const Index source = surface.source_vertex[vertex];
      part += term(source, surface.positions[vertex]) + term(source, paint.colour_of(vertex)) +
              term(source, paint.mask_of(vertex));
    }
    sum += part;
  });
  return sum_.emplace(sum);
}

std::uint64_t SurfaceState::with(const UndoStep& step, const Surface& surface, const Paint& paint) const {
  std::uint64_t sum = *sum_ - difference(surface, step.paint, paint);
  for (std::size_t i = 0; i < step.vertices.size(); ++i) {
    const Index vertex = step.vertices[i], source = surface.source_vertex[vertex];
    sum += term(source, step.positions[i]) - term(source, surface.positions[vertex]);
  }
  return sum;
}

/// What the values of `now` add to a number that had those of `before`.
std::uint64_t SurfaceState::difference(const Surface& surface, const PaintStep& before, const Paint& now) {
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < before.vertices.size(); ++i) {
    const Index vertex = before.vertices[i], source = surface.source_vertex[vertex];
    if (!before.colours.empty()) sum += term(source, now.colour_of(vertex)) - term(source, before.colours[i]);
    if (!before.masks.empty()) sum += term(source, now.mask_of(vertex)) - term(source, before.masks[i]);
  }
  return sum;
}

}  // namespace burin
