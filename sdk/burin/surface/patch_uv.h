#pragma once
#include <burin/surface/picker.h>
#include <burin/surface/surface.h>

#include <vector>

namespace burin {

/// Texture coordinates for a patch's triangles, [new triangle]: those of the closest places of the surface,
/// to which the picker belongs. All corners of a triangle are of the same island, which is the one that its
/// middle is nearest to; a corner beyond a seam continues that island. Nothing for a surface without texture
/// coordinates. On all threads.
std::vector<TriangleUv> carried_uv(const Surface& surface, const Picker& picker, const SurfacePatch& patch);

}  // namespace burin
