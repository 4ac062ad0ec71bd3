// What other programs find in the files.
#include <burin/base/error.h>
#include <burin/level_set/solid_mesh.h>
#include <gtest/gtest.h>
#include <openvdb/io/File.h>
#include <openvdb/openvdb.h>

#include <cmath>

#include "support/charted.h"
#include "support/rods.h"
#include "support/shapes.h"
#include "support/shared_data.h"

namespace burin {
namespace {

constexpr double file_stroke_radius = 0.2, file_rod_radius = 0.05, voxel = 0.01;

/// A rod along x from -0.5 to 0.5, whose height over the plane is told in halves, so that its distances in
/// the stroke's coordinates are not those in space.
StrokeSolid slanted_rod(double stretched) {
  test::Charted charted(test::plane(1, 0.04, 7));
  const Chart chart = charted.chart({.radius = file_stroke_radius},
                                    test::sampled(30, [](double s) { return Vec3d(s - 0.5, 0, 0); }));
  const SolidGround ground{charted.surface, chart, [&](Index v) { return charted.surface.positions[v]; }};
  const SolidExtent extent{
      .h_min = -file_rod_radius, .h_max = file_rod_radius, .radius = file_stroke_radius, .voxel = voxel};
  const DistanceToSolid exact = test::rod(chart, file_rod_radius, 0);
  return {ground, extent, [&](std::span<const ShellPoint> points, std::span<float> distances) {
            exact(points, distances);
            for (float& distance : distances) distance *= static_cast<float>(stretched);
          }};
}

TEST(VdbFile, HoldsDistancesInSpace) {
  const test::TemporaryFolder folder;
  const std::vector<StrokeSolid> solids{slanted_rod(1), slanted_rod(0.6)};
  const auto path = folder.path() / "solids.vdb";
  write_vdb(path, solids);
  openvdb::initialize();
  openvdb::io::File file(path.string());
  file.open();
  const openvdb::GridPtrVecPtr grids = file.getGrids();
  ASSERT_EQ(grids->size(), 2u);
  for (const openvdb::GridBase::Ptr& base : *grids) {
    EXPECT_EQ(base->getName().substr(0, 5), "solid");
    EXPECT_EQ(base->getGridClass(), openvdb::GRID_LEVEL_SET);
    EXPECT_DOUBLE_EQ(base->voxelSize().x(), voxel);
    const auto grid = openvdb::gridPtrCast<openvdb::FloatGrid>(base);
    ASSERT_TRUE(grid);
    double worst = 0;
    for (auto value = grid->cbeginValueOn(); value; ++value) {
      const openvdb::Vec3d at = grid->indexToWorld(value.getCoord());
      const double beyond = at.x() - std::clamp(at.x(), -0.5, 0.5);
      const double exact = std::sqrt(beyond * beyond + at.y() * at.y() + at.z() * at.z()) - file_rod_radius;
      worst = std::max(worst, std::abs(static_cast<double>(*value) - exact));
    }
    EXPECT_GT(grid->activeVoxelCount(), 10000u);
    EXPECT_LT(worst, 0.6 * voxel);
    EXPECT_LT(grid->tree().getValue(openvdb::Coord(0, 0, 0)), 0);
  }
}

TEST(VdbFile, NamesAFolderThatIsNotThere) {
  try {
    write_vdb("/no/such/folder/solids.vdb", std::vector<StrokeSolid>{});
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("/no/such/folder/solids.vdb"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace burin
