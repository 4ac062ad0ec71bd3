// Boxes and pipes bent along strokes, whose volume is known, by Pappus where their middle runs along the
// stroke.
#include <burin/along/along_parts.h>
#include <burin/base/parallel.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <numbers>
#include <string>

#include "along/bent.h"
#include "support/error_of.h"
#include "support/rods.h"
#include "support/shapes.h"

namespace burin {
namespace {

using std::numbers::pi;
using test::Laid;

constexpr double radius = 0.1;
constexpr double chord = radius / 500;

/// 2 radii wide, 1 high, 4 long.
AlongSettings boxes() { return {.middle = test::source(test::box(4, 1, 2)), .start = {}, .end = {}}; }
AlongSettings pipes() { return {.middle = test::source(test::pipe(4, 1, 2)), .start = {}, .end = {}}; }
constexpr double section = 2 * radius * radius;

Laid straight(double length = 1) {
  return {test::plane(1, 0.03, 7), radius,
          test::sampled(40, [=](double s) { return Vec3d(length * (s - 0.5), 0.02, 0); })};
}

std::vector<Vec3d> round(double r, double z = 0) {
  return test::sampled(
      240, [=](double s) { return Vec3d(r * std::cos(2 * pi * s), r * std::sin(2 * pi * s), z); });
}

Laid ring_on_plane() { return {test::plane(1, 0.02, 7), radius, round(0.5), true}; }
Laid ring_around_cylinder() {
  return {test::cylinder(0.5, 0.6, 0.02, 0.2, 5), radius, round(0.5, 0.02), true};
}
Laid ring_around_sphere() { return {test::sphere(6, 0.2, 4), radius, round(1), true}; }

void expect_volume(const char* name, const TriangleMesh& mesh, double volume, double share) {
  const double found = test::extent_of(mesh).volume;
  std::cout << fmt::format("{}: volume {:+.4f} %, {} triangles\n", name, 100 * (found / volume - 1),
                           mesh.triangles.size());
  EXPECT_NEAR(found, volume, share * volume);
}

void expect_closed(const TriangleMesh& mesh, long euler) {
  const test::Edges edges = test::edges_of(mesh);
  EXPECT_EQ(edges.open, 0u);
  EXPECT_EQ(edges.multi, 0u);
  EXPECT_EQ(edges.euler, euler);
}

// Three copies of 1 / 0.4 fit best.
TEST(AlongParts, StayBoxesAlongAStraightStroke) {
  const TriangleMesh mesh = straight(1.19).bend(boxes());
  EXPECT_EQ(mesh.triangles.size(), 36u);
  expect_closed(mesh, 6);
  expect_volume("boxes", mesh, 1.19 * section, 1e-5);
  for (const Vec3f& p : mesh.positions) {
    const double third = 3 * (static_cast<double>(p.x()) + 0.595) / 1.19;
    EXPECT_NEAR(third, std::round(third), 1e-4);
    EXPECT_NEAR(std::abs(static_cast<double>(p.y()) - 0.02), radius, 1e-5);
    EXPECT_NEAR(std::abs(static_cast<double>(p.z()) - radius / 2), radius / 2, 1e-6);
  }
}

TEST(AlongParts, BecomeARingAlongACircle) {
  const TriangleMesh mesh = ring_on_plane().bend(pipes());
  expect_closed(mesh, 0);
  expect_volume("ring on a plane", mesh, pi * section, 0.003);
  double farthest = 0;
  for (const Vec3f& p : mesh.positions) {
    const double off = std::abs(std::hypot(p.x(), p.y()) - 0.5F), up = static_cast<double>(p.z());
    EXPECT_LE(off, radius + 2e-4);
    farthest = std::max(farthest, std::min({radius - off, std::abs(up), std::abs(up - radius)}));
  }
  EXPECT_LT(farthest, 1e-3 * radius);
}

TEST(AlongParts, AreWiderAboveACylinder) {
  const TriangleMesh mesh = ring_around_cylinder().bend(pipes());
  expect_closed(mesh, 0);
  expect_volume("ring around a cylinder", mesh, 2 * pi * (0.5 + radius / 2) * section, 0.003);
  AlongSettings sunk = pipes();
  sunk.height = -0.5;
  expect_volume("half sunk", ring_around_cylinder().bend(sunk), pi * section, 0.003);
}

TEST(AlongParts, FollowAGreatCircle) {
  const TriangleMesh mesh = ring_around_sphere().bend(pipes());
  expect_closed(mesh, 0);
  const double shell = (std::pow(1 + radius, 3) - 1) / 3;
  expect_volume("great circle", mesh, 2 * pi * 2 * std::sin(radius) * shell, 0.003);
}

/// How far the middles of edges of the side walls are from the walls.
double wall_error(const TriangleMesh& mesh) {
  double most = 0;
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3d a = mesh.positions[t[i]].cast<double>(), b = mesh.positions[t[(i + 1) % 3]].cast<double>();
      const auto from_middle = [](const Vec3d& p) { return std::hypot(p.x(), p.y()); };
      for (const double wall : {0.5 - radius, 0.5 + radius})
        if (std::abs(from_middle(a) - wall) < 1e-4 && std::abs(from_middle(b) - wall) < 1e-4)
          most = std::max(most, std::abs(from_middle((a + b) / 2) - wall));
    }
  }
  return most;
}

