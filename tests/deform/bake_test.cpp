#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/deform/bake.h>
#include <burin/surface/surface.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/error_of.h"
#include "support/shapes.h"

namespace burin {
namespace {

constexpr double pi = std::numbers::pi;

/// Gives every corner the texture coordinates of its position.
TriangleMesh with_uv(TriangleMesh mesh, const std::function<Vec2d(const Vec3d&)>& uv) {
  for (const Triangle& triangle : mesh.triangles) {
    TriangleUv& corners = mesh.triangle_uv.emplace_back();
    for (std::size_t i = 0; i < 3; ++i)
      corners[i] = uv(mesh.positions[triangle[i]].cast<double>()).cast<float>();
  }
  return mesh;
}

/// A value of the image between texel centres; beyond the outermost those hold.
Vec3d lookup(const FloatImage& image, const Vec2f& uv) {
  const auto place = [](double at, int size) { return std::clamp(at * size - 0.5, 0.0, size - 1.0); };
  const double x = place(uv.x(), image.width), y = place(1 - double{uv.y()}, image.height);
  const int left = std::min(static_cast<int>(x), image.width - 2),
            top = std::min(static_cast<int>(y), image.height - 2);
  Vec3d sum = Vec3d::Zero();
  for (const int row : {top, top + 1})
    for (const int column : {left, left + 1}) {
      const double weight = (1 - std::abs(x - column)) * (1 - std::abs(y - row));
      const std::size_t channels = image.channels.size();
      for (std::size_t c = 0; c < channels; ++c)
        sum[static_cast<int>(c)] +=
            weight * image.texels[static_cast<std::size_t>(row * image.width + column) * channels + c];
    }
  return sum;
}

using Apply = std::function<Vec3d(Index vertex, const Vec3d& value)>;

/// The difference between `displaced` and the positions by the map, base + apply(value at the texture
/// coordinates), over all corners.
struct MapError {
  double worst = 0, root_mean_square = 0;
};

MapError map_error(const TriangleMesh& base, std::span<const Vec3f> displaced, const FloatImage& image,
                   const Apply& apply) {
  MapError error;
  for (std::size_t i = 0; i < base.triangles.size(); ++i)
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const Index vertex = base.triangles[i][corner];
      const Vec3d moved =
          base.positions[vertex].cast<double>() + apply(vertex, lookup(image, base.triangle_uv[i][corner]));
      const double distance = (moved - displaced[vertex].cast<double>()).norm();
      error.worst = std::max(error.worst, distance);
      error.root_mean_square += distance * distance / (3.0 * static_cast<double>(base.triangles.size()));
    }
  error.root_mean_square = std::sqrt(error.root_mean_square);
  return error;
}

/// Maps of 64 to 512 texels a side are off by at most `slope` times their texels, of 1 / size, and the error
/// falls with these.
void expect_convergence(const TriangleMesh& base, const std::vector<Vec3f>& displaced, bool vectors,
                        double slope, const Apply& apply) {
  double coarsest = 0;
  for (const int size : {64, 128, 256, 512}) {
    const BakedMap map = bake_displacement(base, displaced, {.size = size, .vectors = vectors});
    const MapError error = map_error(base, displaced, map.image, apply);
    std::cout << size << " texels: off by at most " << error.worst << ", RMS " << error.root_mean_square
              << "\n";
    EXPECT_LE(error.worst, slope / size);
    if (size == 64) coarsest = error.root_mean_square;
    if (size == 512) {
      EXPECT_LE(error.root_mean_square, coarsest / 5);
    }
    EXPECT_EQ(map.overlaps, 0U);
    EXPECT_EQ(map.cut, 0U);
  }
}

TEST(Bake, HeightsOfAPlaneGiveItsDisplacementBack) {
  const TriangleMesh base = with_uv(
      test::plane(1, 0.05, 3), [](const Vec3d& p) -> Vec2d { return 0.4 * p.head<2>() + Vec2d(0.5, 0.5); });
  std::vector<Vec3f> displaced = base.positions;
  for (Vec3f& p : displaced) p.z() += 0.1F * std::sin(3 * p.x()) * std::cos(2 * p.y()) + 0.3F;
  // The map's slope is 0.36 at most and the map spans 2.5 units; lookups smooth kinks at vertices over part
  // of a texel.
  expect_convergence(base, displaced, false, 0.36 * 2.5 / 4, [](Index, const Vec3d& value) -> Vec3d {
    return {0, 0, value.x()};
  });
}

/// Half of a cylinder of radius 1 about the z axis, u around it, v along it.
TriangleMesh half_pipe() {
  const TriangleMesh mesh =
      test::patch({.u_min = 0, .u_max = pi, .v_min = -1, .v_max = 1, .cells_u = 90, .cells_v = 60},
                  [](double u, double v) -> Vec3d {
                    return {std::cos(u), std::sin(u), v};
                  });
  return with_uv(mesh, [](const Vec3d& p) -> Vec2d {
    return {0.1 + 0.8 * std::atan2(p.y(), p.x()) / pi, 0.5 + 0.4 * p.z()};
  });
}

/// Around, along, outward.
Eigen::Matrix3d pipe_frame(const Vec3d& p) {
  const Vec3d out = Vec3d(p.x(), p.y(), 0).normalized();
  Eigen::Matrix3d frame;
  frame << Vec3d::UnitZ().cross(out), Vec3d::UnitZ(), out;
  return frame;
}

Vec3d pipe_vector(const Vec3d& p) {
  const double angle = std::atan2(p.y(), p.x());
  return {0.05 * std::sin(2 * angle), 0.08 * std::cos(3 * p.z()), 0.1 * std::sin(angle + 2 * p.z())};
}

TEST(Bake, VectorsOfACylinderGiveItsDisplacementBack) {
  const TriangleMesh base = half_pipe();
  std::vector<Vec3f> displaced = base.positions;
  for (Vec3f& p : displaced) {
    const Vec3d position = p.cast<double>();
    p += (pipe_frame(position) * pipe_vector(position)).cast<float>();
  }
  // Facets have normals and tangents of their own.
  const Surface surface = make_surface(base);
  std::vector<Eigen::Matrix3d> frames(base.positions.size());
  for (Index v = 0; v < surface.vertex_count(); ++v) {
    const Vec3d n = surface.normals[v].cast<double>();
    const Vec3d around = pipe_frame(surface.positions[v].cast<double>()).col(0);
    const Vec3d t = (around - around.dot(n) * n).normalized();
    frames[surface.source_vertex[v]] << t, n.cross(t), n;
  }
  // The slope is 0.34 at most, and the map spans pi / 0.8 around.
  expect_convergence(base, displaced, true, 0.34 * pi / 0.8 / 4,
                     [&](Index vertex, const Vec3d& value) -> Vec3d { return frames[vertex] * value; });
}

TEST(Bake, HeightsAreAlongTheNormal) {
  const TriangleMesh base = half_pipe();
  std::vector<Vec3f> displaced = base.positions;
  for (Vec3f& p : displaced) {
    const Vec3d position = p.cast<double>();
    p += (pipe_frame(position) * pipe_vector(position)).cast<float>();
  }
  const BakedMap map = bake_displacement(base, displaced, {.size = 512});
  EXPECT_EQ(map.image.channels, std::vector<std::string>{"Y"});
  for (std::size_t i = 0; i < base.triangles.size(); ++i) {
    const Vec3d position = base.positions[base.triangles[i][0]].cast<double>();
    EXPECT_NEAR(lookup(map.image, base.triangle_uv[i][0]).x(), pipe_vector(position).z(), 0.002);
  }
}

TEST(Bake, TurnsTheFrameWithTheTextureCoordinates) {
  // u runs along -y of the plane, v along x; then the same mirrored: n x t stays to the left of t.
  for (const double mirror : {1.0, -1.0}) {
    const TriangleMesh base = with_uv(test::plane(1, 0.2, 3), [&](const Vec3d& p) -> Vec2d {
      return {0.5 - 0.4 * p.y(), 0.5 + mirror * 0.4 * p.x()};
    });
    std::vector<Vec3f> displaced = base.positions;
    for (Vec3f& p : displaced) p += Vec3f(0.1F, 0.2F, 0.3F);
    const BakedMap map = bake_displacement(base, displaced, {.size = 32, .vectors = true});
    const Vec3d value = lookup(map.image, {0.4F, 0.6F});
    EXPECT_LE((value - Vec3d(-0.2, 0.1, 0.3)).norm(), 1e-6) << value.transpose();
  }
}

TEST(Bake, WritesTheAxesAndTheMiddleThatAreAskedFor) {
  const TriangleMesh base = with_uv(test::plane(1, 0.2, 3), [&](const Vec3d& p) -> Vec2d {
    return {0.5 - 0.4 * p.y(), 0.5 + 0.4 * p.x()};
  });
  std::vector<Vec3f> displaced = base.positions;
  for (Vec3f& p : displaced) p += Vec3f(0.1F, 0.2F, 0.3F);
  BakeSettings settings{.size = 32, .vectors = true, .padding = 1};
  const auto value = [&] { return lookup(bake_displacement(base, displaced, settings).image, {0.4F, 0.6F}); };
  settings.axes = *math::vector_axes("x,z,-y");
  EXPECT_LE((value() - Vec3d(-0.2, 0.3, -0.1)).norm(), 1e-6);
  settings.middle = 0.5F;
  EXPECT_LE((value() - Vec3d(0.3, 0.8, 0.4)).norm(), 1e-6);
  EXPECT_EQ(bake_displacement(base, displaced, settings).image.texels[0], 0.5F);  // beyond the islands
  settings = {.size = 32, .vectors = true, .object_space = true};
  EXPECT_LE((value() - Vec3d(0.1, 0.2, 0.3)).norm(), 1e-6);
}

/// Six squares without common vertices, each moved outward by a distance of its own; islands in 3 x 2 cells.
TEST(Bake, DoesNotBleedAcrossSeams) {
  TriangleMesh base;
  std::vector<Vec3f> displaced;
  const auto distance = [](Index face) { return 1 + static_cast<float>(face); };
  for (Index face = 0; face < 6; ++face) {
    const Vec3f n = (face < 3 ? 1.0F : -1.0F) * Vec3f::Unit(static_cast<int>(face % 3));
    const Vec3f t = Vec3f::Unit(static_cast<int>((face + 1) % 3)), b = n.cross(t);
    const Vec2f cell(static_cast<float>(face % 3) / 3, static_cast<float>(face / 3) / 2);
    const Index first = 4 * face;
    TriangleUv corner_uv[2];
    Vec2f uv[4];
    for (Index i = 0; i < 4; ++i) {
      const float x = i == 1 || i == 2 ? 1.0F : 0.0F, y = i >= 2 ? 1.0F : 0.0F;
      base.positions.push_back(n + (2 * x - 1) * t + (2 * y - 1) * b);
      displaced.push_back(base.positions.back() + distance(face) * n);
      uv[i] = cell + Vec2f((0.1F + 0.8F * x) / 3, (0.1F + 0.8F * y) / 2);
    }
    base.triangles.push_back({first, first + 1, first + 2});
    base.triangles.push_back({first, first + 2, first + 3});
    corner_uv[0] = {uv[0], uv[1], uv[2]};
    corner_uv[1] = {uv[0], uv[2], uv[3]};
    base.triangle_uv.insert(base.triangle_uv.end(), corner_uv, corner_uv + 2);
  }
  for (const bool vectors : {false, true}) {
    const FloatImage image = bake_displacement(base, displaced, {.size = 128, .vectors = vectors}).image;
    for (Index triangle = 0; triangle < 12; ++triangle)
      for (int a = 0; a <= 20; ++a)
        for (int b = 0; a + b <= 20; ++b) {
          const TriangleUv& uv = base.triangle_uv[triangle];
          const Vec2f at = uv[0] + static_cast<float>(a) / 20 * (uv[1] - uv[0]) +
                           static_cast<float>(b) / 20 * (uv[2] - uv[0]);
          const Vec3d expected = distance(triangle / 2) * (vectors ? Vec3d::UnitZ() : Vec3d::UnitX());
          EXPECT_LE((lookup(image, at) - expected).norm(), 1e-5);
        }
  }
  const FloatImage bare = bake_displacement(base, displaced, {.size = 128, .padding = 0}).image;
  EXPECT_EQ(bare.texels[0], 0);
  EXPECT_LT(lookup(bare, base.triangle_uv[0][0]).x(), 0.9);
}

TEST(Bake, LetsTheFirstTriangleWinAndSaysSo) {
  TriangleMesh base;
  base.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}};
  base.triangles = {{0, 1, 2}, {0, 1, 1}, {3, 4, 5}};
  base.triangle_uv.assign(3, {Vec2f(0, 0), Vec2f(1, 0), Vec2f(1, 1)});
  std::vector<Vec3f> displaced = base.positions;
  for (std::size_t i = 0; i < 6; ++i) displaced[i].z() += i < 3 ? 0.25F : 0.5F;
  const BakedMap map = bake_displacement(base, displaced, {.size = 64});
  EXPECT_GT(map.overlaps, 64 * 64 / 2 - 2 * 64U);
  EXPECT_EQ(*std::ranges::max_element(map.image.texels), 0.25F);
}

