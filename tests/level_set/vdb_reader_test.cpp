// .vdb files as stamps: of this library, of OpenVDB's Python module, and broken ones.
#include <burin/base/error.h>
#include <burin/base/file.h>
#include <burin/level_set/solid_mesh.h>
#include <burin/volume/voxel_field.h>
#include <gtest/gtest.h>
#include <openvdb/io/File.h>
#include <openvdb/openvdb.h>

#include <cmath>
#include <fstream>
#include <iostream>
#include <limits>

#include "support/charted.h"
#include "support/process.h"
#include "support/rods.h"
#include "support/shapes.h"
#include "support/shared_data.h"

namespace burin {
namespace {

openvdb::FloatGrid::Ptr ball_grid(const openvdb::Coord& middle, double voxel) {
  openvdb::initialize();
  const auto grid = openvdb::FloatGrid::create(static_cast<float>(3 * voxel));
  grid->setTransform(openvdb::math::Transform::createLinearTransform(voxel));
  grid->setGridClass(openvdb::GRID_LEVEL_SET);
  grid->setName("ball");
  for (int i = -12; i <= 12; ++i)
    for (int j = -12; j <= 12; ++j)
      for (int k = -12; k <= 12; ++k) {
        const double distance = std::sqrt(i * i + j * j + k * k) - 8;
        if (std::abs(distance) < 3)
          grid->tree().setValueOn(middle.offsetBy(i, j, k), static_cast<float>(distance * voxel));
      }
  return grid;
}

class VdbReader : public testing::Test {
 protected:
  std::filesystem::path file(const char* name) const { return folder_.path() / name; }

  std::filesystem::path write(const openvdb::GridPtrVec& grids, const char* name = "stamp.vdb") const {
    openvdb::io::File out(file(name).string());
    out.write(grids);
    out.close();
    return file(name);
  }

  /// What the reader says of a file, without its name at the begin.
  static std::string refusal(const std::filesystem::path& path, const VoxelFieldOptions& options = {}) {
    try {
      read_vdb(path, options);
    } catch (const Error& error) {
      const std::string line = error.what(), name = path.string();
      EXPECT_TRUE(line.starts_with(name)) << line;
      EXPECT_EQ(line.find('\n'), std::string::npos) << line;
      return line.substr(name.size());
    }
    return "none";
  }

