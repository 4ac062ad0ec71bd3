#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/base/trees/bounding_box.h>
#include <burin/subdiv/sculpt_levels.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "subdiv/cages.h"

namespace burin {
namespace {

using test::plate, test::shared_mesh, test::tetrahedron;

using test::catmull_clark, test::loop;

using Positions = std::vector<Vec3f>;

bool same_bits(std::span<const Vec3f> a, std::span<const Vec3f> b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
}

double farthest(std::span<const Vec3f> a, std::span<const Vec3f> b) {
  double result = a.size() == b.size() ? 0 : std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < a.size(); ++i) result = std::max(result, (a[i] - b[i]).cast<double>().norm());
  return result;
}

Positions copy(std::span<const Vec3f> positions) { return {positions.begin(), positions.end()}; }

std::vector<Positions> all_levels(const SculptLevels& levels) {
  std::vector<Positions> result;
  for (int level = 0; level <= levels.finest(); ++level) result.push_back(copy(levels.positions(level)));
  return result;
}

struct NamedCage {
  std::string name;
  PolygonMesh cage;
  SubdivisionScheme scheme;
};

/// Creases, corners, boundaries, n-gons, poles, both schemes; those of the shared data where it is there.
std::vector<NamedCage> cages() {
  std::vector<NamedCage> result = {
      {"tetrahedron", tetrahedron(), loop},
      {"tetrahedron of quads", tetrahedron(), catmull_clark},
      {"plate", plate(4), catmull_clark},
  };
  result[0].cage.corners = {{1, 10}, {2, 1}};
  result[1].cage.creases = {{0, 1, 2.5F}};
  for (const char* name : {"car", "cube", "cube_creases0", "edgecorner", "helmet", "nonquads", "pawn",
                           "pole64", "tent", "torus"})
    if (auto cage = shared_mesh(std::string("opensubdiv/catmark_") + name + ".obj"))
      result.push_back({name, std::move(*cage), catmull_clark});
  for (const char* name : {"spot_control_mesh.obj", "penguin_control_mesh.obj"})
    if (auto cage = shared_mesh(name)) result.push_back({name, std::move(*cage), catmull_clark});
  return result;
}

/// A level as strokes may sculpt it: a bump with a few broad waves, and some noise at a few vertices.
Positions sculpted(std::span<const Vec3f> positions, double size, std::mt19937& random) {
  std::uniform_real_distribution<float> unit(-1, 1);
  std::normal_distribution<float> normal;
  const auto direction = [&] { return Vec3f(normal(random), normal(random), normal(random)).normalized(); };
  const auto scale = static_cast<float>(size);
  const Vec3f centre = positions[random() % positions.size()], push = 0.1F * scale * direction();
  const Vec3f wave = direction() * 20 / scale;
  Positions result = copy(positions);
  for (Vec3f& p : result) {
    const float fall_off = std::exp(-(p - centre).squaredNorm() / (0.05F * scale * scale));
    p += fall_off * (1 + std::sin(wave.dot(p - centre))) * push;
    if (random() % 4 == 0) p += 0.003F * scale * unit(random) * direction();
  }
  return result;
}

TEST(SculptLevels, WithoutDetailsGiveWhatRefineGives) {
  for (const auto& [name, cage, scheme] : cages()) {
    const SculptLevels levels(cage, scheme, 3);
    for (int level = 0; level <= 3; ++level) {
      SCOPED_TRACE(testing::Message() << name << " level " << level);
      const TriangleMesh expected = refine(cage, scheme, level), mesh = levels.mesh(level);
      EXPECT_TRUE(same_bits(levels.positions(level), expected.positions));
      EXPECT_TRUE(same_bits(mesh.positions, expected.positions));
      EXPECT_EQ(mesh.triangles, expected.triangles);
    }
  }
}

TEST(SculptLevels, KeepDetailsBitForBitWhenTheCageIsMovedBack) {
  for (const auto& [name, cage, scheme] : cages()) {
    SCOPED_TRACE(name);
    SculptLevels levels(cage, scheme, 2);
    std::mt19937 random(7);
    const double size = bounding_box_diagonal(cage.positions);
    levels.set_positions(2, sculpted(levels.positions(2), size, random));
    const std::vector<Positions> before = all_levels(levels);
    levels.set_positions(0, sculpted(before[0], size, random));
    EXPECT_GT(farthest(levels.positions(2), before[2]), 0.01 * size);
    levels.set_positions(0, before[0]);
    for (int level = 0; level <= 2; ++level)
      EXPECT_TRUE(same_bits(levels.positions(level), before[static_cast<std::size_t>(level)])) << level;
  }
}

TEST(SculptLevels, GoUpAndDownWithoutLoss) {
  constexpr int finest = 3;
  int with_details = 0, tried = 0;
  for (const auto& [name, cage, scheme] : cages()) {
    for (const unsigned seed : {1U, 2U}) {
      SCOPED_TRACE(testing::Message() << name << " seed " << seed);
      std::mt19937 random(seed);
      SculptLevels levels(cage, scheme, finest);
      const double size = bounding_box_diagonal(cage.positions);
      for (int stroke = 0; stroke < 8; ++stroke) {
        const int level = static_cast<int>(random() % (finest + 1));
        const Positions given = sculpted(levels.positions(level), size, random);
        levels.set_positions(level, given);
        EXPECT_LE(farthest(levels.positions(level), given), 1e-6 * size);
        const std::vector<Positions> now = all_levels(levels);
        for (int other = 0; other <= finest; ++other)
          levels.set_positions(other, copy(levels.positions(other)));
        levels.set_positions(0, copy(levels.positions(0)));
        EXPECT_EQ(all_levels(levels), now);
      }
      PolygonMesh bare = cage;
      bare.positions = copy(levels.positions(0));
      ++tried;
      with_details +=
          farthest(refine(bare, scheme, finest).positions, levels.positions(finest)) > 0.01 * size ? 1 : 0;
    }
  }
  EXPECT_EQ(with_details, tried);
}

TEST(SculptLevels, TurnDetailsWithACoarseLevel) {
  for (const auto& [name, cage, scheme] : cages()) {
    for (int turned = 0; turned <= 2; ++turned) {
      SCOPED_TRACE(testing::Message() << name << " level " << turned);
      std::mt19937 random(3);
      SculptLevels levels(cage, scheme, 3);
      const double size = bounding_box_diagonal(cage.positions);
      levels.set_positions(3, sculpted(levels.positions(3), size, random));
      Eigen::Isometry3f motion(Eigen::AngleAxisf(2.2F, Vec3f(1, -2, 0.5F).normalized()));
      motion.translation() = static_cast<float>(0.3 * size) * Vec3f(1, 2, -1);
      const auto moved = [&](std::span<const Vec3f> positions) {
        Positions result;
        for (const Vec3f& p : positions) result.push_back(motion * p);
        return result;
      };
      std::vector<Positions> expected;
      for (const Positions& level : all_levels(levels)) expected.push_back(moved(level));
      levels.set_positions(turned, moved(levels.positions(turned)));
      // Positions are floats, and their rounding turns frames of small faces, like the car's.
      for (int level = turned; level <= 3; ++level)
        EXPECT_LE(farthest(levels.positions(level), expected[static_cast<std::size_t>(level)]), 1e-5 * size)
            << level;
    }
  }
}

// Along the curved direction Catmull-Clark subdivision of a grid is that of cubic B-splines: of points at
// angles i h of a circle of radius R it puts a vertex's child at R (6 + 2 cos h) / 8 and an edge's at
// R cos(h / 2), at their own angles. The normals there are radial, by symmetry, so details turn by the angle.
TEST(SculptLevels, BendAPlateUnderItsBumps) {
  constexpr Index cells = 12;
  constexpr double radius = 5;
  const PolygonMesh cage = plate(cells);
  SculptLevels levels(cage, catmull_clark, 1);
  const Positions flat = copy(levels.positions(1));
  Positions bumpy = flat;
  for (Vec3f& p : bumpy) p.z() += 0.2F * std::sin(5 * p.x()) * std::cos(4 * p.y());
  levels.set_positions(1, bumpy);
  levels.set_positions(0, cage.positions);
  bumpy = copy(levels.positions(1));
  Positions bent;
  for (const Vec3f& p : cage.positions) {
    const double angle = p.x() / radius;
    bent.push_back(Vec3d(radius * std::sin(angle), p.y(), radius * std::cos(angle)).cast<float>());
  }
  levels.set_positions(0, bent);
  double highest = 0;
  int compared = 0;
  for (std::size_t i = 0; i < flat.size(); ++i) {
    // The ends are skipped, where the boundary rule applies.
    const double x = flat[i].x();
    if (x < 1.1 || x > cells - 1.1) continue;
    const bool on_vertex = std::abs(x - std::round(x)) < 0.1;
    const double h = 1 / radius;
    const double distance = radius * (on_vertex ? (6 + 2 * std::cos(h)) / 8 : std::cos(h / 2));
    const Vec3d detail = (bumpy[i] - flat[i]).cast<double>();
    const Eigen::AngleAxisd turn(x / radius, Vec3d::UnitY());
    const Vec3d expected = turn * (Vec3d(0, flat[i].y(), distance) + detail);
    EXPECT_LE((levels.positions(1)[i].cast<double>() - expected).norm(), 4e-6) << flat[i].transpose();
    highest = std::max(highest, detail.z());
    ++compared;
  }
  EXPECT_GT(highest, 0.1);
  EXPECT_EQ(compared, 19 * 25);
}

TEST(SculptLevels, CoarserLevelsFollowWhatTheyCanShow) {
  constexpr Index cells = 8;
  constexpr float slope = 0.25F;
  SculptLevels levels(plate(cells), catmull_clark, 3);
  const Positions flat = copy(levels.positions(0));
  Positions tilted = copy(levels.positions(3));
  for (Vec3f& p : tilted) p.z() = slope * std::max(p.x() - 4, 0.0F);
  levels.set_positions(3, tilted);
  // Means over symmetric neighbours keep planes; vertices on the fold and at the border see more.
  int compared = 0;
  for (std::size_t i = 0; i < flat.size(); ++i) {
    const Vec3f& p = flat[i];
    EXPECT_EQ(levels.positions(0)[i].head<2>(), p.head<2>());
    if (p.x() < 3.5F) {
      EXPECT_EQ(levels.positions(0)[i].z(), 0);
    }
    if (p.x() < 4.5F || p.x() > 6.5F || p.y() < 1.5F || p.y() > 6.5F) continue;
    EXPECT_NEAR(levels.positions(0)[i].z(), slope * (p.x() - 4), 1e-6);
    ++compared;
  }
  EXPECT_EQ(compared, 2 * 5);
}

TEST(SculptLevels, CoarserLevelsStayFarFromAStroke) {
  SculptLevels levels(plate(8), catmull_clark, 2);
  const std::vector<Positions> before = all_levels(levels);
  Positions pulled = before[2];
  std::size_t moved = 0;
  for (Vec3f& p : pulled)
    if ((p - Vec3f(2, 2, 0)).norm() < 1) {
      p.z() = 1;
      ++moved;
    }
  ASSERT_GT(moved, 20U);
  levels.set_positions(2, pulled);
  EXPECT_GT(levels.positions(0)[2 * 9 + 2].z(), 0.7);
  for (std::size_t i = 0; i < before[0].size(); ++i)
    if ((before[0][i] - Vec3f(2, 2, 0)).norm() > 3) {
      EXPECT_EQ(levels.positions(0)[i], before[0][i]);
    }
  EXPECT_LE(farthest(levels.positions(2), pulled), 1e-6);
}

TEST(SculptLevels, KeepDetailsOnWhatHasNoDirection) {
  PolygonMesh cage = plate(4);
  SculptLevels levels(cage, catmull_clark, 2);
  std::mt19937 random(5);
  levels.set_positions(2, sculpted(levels.positions(2), 4, random));
  const std::vector<Positions> before = all_levels(levels);
  for (const float width : {0.0F, 1e-30F, 1e-12F}) {
    SCOPED_TRACE(width);
    Positions collapsed = before[0];
    for (Vec3f& p : collapsed) p = {width * p.x(), 0, p.y()};
    levels.set_positions(0, collapsed);
    EXPECT_TRUE(std::ranges::all_of(levels.positions(2), [](const Vec3f& p) { return p.allFinite(); }));
    const std::vector<Positions> needle = all_levels(levels);
    const Positions given = sculpted(needle[2], 4, random);
    levels.set_positions(2, given);
    EXPECT_LE(farthest(levels.positions(2), given), 4e-6);
    const std::vector<Positions> now = all_levels(levels);
    levels.set_positions(0, needle[0]);
    levels.set_positions(0, now[0]);
    EXPECT_EQ(all_levels(levels), now);
    levels.set_positions(2, before[2]);
  }
}

TEST(SculptLevels, GiveTheSameBitsOnAnyNumberOfThreads) {
  const auto result = [] {
    SculptLevels levels(plate(40), catmull_clark, 2);
    std::mt19937 random(11);
    for (const int level : {2, 0, 1})
      levels.set_positions(level, sculpted(levels.positions(level), 40, random));
    return all_levels(levels);
  };
  const std::vector<Positions> expected = result();
  for (const std::size_t threads : {1, 3}) {
    const ThreadLimit limit(threads);
    EXPECT_EQ(result(), expected);
  }
}

TEST(SculptLevels, RefuseWhatIsNoLevel) {
  SculptLevels levels(plate(2), catmull_clark, 2);
  const std::vector<Positions> before = all_levels(levels);
  EXPECT_THROW(levels.positions(3), ContractError);
  EXPECT_THROW(levels.positions(-1), ContractError);
  EXPECT_THROW(levels.set_positions(1, before[2]), ContractError);
  Positions broken = before[2];
  broken[3].y() = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(levels.set_positions(2, broken), Error);
  EXPECT_EQ(all_levels(levels), before);
  EXPECT_THROW(SculptLevels(plate(2), catmull_clark, 0), Error);
  EXPECT_THROW(SculptLevels(plate(2), loop, 1), Error);
  EXPECT_THROW(SculptLevels(plate(2), catmull_clark, 16), Error);
}

}  // namespace
}  // namespace burin
