// Turns the surface of a voxel solid into a triangle mesh, by contouring its level set and relaxing the
// vertices; and writes solids as OpenVDB files.
#include <burin/base/error.h>
#include <burin/base/file.h>
#include <burin/level_set/grid/closed.h>
#include <burin/level_set/relaxed_mesh.h>
#include <burin/level_set/solid_mesh.h>
#include <burin/remesh/patch_mesh.h>
#include <openvdb/io/File.h>

#include <algorithm>
#include <cstddef>

namespace burin {

namespace {

std::ptrdiff_t sliver_count(const TriangleMesh& mesh) {
  return std::ranges::count_if(mesh.triangles, [&](const Triangle& t) {
    const auto at = [&](std::size_t i) { return mesh.positions[t[i]].cast<double>().eval(); };
    return worst_cosine(at(0), at(1), at(2)) > sliver_cosine;
  });
}

}  // namespace

TriangleMesh mesh_of(const StrokeSolid& solid) {
  constexpr double ball = 1;  // voxels
  const Grid::Ptr grid = grid_of(solid);
  TriangleMesh mesh = relaxed_mesh(GridSurface(*grid));
  const std::ptrdiff_t slivers = sliver_count(mesh);
  if (slivers == 0) return mesh;
  // Voxels cannot hold valleys that end in a cusp.
  close(*grid, ball);
  TriangleMesh closed = relaxed_mesh(GridSurface(*grid));
  return sliver_count(closed) < slivers ? closed : mesh;
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
