#pragma once
#include <burin/deform/blend.h>
#include <burin/deform/paint.h>
#include <burin/surface/surface.h>

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

namespace burin {

/// Where the vertices of a piece of a stroke go: [i] is for vertices[i].
struct PieceMoves {
  std::span<const Index> vertices;
  std::span<const std::uint32_t> sheets;  ///< nodes of the piece; 0: none, the vertex is at its base
  std::span<Vec3f> places;
  std::span<Tint> tints;  ///< empty where the brush writes neither colours nor masks
};

/// What the finished pieces of a stroke did to the surface before it. A stroke falls into pieces where the
/// pen leaves the surface. All start from that surface, and where they meet they are blended as sheets of one
/// stroke are; of `latest`, the piece drawn last holds. Costs what the pieces cover.
class EarlierPieces {
 public:
  /// Surface and paint, as they were before the stroke, must outlive the object.
  EarlierPieces(const Surface& surface, const BlendOptions& options)
      : surface_(&surface), options_(options) {}

  /// Makes of where a later piece would have vertices go where the stroke has them.
  void blend(const Paint& paint, const PieceMoves& piece) const;

  /// Adds a piece that is finished, blended with those before it.
  void add(const PieceMoves& piece);

 private:
  struct Left {
    std::uint32_t sheets = 0;
    Vec3f place = Vec3f::Zero();
    Tint tint = Tint::Zero();
  };
  Vec3f place(const Left& earlier, Index vertex, std::uint32_t sheets, const Vec3f& later) const;
  Tint tint(const Left& earlier, const Tint& before, std::uint32_t sheets, const Tint& later) const;

  const Surface* surface_;
  BlendOptions options_;
  std::unordered_map<Index, Left> left_;
};

}  // namespace burin
