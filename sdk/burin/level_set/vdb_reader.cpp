// Reads .vdb files as stamps. OpenVDB does not notice where a stream ends too soon, and maps files lazily, so
// that a file that is cut off would end the process later: the stream throws instead, and all is read at
// once.
#include <burin/base/error.h>
#include <burin/base/file.h>
#include <burin/level_set/solid_mesh.h>
#include <burin/volume/voxel_field.h>
#include <openvdb/io/Stream.h>
#include <openvdb/openvdb.h>
#include <openvdb/tools/FastSweeping.h>

#include <cmath>
#include <sstream>
#include <string>

namespace burin {
namespace {

using Grid = openvdb::FloatGrid;

/// A file's grids, and its name for messages.
class VdbFile {
 public:
  explicit VdbFile(const std::filesystem::path& path) : path_(path) {
    openvdb::initialize();
    std::istringstream bytes(read_file(path), std::ios::binary);
    bytes.exceptions(std::ios::failbit | std::ios::badbit | std::ios::eofbit);
    try {
      grids_ = openvdb::io::Stream(bytes, false).getGrids();
    } catch (const std::ios_base::failure&) {
      fail("ends too soon");
    } catch (const std::exception& error) {
      fail(std::string("cannot be read: ") + error.what());
    }
  }

  /// The grid of floats of this name, or the first one.
  Grid::Ptr grid(const std::string& name) const {
    for (const openvdb::GridBase::Ptr& base : *grids_) {
      auto floats = openvdb::gridPtrCast<Grid>(base);
      if (floats && (name.empty() || base->getName() == name)) return floats;
    }
    fail(name.empty() ? "has no grid of floats" : "has no grid of floats named '" + name + "'");
  }

  [[noreturn]] void fail(const std::string& what) const { throw FileError(path_.string(), what); }

 private:
  std::filesystem::path path_;
  openvdb::GridPtrVecPtr grids_;
};

std::string text(const openvdb::Coord& at) {
  return "(" + std::to_string(at.x()) + ", " + std::to_string(at.y()) + ", " + std::to_string(at.z()) + ")";
}

void check_voxels(const VdbFile& file, const Grid& grid) {
  const openvdb::Vec3d edge = grid.transform().isLinear() ? grid.voxelSize() : openvdb::Vec3d(0.0);
  constexpr double alike = 1e-4;
  const bool cubes = edge.x() > 0 && std::abs(edge.y() - edge.x()) <= alike * edge.x() &&
                     std::abs(edge.z() - edge.x()) <= alike * edge.x();
  if (!cubes) file.fail("grid '" + grid.getName() + "': its voxels are no cubes of one size");
}

/// Throws FileError naming the first value that is not finite.
void check_values(const VdbFile& file, const Grid& grid) {
  if (!std::isfinite(grid.background()))
    file.fail("grid '" + grid.getName() + "': its background is " + std::to_string(grid.background()));
  for (auto value = grid.cbeginValueAll(); value; ++value)
    if (!std::isfinite(*value))
      file.fail("grid '" + grid.getName() + "': the value at voxel " + text(value.getCoord()) + " is " +
                std::to_string(*value));
}

/// The active voxels' box.
openvdb::CoordBBox box_of(const VdbFile& file, const Grid& grid) {
  const openvdb::CoordBBox box = grid.evalActiveVoxelBoundingBox();
  if (box.empty()) file.fail("grid '" + grid.getName() + "' is empty");
  const openvdb::Coord size = box.dim();
  const double voxels = static_cast<double>(size.x()) * size.y() * size.z();
  if (voxels > static_cast<double>(VoxelField::most_voxels))
    file.fail("grid '" + grid.getName() + "': its box of " + std::to_string(size.x()) + " x " +
              std::to_string(size.y()) + " x " + std::to_string(size.z()) + " voxels holds more than " +
              std::to_string(VoxelField::most_voxels));
  return box;
}

}  // namespace

std::shared_ptr<const VoxelField> read_vdb(const std::filesystem::path& path,
                                           const VoxelFieldOptions& options) {
  const VdbFile file(path);
  Grid::Ptr grid = file.grid(options.grid);
  check_voxels(file, *grid);
  check_values(file, *grid);
  const openvdb::CoordBBox box = box_of(file, *grid);
  bool level_set = grid->getGridClass() == openvdb::GRID_LEVEL_SET;
  if (!level_set && options.surface_at > 0) {
    grid = openvdb::tools::fogToSdf(*grid, static_cast<float>(options.surface_at));
    level_set = true;
  }
  const auto accessor = grid->getConstAccessor();
  const auto fill = [&](const Eigen::Vector3i& first, std::array<float, 512>& values) {
    for (int i = 0; i < 512; ++i)
      values[static_cast<std::size_t>(i)] =
          accessor.getValue(box.min().offsetBy(first.x() + i / 64, first.y() + i / 8 % 8, first.z() + i % 8));
  };
  const openvdb::Coord size = box.dim();
  return std::make_shared<const VoxelField>(level_set ? VoxelField::Kind::level_set : VoxelField::Kind::fog,
                                            Eigen::Vector3i(size.x(), size.y(), size.z()),
                                            grid->voxelSize().x(), fill);
}

}  // namespace burin
