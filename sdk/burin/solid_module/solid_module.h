#pragma once
#include <burin/base/task_runner.h>
#include <burin/surface/triangle_mesh.h>
#include <burin/volume/solid.h>

#include <filesystem>
#include <memory>

namespace burin {

class VoxelField;
struct VoxelFieldOptions;

/// What level_set does with solids: merge_solid(), mesh_of() and read_vdb() of level_set/solid_mesh.h. `lent`
/// are the threads that an application lends, or null: oneTBB. OpenVDB knows no others, so that its own loops
/// run on the thread of the call where there are such.
struct SolidTools {
  MergedSolid (*merge)(const TaskRunner* lent, const SolidMerge& merge);
  TriangleMesh (*mesh_of)(const TaskRunner* lent, const StrokeSolid& solid);
  std::shared_ptr<const VoxelField> (*read_vdb)(const TaskRunner* lent, const std::filesystem::path& path,
                                                const VoxelFieldOptions& options);
};

}  // namespace burin

// The module burin-solids.so: what needs OpenVDB in a file of its own, so that libburin.so can be installed
// and loaded without it.
extern "C" {

/// Returns the functions, or null if the module belongs to another version of Burin than `version`.
__attribute__((visibility("default"))) const burin::SolidTools* burin_solid_tools(const char* version);
}