TEST(AlongParts, AreRefinedToTheTolerance) {
  const TriangleMesh mesh = ring_on_plane().bend(pipes());
  EXPECT_LT(wall_error(mesh), 1.05 * chord);
  EXPECT_GT(wall_error(mesh), 0.2 * chord);
  EXPECT_LT(mesh.triangles.size(), 15000u);
}

TEST(AlongParts, KeepTextureCoordinates) {
  const Laid laid = ring_on_plane();
  const TriangleMesh mesh = laid.bend(pipes());
  ASSERT_EQ(mesh.triangle_uv.size(), mesh.triangles.size());
  const double copies = std::round(laid.chart.length / (4 * radius));
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3d p = mesh.positions[mesh.triangles[i][k]].cast<double>();
      const double turn = std::atan2(p.y(), p.x()) / (2 * pi) * copies;
      const double off = turn - static_cast<double>(mesh.triangle_uv[i][k].x());
      EXPECT_NEAR(off, std::round(off), 0.01);
    }
  }
}

TEST(AlongParts, HaveAStartAndAnEnd) {
  AlongSettings settings = pipes();
  settings.start = test::source(test::box(1, 1, 2));
  settings.end = test::source(test::box(2.6, 1, 2));
  const TriangleMesh mesh = straight().bend(settings);
  // The start lies on 0..0.1, the end on 0.74..1; 0.64 takes two of 0.4 best; those are one pipe.
  std::vector<double> borders;
  for (const Vec3f& p : mesh.positions) borders.push_back(static_cast<double>(p.x()) + 0.5);
  std::ranges::sort(borders);
  const auto count = [&](double at) {
    return std::ranges::count_if(borders, [&](double b) { return std::abs(b - at) < 1e-4; });
  };
  EXPECT_EQ(count(0), 4);
  EXPECT_EQ(count(0.1), 8);
  EXPECT_EQ(count(0.42), 4);
  EXPECT_EQ(count(0.74), 8);
  EXPECT_EQ(count(1), 4);
  EXPECT_EQ(borders.size(), 28u);
  EXPECT_EQ(mesh.triangle_uv.size(), mesh.triangles.size());
}

TEST(AlongParts, AreAsWideAsTheWidestOfThem) {
  AlongSettings settings = boxes();
  settings.end = test::source(test::box(3, 1, 4));
  const TriangleMesh mesh = straight().bend(settings);
  for (const Vec3f& p : mesh.positions) {
    // Box ends at z = 4 reach 3 from the middle of the repeated one.
    EXPECT_GT(p.y(), 0.02 - radius - 1e-5);
    EXPECT_LT(p.y(), 0.02 + radius / 3 + 1e-5);
  }
}

