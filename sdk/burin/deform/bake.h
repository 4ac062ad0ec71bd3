#pragma once
#include <burin/base/float_image.h>
#include <burin/math/vector_axes.h>
#include <burin/surface/polygon_mesh.h>
#include <burin/surface/triangle_mesh.h>

#include <cstddef>
#include <span>

// The functions may be called on any thread, also on several at once. Inside they use all threads of oneTBB.
namespace burin {

/// How a displacement becomes an image.
struct BakeSettings {
  int size = 1024;             ///< texels per side, >= 1
  bool vectors = false;        ///< makes a vector displacement map instead of heights
  bool object_space = false;   ///< vectors are along the object's axes instead of t, n x t and n
  math::VectorAxes axes = {};  ///< the channels that hold x, y and z, and their signs
  float middle = 0;            ///< the value for no displacement
  int padding = 8;             ///< texels by which islands are extended outward
};

/// A displacement as an image, and what did not go into it.
struct BakedMap {
  FloatImage image;
  std::size_t overlaps = 0;      ///< texels inside several triangles; the value is that of the first one
  std::size_t cut = 0;           ///< triangles that reach beyond the image and are cut off
  std::size_t without_area = 0;  ///< displaced triangles that have area, but none in texture coordinates
};

/// Throws Error, which gives the face counted from 1, if a mesh cannot be baked: not all corners have texture
/// coordinates, or the mean of a face's coordinates is not finite or more than 0.05 outside 0..1, as in other
/// tiles (UDIM) and repetitions.
void check_bakeable(const PolygonMesh& mesh);

/// Bakes the displacement of a surface, object units, to an image over its texture coordinates. A texel has
/// the value at the point of the base below the texel's centre. u runs to the right and v up; the top row
/// lies below v = 1.
/// - Heights: channel Y is the displacement along the normal n.
/// - Vectors: channels R, G and B hold x, y and z in the order of the axes. They are the displacement along
/// t, n x t
///   and n, or along the object's axes. t is dP/du made orthonormal to n. In mirrored islands n x t points
///   against dP/dv.
///
/// n and t are interpolated from the base's vertices (BaseFrames). Texels that neither a triangle nor the
/// padding reaches have the value `middle`. `displaced` are the displaced positions of the base's vertices.
/// Throws ContractError if the base has no texture coordinates, if sizes differ, or for a size below 1. The
/// result does not depend on the number of threads.
BakedMap bake_displacement(TriangleMesh base, std::span<const Vec3f> displaced,
                           const BakeSettings& settings = {});

}  // namespace burin
