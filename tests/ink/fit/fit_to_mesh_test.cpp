#include <burin/ink/fit/fit_to_mesh.h>
#include <gtest/gtest.h>

#include <random>
#include <set>

#include "support/shapes.h"

namespace burin {
namespace {

RecordedStroke stroke_of(const std::vector<Eigen::Vector2d>& places) {
  RecordedStroke stroke;
  for (const Eigen::Vector2d& place : places) stroke.samples.emplace_back().position << place, 0;
  return stroke;
}

/// A ring of radius 100 around (300, 700).
RecordedStroke ring() {
  std::vector<Eigen::Vector2d> places;
  for (int i = 0; i <= 60; ++i)
    places.emplace_back(300 + 100 * std::cos(i * 0.1), 700 + 100 * std::sin(i * 0.1));
  return stroke_of(places);
}

Camera front_camera() {
  return framing_camera({-1, -1, -1}, {1, 1, 1}, {0, 0, -1}, {0, 1, 0}, 800, 600, 0.6);
}

/// The number of places along all strokes, between samples too, at which the camera sees nothing.
int places_beside(const std::vector<RecordedStroke>& strokes, const Surface& surface) {
  const Picker picker(surface);
  int beside = 0;
  for (const RecordedStroke& stroke : strokes)
    for (std::size_t i = 1; i < stroke.samples.size(); ++i)
      for (double share = 0; share <= 1; share += 0.125) {
        const Vec3d at = (1 - share) * stroke.samples[i - 1].position + share * stroke.samples[i].position;
        if (!picker.pick(pixel_ray(front_camera(), at.x(), at.y()))) ++beside;
      }
  return beside;
}

double width_of(const std::vector<RecordedStroke>& strokes) {
  double least = 1e9, most = -1e9;
  for (const RecordedStroke& stroke : strokes)
    for (const Sample& sample : stroke.samples) {
      least = std::min(least, sample.position.x());
      most = std::max(most, sample.position.x());
    }
  return most - least;
}

TEST(FitToMesh, FillsASphere) {
  const Surface sphere = make_surface(test::sphere(5, 0, 1));
  std::vector<RecordedStroke> strokes = {ring()};
  ASSERT_TRUE(fit_to_mesh(strokes, front_camera(), sphere));
  EXPECT_EQ(places_beside(strokes, sphere), 0);
  std::vector<RecordedStroke> box = {stroke_of({{0, 0}, {9, 0}, {9, 9}, {0, 9}, {0, 0}})};
  ASSERT_TRUE(fit_to_mesh(box, front_camera(), sphere));
  EXPECT_EQ(places_beside(box, sphere), 0);
  EXPECT_GT(width_of(strokes), 1.3 * width_of(box)) << "a ring in a disc is wider than a square";
  EXPECT_GT(width_of(strokes), 400) << "of the about 540 pixels of the sphere";
}

TEST(FitToMesh, PutsARingAroundAHole) {
  // A square with a round hole: the shape around it fits, one across it does not at that size.
  TriangleMesh mesh = test::plane(1, 0.02, 3);
  std::erase_if(mesh.triangles,
                [&](const Triangle& triangle) { return mesh.positions[triangle[0]].norm() < 0.4F; });
  const Surface surface = make_surface(std::move(mesh));
  std::vector<RecordedStroke> around = {ring()};
  ASSERT_TRUE(fit_to_mesh(around, front_camera(), surface));
  EXPECT_EQ(places_beside(around, surface), 0);
  std::vector<RecordedStroke> across = {ring(), stroke_of({{200, 700}, {400, 700}})};
  ASSERT_TRUE(fit_to_mesh(across, front_camera(), surface));
  EXPECT_EQ(places_beside(across, surface), 0);
  EXPECT_GT(width_of(around), 2 * width_of(across));
}

TEST(FitToMesh, StaysOnOneSideOfAStep) {
  // Plates beside each other, one nearer by less than a cell of the view: gaps between close samples of a
  // line.
  TriangleMesh mesh = test::plane(1, 0.02, 3);
  for (Vec3f& place : mesh.positions) place.x() = place.x() / 2 - 0.5F;
  const auto vertices = static_cast<Index>(mesh.positions.size());
  for (Index i = 0; i < vertices; ++i) mesh.positions.push_back(mesh.positions[i] + Vec3f(1, 0, 0.006F));
  for (std::size_t i = 0, count = mesh.triangles.size(); i < count; ++i) {
    Triangle raised = mesh.triangles[i];
    for (Index& corner : raised) corner += vertices;
    mesh.triangles.push_back(raised);
  }
  const Surface surface = make_surface(std::move(mesh));
  std::vector<Eigen::Vector2d> places;
  for (int i = 0; i <= 400; ++i) places.emplace_back(i, 0);
  std::vector<RecordedStroke> line = {stroke_of(places)};
  ASSERT_TRUE(fit_to_mesh(line, front_camera(), surface));
  EXPECT_EQ(places_beside(line, surface), 0);
  EXPECT_GT(width_of(line), 200) << "of the about 270 pixels of a plate";
  const Picker picker(surface);
  std::set<bool> sides;
  for (const Sample& sample : line[0].samples)
    sides.insert(
        picker.pick(pixel_ray(front_camera(), sample.position.x(), sample.position.y()))->position.z() >
        0.003F);
  EXPECT_EQ(sides.size(), 1u);
}

TEST(FitToMesh, KeepsShapesAndTaps) {
  const Surface sphere = make_surface(test::sphere(4, 0, 1));
  std::vector<RecordedStroke> strokes = {stroke_of({{0, 0}, {4, 3}}), stroke_of({{1, 2}})};
  ASSERT_TRUE(fit_to_mesh(strokes, front_camera(), sphere));
  const Vec3d whole = strokes[0].samples[1].position - strokes[0].samples[0].position;
  const Vec3d tap = strokes[1].samples[0].position - strokes[0].samples[0].position;
  EXPECT_NEAR(whole.y() / whole.x(), 0.75, 1e-9);
  EXPECT_NEAR(tap.x() / whole.x(), 0.25, 1e-9);
  EXPECT_NEAR(tap.y() / whole.x(), 0.5, 1e-9);
  std::vector<RecordedStroke> alone = {stroke_of({{7, 7}})};
  EXPECT_TRUE(fit_to_mesh(alone, front_camera(), sphere));
}

TEST(FitToMesh, FindsAPlaceForRandomScribblesOnStrips) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> anywhere(0, 100);
    std::vector<Eigen::Vector2d> places;
    for (int i = 0; i < 20; ++i) places.emplace_back(anywhere(random), anywhere(random));
    TriangleMesh mesh = test::plane(1, 0.05, seed);
    std::erase_if(mesh.triangles, [&](const Triangle& triangle) {
      return std::abs(mesh.positions[triangle[0]].x() + 0.2F) < 0.1F;
    });
    const Surface surface = make_surface(std::move(mesh));
    std::vector<RecordedStroke> strokes = {stroke_of(places)};
    ASSERT_TRUE(fit_to_mesh(strokes, front_camera(), surface));
    EXPECT_EQ(places_beside(strokes, surface), 0);
    EXPECT_GT(width_of(strokes), 100);
  }
}

}  // namespace
}  // namespace burin
