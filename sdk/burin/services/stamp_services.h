#pragma once
#include <burin/host/host_extensions.h>

#include <filesystem>
#include <memory>

namespace burin {

class VoxelField;
struct VoxelFieldOptions;

/// Reads a grid of a .vdb file: read_vdb() of burin/level_set/solid_mesh.h, the component `solids`.
using VdbReader = std::shared_ptr<const VoxelField> (*)(const std::filesystem::path& path,
                                                        const VoxelFieldOptions& options);

/// Stamps and lettering for the brushes of a BrushLibrary: images from files, lines of text as images and,
/// given `read_vdb`, grids of .vdb files. Without these services a stroke of a brush that needs them fails
/// with a message. The services may be called on any thread.
std::unique_ptr<HostExtensions> stamp_services(VdbReader read_vdb = nullptr);

}  // namespace burin