TEST(Bake, IsTheSameOnAnyNumberOfThreads) {
  const TriangleMesh base = half_pipe();
  std::vector<Vec3f> displaced = base.positions;
  for (Vec3f& p : displaced) p *= 1.1F + 0.1F * std::sin(9 * p.z());
  const auto texels = [&] {
    return bake_displacement(base, displaced, {.size = 200, .vectors = true}).image.texels;
  };
  const std::vector<float> expected = texels();
  for (const std::size_t threads : {1, 3}) {
    const ThreadLimit limit(threads);
    EXPECT_EQ(texels(), expected);
  }
}

TEST(Bake, RefusesWhatHasNoTextureCoordinates) {
  TriangleMesh base = test::plane(1, 0.5, 1);
  EXPECT_THROW(bake_displacement(base, base.positions), ContractError);
  base = with_uv(base, [](const Vec3d& p) -> Vec2d { return p.head<2>(); });
  EXPECT_THROW(bake_displacement(base, std::vector<Vec3f>(3)), ContractError);
  EXPECT_THROW(bake_displacement(base, base.positions, {.size = 0}), ContractError);
}

std::string message(const PolygonMesh& mesh) {
  return test::error_of([&] { check_bakeable(mesh); });
}

TEST(Bake, SaysWhyAMeshCannotBeBaked) {
  PolygonMesh mesh;
  mesh.positions.resize(4, Vec3f::Zero());
  mesh.face_sizes = {3, 4};
  mesh.face_vertices = {0, 1, 2, 0, 1, 2, 3};
  EXPECT_EQ(message(mesh), "not every face has texture coordinates, which a map needs");
  mesh.corner_uv.assign(7, Vec2f(0.5F, 1));
  EXPECT_EQ(message(mesh), "none");
  mesh.corner_uv[4] = {1.4F, -0.01F};
  EXPECT_EQ(message(mesh), "none");
  mesh.corner_uv[6] = {3, 1};
  EXPECT_EQ(
      message(mesh),
      "face 2 lies around (1.35, 0.7475) in texture coordinates; a map holds those from 0 to 1, not further "
      "tiles (UDIM) or repetitions");
  mesh.corner_uv[2] = {0, -3};
  EXPECT_EQ(message(mesh).substr(0, 6), "face 1");
}

