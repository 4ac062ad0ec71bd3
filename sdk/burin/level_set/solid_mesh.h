#pragma once
#include <burin/surface/triangle_mesh.h>
#include <burin/volume/solid.h>

#include <filesystem>
#include <span>

namespace burin {

/// The surface of a solid: closed, counter-clockwise seen from outside, its triangles near to equilateral.
/// Holds the solid's volume to better than second order in the voxel's edge where the surface is smooth;
/// edges of the solid become about a voxel round. On all threads; the bits do not depend on their number.
TriangleMesh mesh_of(const StrokeSolid& solid);

/// Writes solids as an OpenVDB file: a level set named "solid" each, in object units, distances in space
/// three voxels to either side. Throws FileError naming the file.
void write_vdb(const std::filesystem::path& path, std::span<const StrokeSolid> solids);

}  // namespace burin