  test::TemporaryFolder folder_;
};

TEST_F(VdbReader, HasEveryVoxelWhereTheActiveBoxHasIt) {
  const auto grid = ball_grid({-40, 7, 1000}, 0.25);
  const auto field = read_vdb(write({grid}), {});
  EXPECT_EQ(field->kind(), VoxelField::Kind::level_set);
  const openvdb::CoordBBox box = grid->evalActiveVoxelBoundingBox();
  ASSERT_EQ(field->size(), Eigen::Vector3i(21, 21, 21));
  for (int i = 0; i < 21; ++i)
    for (int j = 0; j < 21; ++j)
      for (int k = 0; k < 21; ++k)
        ASSERT_EQ(0.25F * field->at({i + 0.5, j + 0.5, k + 0.5}, {}),
                  grid->tree().getValue(box.min().offsetBy(i, j, k)));
}

TEST_F(VdbReader, ReadsWhatSaveVdbWrites) {
  constexpr double voxel = 0.01, rod_radius = 0.05;
  test::Charted charted(test::plane(1, 0.04, 7));
  const Chart chart =
      charted.chart({.radius = 0.2}, test::sampled(30, [](double s) { return Vec3d(s - 0.5, 0, 0); }));
  const SolidGround ground{charted.surface, chart, [&](Index v) { return charted.surface.positions[v]; }};
  const StrokeSolid solid(ground, {.h_min = -rod_radius, .h_max = rod_radius, .radius = 0.2, .voxel = voxel},
                          test::rod(chart, rod_radius, 0));
  write_vdb(file("rod.vdb"), {&solid, 1});
  const auto field = read_vdb(file("rod.vdb"), {"solid"});
  openvdb::io::File in(file("rod.vdb").string());
  in.open();
  const auto grid = openvdb::gridPtrCast<openvdb::FloatGrid>(in.readGrid("solid"));
  const openvdb::CoordBBox box = grid->evalActiveVoxelBoundingBox();
  float worst = 0;
  for (auto value = grid->cbeginValueOn(); value; ++value) {
    const openvdb::Coord at = value.getCoord() - box.min();
    const float read = field->at({at.x() + 0.5, at.y() + 0.5, at.z() + 0.5}, {});
    worst = std::max(worst, std::abs(read - *value / static_cast<float>(voxel)));
  }
  EXPECT_LT(worst, 1e-6F);
  // The rod's own formula, in voxels from the box's corner.
  const Vec3d middle = -Vec3d(box.min().x(), box.min().y(), box.min().z()) + Vec3d::Constant(0.5);
  double off = 0;
  for (double up = 0; up < 8; up += 0.37)
    off = std::max(
        off, std::abs(static_cast<double>(field->at(middle + Vec3d(0, 0, up), {})) - std::max(up - 5, -3.0)));
  std::cout << "distances of a saved rod are off by " << off << " voxels\n";
  EXPECT_LT(off, 0.3);
}

TEST_F(VdbReader, ReadsWhatOpenVdbsPythonModuleWrites) {
  const std::string script = file("write.py").string();
  std::ofstream(script) << R"(
import sys, numpy, pyopenvdb
x, y, z = numpy.meshgrid(numpy.arange(16), numpy.arange(9), numpy.arange(11), indexing="ij")
values = 0.2 * numpy.sin(2 * numpy.pi * x / 16) + 0.5 * (y - 4.25) + 0.125 * z
def grid(name, kind):
    grid = pyopenvdb.FloatGrid(background=100)
    grid.copyFromArray(values.astype(numpy.float32), ijk=(-5, 3, 20))
    grid.name = name
    grid.gridClass = kind
    grid.transform = pyopenvdb.createLinearTransform(voxelSize=0.5)
    return grid
mask = pyopenvdb.BoolGrid()
mask.name = "mask"
pyopenvdb.write(sys.argv[1], grids=[mask, grid("smoke", pyopenvdb.GridClass.FOG_VOLUME),
                                    grid("solid", pyopenvdb.GridClass.LEVEL_SET)])
)";
  const std::string python = "/usr/bin/python3";
  if (test::run_process({python, "-c", "import numpy, pyopenvdb"}).exit_code != 0)
    GTEST_SKIP() << "no Python module of OpenVDB: ./dev programs installs it";
  const test::ProcessResult result = test::run_process({python, script, file("python.vdb").string()});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const auto fog = read_vdb(file("python.vdb"), {});
  const auto solid = read_vdb(file("python.vdb"), {"solid"});
  EXPECT_EQ(fog->kind(), VoxelField::Kind::fog) << "the first grid of floats";
  EXPECT_EQ(solid->kind(), VoxelField::Kind::level_set);
  ASSERT_EQ(solid->size(), Eigen::Vector3i(16, 9, 11));
  double worst = 0;
  for (int i = 0; i < 16; ++i)
    for (int j = 0; j < 9; ++j)
      for (int k = 0; k < 11; ++k) {
        const double exact = 0.2 * std::sin(2 * M_PI * i / 16) + 0.5 * (j - 4.25) + 0.125 * k;
        const Vec3d at(i + 0.5, j + 0.5, k + 0.5);
        worst = std::max(worst, std::abs(static_cast<double>(fog->at(at, {true})) - exact));
        worst = std::max(worst, std::abs(0.5 * static_cast<double>(solid->at(at, {true})) - exact));
      }
  EXPECT_LT(worst, 1e-6);
}

TEST_F(VdbReader, MakesALevelSetOfAFogVolume) {
  openvdb::initialize();
  const auto fog = openvdb::FloatGrid::create(0);
  fog->setTransform(openvdb::math::Transform::createLinearTransform(2));
  // A ball whose density falls by 0.1 a voxel and is 0.4 at radius 6.
  for (int i = -12; i <= 12; ++i)
    for (int j = -12; j <= 12; ++j)
      for (int k = -12; k <= 12; ++k) {
        const double density = 0.4 + 0.1 * (6 - std::sqrt(i * i + j * j + k * k));
        if (density > 0) fog->tree().setValueOn({i, j, k}, static_cast<float>(density));
      }
  const auto path = write({fog});
  EXPECT_EQ(read_vdb(path, {})->kind(), VoxelField::Kind::fog);
  const auto ball = read_vdb(path, {"", 0.4});
  ASSERT_EQ(ball->kind(), VoxelField::Kind::level_set);
  const double middle = ball->size().x() / 2.0;
  double worst = 0;
  for (double x = 3; x < 9; x += 0.1)
    worst =
        std::max(worst, std::abs(static_cast<double>(ball->at({middle + x, middle, middle}, {})) - (x - 6)));
  std::cout << "distances of a fog volume are off by " << worst << " voxels\n";
  EXPECT_LT(worst, 0.15);
}

TEST_F(VdbReader, NamesWhatIsWrongWithAFile) {
  EXPECT_NE(refusal(file("none.vdb")), "none");
  const auto ball = ball_grid({0, 0, 0}, 1);
  const std::string whole = read_file(write({ball}));
  int refused = 0;
  for (std::size_t size = 0; size < whole.size(); size += std::max<std::size_t>(1, whole.size() / 60)) {
    std::ofstream(file("cut.vdb"), std::ios::binary).write(whole.data(), static_cast<std::streamsize>(size));
    EXPECT_NE(refusal(file("cut.vdb")), "none") << size << " of " << whole.size();
    ++refused;
  }
  EXPECT_GE(refused, 60);
  std::ofstream(file("text.vdb")) << "# no volume at all, but a text of some length\n";
  EXPECT_NE(refusal(file("text.vdb")), "none");

  const auto vectors = openvdb::Vec3SGrid::create();
  EXPECT_EQ(refusal(write({vectors})), ": has no grid of floats");
  EXPECT_EQ(refusal(write({ball}), {"cube"}), ": has no grid of floats named 'cube'");
  EXPECT_EQ(refusal(write({openvdb::FloatGrid::create(0)})), ": grid '' is empty");

  const auto not_finite = ball->deepCopy();
  not_finite->tree().setValueOn({8, 0, 0}, std::numeric_limits<float>::quiet_NaN());
  EXPECT_EQ(refusal(write({not_finite})), ": grid 'ball': the value at voxel (8, 0, 0) is nan");

  const auto flat = ball->deepCopy();
  flat->setTransform(openvdb::math::Transform::createLinearTransform(1));
  flat->transform().preScale(openvdb::Vec3d(1, 1, 2));
  EXPECT_EQ(refusal(write({flat})), ": grid 'ball': its voxels are no cubes of one size");

  const auto far = ball->deepCopy();
  far->tree().setValueOn({20000, 20000, 0}, 0);
  EXPECT_EQ(refusal(write({far})),
            ": grid 'ball': its box of 20011 x 20011 x 21 voxels holds more than 268435456");
}

}  // namespace
}  // namespace burin