// The right half of a square has its texture coordinates on a line.
TEST(Bake, SaysWhatHasNoAreaInTheMap) {
  const TriangleMesh base = with_uv(test::plane(1, 0.1, 3), [](const Vec3d& p) {
    return Vec2d(p.x() < 1e-3 ? 0.5 + p.x() / 2 : 0.5, 0.5 + p.y() / 2);
  });
  EXPECT_EQ(bake_displacement(base, base.positions, {.size = 64}).without_area, 0U);
  std::vector<Vec3f> displaced = base.positions;
  for (Vec3f& p : displaced) p.z() += 0.1F;
  const std::size_t lost = bake_displacement(base, displaced, {.size = 64}).without_area;
  EXPECT_NEAR(static_cast<double>(lost), static_cast<double>(base.triangles.size()) / 2,
              0.15 * static_cast<double>(base.triangles.size()));
}

TEST(Bake, CutsOffWhatReachesOutsideAndSaysSo) {
  const TriangleMesh base = with_uv(
      test::plane(1, 0.1, 2), [](const Vec3d& p) -> Vec2d { return 0.5 * p.head<2>() + Vec2d(0.49, 0.5); });
  std::vector<Vec3f> displaced = base.positions;
  for (Vec3f& p : displaced) p.z() += 1 + 0.5F * p.x();
  const BakedMap map = bake_displacement(base, displaced, {.size = 100, .padding = 0});
  EXPECT_GE(map.cut, 20U);
  EXPECT_LT(map.cut, 80U);
  EXPECT_NEAR(map.image.texels[50 * 100], 1 + 0.5 * (2 * 0.005 - 0.98), 1e-5);
}

}  // namespace
}  // namespace burin
