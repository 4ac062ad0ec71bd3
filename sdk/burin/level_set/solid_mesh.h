#pragma once
#include <burin/surface/triangle_mesh.h>
#include <burin/volume/solid.h>

#include <filesystem>
#include <memory>
#include <span>

namespace burin {

class VoxelField;
struct VoxelFieldOptions;

/// The surface of a solid: closed, counter-clockwise seen from outside, its triangles near to equilateral.
/// Holds the solid's volume to better than second order in the voxel's edge where the surface is smooth;
/// edges of the solid become about a voxel round. On all threads; the bits do not depend on their number.
TriangleMesh mesh_of(const StrokeSolid& solid);

/// Joins a solid with a surface, or takes it away, through voxels around the solid, and sews the new
/// triangles to the rest. Vertices farther from the solid than the blend radius and two voxels stay as they
/// are, except where walls meet at so acute an angle that the fillet reaches farther. Throws Error where the
/// surface is open or no manifold near the solid, or the new triangles do not fit to it. On all threads; the
/// bits do not depend on their number.
MergedSolid merge_solid(const SolidMerge& merge);

/// Writes solids as an OpenVDB file: a level set named "solid" each, in object units, distances in space
/// three voxels to either side. Throws FileError naming the file.
void write_vdb(const std::filesystem::path& path, std::span<const StrokeSolid> solids);

/// Reads a grid of floats of an OpenVDB file as a stamp: stamp_services(read_vdb) lets brushes open such
/// files. The box is that of the grid's active voxels. Throws FileError naming the file where it cannot be
/// read, is cut off, or has no such grid; where the grid is empty, holds a value that is not finite, has
/// voxels that are no cubes of one size, or a box of more than 2^28 voxels.
std::shared_ptr<const VoxelField> read_vdb(const std::filesystem::path& path,
                                           const VoxelFieldOptions& options);

}  // namespace burin
