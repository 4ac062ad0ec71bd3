#pragma once
#include <burin/base/float_image.h>
#include <burin/math/vector_axes.h>
#include <burin/surface/polygon_mesh.h>
#include <burin/surface/triangle_mesh.h>

#include <cstddef>
#include <span>

namespace burin {

struct BakeSettings {
  int size = 1024;             ///< texels a side, >= 1
  bool vectors = false;        ///< a vector displacement map instead of heights
  bool object_space = false;   ///< of vectors: x, y and z are the object's axes, not t, n x t and n
  math::VectorAxes axes = {};  ///< which channels hold x, y and z, and with which sign
  float middle = 0;            ///< value of no displacement
  int padding = 8;             ///< texels by which islands are continued outward
};

struct BakedMap {
  FloatImage image;
  std::size_t overlaps = 0;      ///< texels that lie inside several triangles; the first one's value holds
  std::size_t cut = 0;           ///< triangles that reach beyond the image, which cuts them off
  std::size_t without_area = 0;  ///< displaced triangles that have area, but none in texture coordinates
};

/// Throws Error naming the face, counted from 1, when a mesh cannot be baked: not all corners have texture
/// coordinates, or those of a face are no numbers or lie in the mean more than 0.05 outside 0..1: in a tile
/// of their own (UDIM) or a repetition, and not just beyond a border.
void check_bakeable(const PolygonMesh& mesh);

/// The displacement of a surface as an image over its texture coordinates, object units. A texel's centre
/// stands for the point of the base there; u to the right, v up, the top row below v = 1.
/// - heights: channel Y, the displacement along the normal n;
/// - vectors: channels R, G, B hold x, y, z by the axes: the displacement along t, n x t and n, or along the
///   object's axes; t is dP/du made orthonormal to n.
///   Where an island is mirrored, n x t points against dP/dv.
///
/// n and t are those of the base's vertices, interpolated (BaseFrames). What no triangle covers, and padding
/// does not reach, is the middle. `base` must have texture coordinates, `displaced` is [vertex of it]; else
/// ContractError. The same bits on any number of threads.
BakedMap bake_displacement(TriangleMesh base, std::span<const Vec3f> displaced,
                           const BakeSettings& settings = {});

}  // namespace burin