TEST(AlongParts, StandApart) {
  AlongSettings settings = boxes();
  settings.spacing = 4.5;
  const TriangleMesh mesh = straight().bend(settings);
  EXPECT_EQ(mesh.triangles.size(), 24u);
  expect_volume("two boxes", mesh, 2 * 0.4 * section, 1e-5);
}

// The section turns about its middle and fills the width as it turns.
TEST(AlongParts, Twist) {
  AlongSettings settings{.middle = test::source(test::box(4, 2, 2)), .start = {}, .end = {}};
  settings.twist = 0.5;
  const TriangleMesh mesh = straight().bend(settings);
  expect_closed(mesh, 8);
  const double half = radius / std::sqrt(2.);
  expect_volume("twisted", mesh, 4 * half * half, 0.005);
  for (const Vec3f& p : mesh.positions) {
    const double angle = -pi * (static_cast<double>(p.x()) + 0.5);
    const double left = static_cast<double>(p.y()) - 0.02, up = static_cast<double>(p.z()) - half;
    const double a = std::cos(angle) * left + std::sin(angle) * up;
    const double b = -std::sin(angle) * left + std::cos(angle) * up;
    EXPECT_LT(std::max(std::abs(a), std::abs(b)), half + 1e-5);
  }
}

// Up goes to the left, so that it is counter-clockwise seen along the stroke.
TEST(AlongParts, TwistCounterClockwise) {
  PolygonMesh ridge = test::box(4, 1, 1);
  AlongSettings settings{.middle = test::source(ridge), .start = {}, .end = {}};
  settings.twist = 0.25;
  settings.spacing = 100;
  const Laid laid = straight();
  settings.middle = test::source([] {
    PolygonMesh mesh = test::box(10, 1, 0.2);
    return mesh;
  }());
  const TriangleMesh mesh = laid.bend(settings);
  // A wall whose upper edge lies on the left at the end.
  double leftmost = -1;
  for (const Vec3f& p : mesh.positions)
    if (p.x() > 0.49F) leftmost = std::max(leftmost, static_cast<double>(p.y()) - 0.02);
  EXPECT_GT(leftmost, 0.9 * radius);
}

TEST(AlongParts, TwistWholeTurnsOnClosedStrokes) {
  AlongSettings settings{.middle = test::source(test::pipe(4, 2, 2)), .start = {}, .end = {}};
  settings.twist = 2.3;
  expect_closed(ring_on_plane().bend(settings), 0);
}

TEST(AlongParts, AreAsWideAsTheStrokeIs) {
  const auto width = [](double t) { return 1 - t / 2; };
  const TriangleMesh mesh = straight().bend(pipes(), width);
  int at_rim = 0;
  double volume = 0;
  for (const Vec3f& p : mesh.positions) {
    const double w = width(static_cast<double>(p.x()) + 0.5);
    const double off = std::abs(static_cast<double>(p.y()) - 0.02) - w * radius;
    EXPECT_LT(off, 1e-5);
    if (off > -1e-5) ++at_rim;
  }
  EXPECT_GT(at_rim, 10);
  const TriangleMesh solid = straight().bend(boxes(), width);
  for (double t = 0.0005; t < 1; t += 0.001) volume += 0.001 * width(t) * width(t) * section;
  expect_volume("taper", solid, volume, 0.003);
}

