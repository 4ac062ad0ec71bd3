// Turns the surface of a voxel solid into a triangle mesh, by contouring its level set and relaxing the
// vertices, and solids written as OpenVDB files.
#include <burin/base/error.h>
#include <burin/base/file.h>
#include <burin/level_set/relaxed_mesh.h>
#include <burin/level_set/solid_mesh.h>
#include <openvdb/io/File.h>

namespace burin {

TriangleMesh mesh_of(const StrokeSolid& solid) {
  const Grid::Ptr grid = grid_of(solid);
  return relaxed_mesh(GridSurface(*grid));
}

void write_vdb(const std::filesystem::path& path, std::span<const StrokeSolid> solids) {
  openvdb::GridPtrVec grids;
  for (const StrokeSolid& solid : solids) {
    grids.push_back(distances_of(solid));
    grids.back()->setName("solid");
  }
  replace_file(path, [&](const std::filesystem::path& partial) {
    try {
      openvdb::io::File file(partial.string());
      file.write(grids);
      file.close();
    } catch (const openvdb::Exception& error) {
      throw FileError(path.string(), error.what());
    }
  });
}

}  // namespace burin
