#pragma once
#include <burin/surface/triangle_mesh.h>
#include <burin/volume/solid.h>

#include <filesystem>
#include <memory>

namespace burin {

class VoxelField;
struct VoxelFieldOptions;

/// What level_set does with solids: merge_solid(), mesh_of() and read_vdb() of level_set/solid_mesh.h. They
/// use oneTBB, whatever threads an application lends.
struct SolidTools {
  MergedSolid (*merge)(const SolidMerge& merge);
  TriangleMesh (*mesh_of)(const StrokeSolid& solid);
  std::shared_ptr<const VoxelField> (*read_vdb)(const std::filesystem::path& path,
                                                const VoxelFieldOptions& options);
};

}  // namespace burin

// The module burin-solids.so: what needs OpenVDB in a file of its own, so that libburin.so can be installed
// and loaded without it.
extern "C" {

/// Returns the functions, or null if the module belongs to another version of Burin than `version`.
__attribute__((visibility("default"))) const burin::SolidTools* burin_solid_tools(const char* version);
}