TEST(AlongParts, AreMirroredWithTheirStroke) {
  PolygonMesh wedge = test::box(4, 1, 2);
  for (Vec3f& p : wedge.positions)
    if (p.z() > 1) p.y() *= 0.5F;
  const AlongSettings settings{.middle = test::source(wedge), .start = {}, .end = {}};
  const Laid laid = straight();
  const TriangleMesh plain = laid.bend(settings), mirrored = laid.bend(settings, {}, true);
  EXPECT_NEAR(test::extent_of(mirrored).volume, test::extent_of(plain).volume, 1e-6);
  const auto least = [](const TriangleMesh& mesh, float side) {
    float top = 0;
    for (const Vec3f& p : mesh.positions)
      if ((p.y() - 0.02F) * side > 0) top = std::max(top, p.z());
    return top;
  };
  // z of the source is to the right.
  EXPECT_NEAR(static_cast<double>(least(plain, -1)), radius / 2, 1e-5);
  EXPECT_NEAR(static_cast<double>(least(mirrored, 1)), radius / 2, 1e-5);
}

TEST(AlongParts, LeaveClosedBoxesApartAroundAClosedStroke) {
  const TriangleMesh mesh = ring_on_plane().bend(boxes());
  expect_closed(mesh, 2 * 8);
}

// A knot that crosses itself, and bends sharper than it is wide.
TEST(AlongParts, AreSoundWhereTheStrokeOverlapsItself) {
  const auto way = [](double s) {
    const double a = 2 * pi * s;
    return Vec3d(0.5 * std::sin(2 * a), 0.35 * std::sin(3 * a + 0.4), 0);
  };
  const Laid laid(test::plane(1, 0.02, 7), 0.15, test::sampled(400, way), true);
  const TriangleMesh mesh = laid.bend(pipes());
  expect_closed(mesh, 0);
  std::cout << mesh.triangles.size() << " triangles\n";
  EXPECT_LT(mesh.triangles.size(), 300000u);
  for (const Vec3f& p : mesh.positions) {
    ASSERT_TRUE(p.allFinite());
    EXPECT_LT(p.cwiseAbs().maxCoeff(), 0.75F);
  }
}

TEST(AlongParts, AreNoneOfAPoint) {
  const Laid laid(test::plane(0.8, 0.05, 7), radius, {Vec3d(0, 0, 0)});
  EXPECT_TRUE(laid.bend(boxes()).triangles.empty());
}

TEST(AlongParts, OfAnUprightSheetAreAsHighAsTheStrokeIsWide) {
  PolygonMesh sheet;
  sheet.positions = {{0, 0, 0}, {4, 0, 0}, {4, 1, 0}, {0, 1, 0}};
  sheet.face_sizes = {4};
  sheet.face_vertices = {0, 1, 2, 3};
  const TriangleMesh mesh = straight().bend({.middle = test::source(sheet), .start = {}, .end = {}});
  EXPECT_NEAR(test::extent_of(mesh).area, 2 * radius, 1e-5);
}

TEST(AlongParts, RefuseWhatCannotBeBent) {
  const auto with = [](const MeshSource& source) {
    return test::error_of([&] { AlongParts({.middle = source, .start = {}, .end = {}}); });
  };
  EXPECT_EQ(with({{}, "nowhere.obj"}), "nowhere.obj: No such file or directory");
  EXPECT_EQ(with(test::source(test::box(0, 1, 1))), "the mesh has no length along the stroke");
  EXPECT_EQ(with(test::source(test::box(1, 0, 0))), "the mesh along the stroke has no width");
  AlongSettings dense = boxes();
  dense.spacing = 1e-7;
  EXPECT_EQ(test::error_of([&] { straight().bend(dense); }),
            "the stroke would take 6e+07 copies of the mesh");
}

TEST(AlongParts, HaveTheSameBitsOnOneThread) {
  const Laid laid = ring_around_cylinder();
  const TriangleMesh all = laid.bend(pipes());
  const ThreadLimit one(1);
  const TriangleMesh alone = laid.bend(pipes());
  EXPECT_TRUE(all.positions == alone.positions);
  EXPECT_TRUE(all.triangles == alone.triangles);
}

}  // namespace
}  // namespace burin
