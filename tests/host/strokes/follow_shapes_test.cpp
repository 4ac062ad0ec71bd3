// Tests strokes over base surfaces, over relief on curved shapes: they add to the relief what they add to
// the bare shape, and on the bare shape they add what strokes that follow all of the relief add.
#include <cmath>
#include <tuple>
#include <utility>

#include "moves.h"
#include "support/relief.h"

namespace burin {
namespace {

constexpr double shape_radius = 0.3, shape_depth = 0.25 * shape_radius;

/// A place of a shape and its outward normal, over (x, y) in object units.
struct Place {
  Vec3d position, normal;
};

Place on_cylinder(double x, double y) {
  const Vec3d normal(std::sin(x), 0, std::cos(x));
  return {normal + y * Vec3d::UnitY(), normal};
}

/// The sphere in polar coordinates about the pole (0, 0, 1).
Place on_sphere(double x, double y) {
  const double angle = std::hypot(x, y), share = angle > 0 ? std::sin(angle) / angle : 1;
  const Vec3d normal(share * x, share * y, std::cos(angle));
  return {normal, normal};
}

/// An egg crate of six radii, whose crests bend like a ball of 2.3 radii.
Place on_waves(double x, double y) {
  const double k = 2 * std::numbers::pi / (6 * shape_radius), a = 0.4 * shape_radius;
  const double sx = std::sin(k * x), cx = std::cos(k * x), sy = std::sin(k * y), cy = std::cos(k * y);
  return {{x, y, a * sx * sy}, Vec3d(-a * k * cx * sy, -a * k * sx * cy, 1).normalized()};
}

struct Shape {
  const char* name;
  Place (*at)(double x, double y);
};

Session session_on(const Shape& shape, test::Relief relief, double height) {
  return Session(
      make_surface(test::shuffled(
          test::patch(
              {.u_min = -1.5, .u_max = 1.5, .v_min = -0.75, .v_max = 0.75, .cells_u = 200, .cells_v = 100},
              [&](double x, double y) {
                const Place place = shape.at(x, y);
                const double up =
                    height > 0 ? height * shape_radius * relief(x / shape_radius, y / shape_radius) : 0;
                return Vec3d(place.position + up * place.normal);
              }),
          3)),
      test::brushes());
}

/// A pen that looks along the bare shape's normal.
test::Pens pens_on(const Shape& shape) {
  test::Pens pens;
  for (int i = 0; i < 150; ++i) {
    const double x = -1 + 2. * i / 149;
    const Place place = shape.at(x, 0.15 * std::sin(3 * x));
    pens.push_back(
        {(place.position + shape_radius * place.normal).cast<float>(), (-place.normal).cast<float>()});
  }
  return pens;
}

StrokeSettings settings_of(const char* brush, double follow) {
  StrokeSettings settings = test::settings(brush, shape_radius);
  settings.follow = follow;
  settings.params = {{std::string(brush) == "org.burin.groove" ? "depth" : "height", 0.25}};
  return settings;
}

constexpr Shape shapes[] = {{"cylinder", &on_cylinder}, {"sphere", &on_sphere}, {"waves", &on_waves}};
constexpr const char* drawing_brushes[] = {"org.burin.groove", "org.burin.bead"};

using ShapeCase = std::tuple<Shape, const char*, test::Relief>;
class FollowShapes : public testing::TestWithParam<ShapeCase> {};

// Root mean square over the vertices that either stroke moves, in percent of the depth.
TEST_P(FollowShapes, AddsToReliefWhatItAddsToTheBareShape) {
  const auto& [shape, brush, relief] = GetParam();
  Session bare = session_on(shape, relief, 0);
  const std::vector<Vec3d> expected = test::added(bare, settings_of(brush, 0), pens_on(shape));
  for (const auto& [height, percent] : {std::pair(0.01, 0.5), {0.05, 1.}, {0.12, 2.}, {0.25, 5.}}) {
    Session bumpy = session_on(shape, relief, height);
    const std::vector<Vec3d> moves = test::added(bumpy, settings_of(brush, 0), pens_on(shape));
    const test::MoveError error = test::move_error(moves, expected);
    ASSERT_GT(error.moved, 3000U);
    EXPECT_LT(100 / shape_depth * error.rms, percent) << shape.name << ", bumps of " << height;
    EXPECT_LT(error.farthest, 2 * shape_depth) << shape.name << ", bumps of " << height;
    RecordProperty("percent_" + std::to_string(height), std::to_string(100 / shape_depth * error.rms));
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, FollowShapes,
                         testing::Combine(testing::ValuesIn(shapes), testing::ValuesIn(drawing_brushes),
                                          testing::Values(&test::egg_crate, &test::band_noise)),
                         [](const auto& of) {
                           return std::string(std::get<0>(of.param).name) + "_" +
                                  (std::string(std::get<1>(of.param)).substr(10)) + "_" +
                                  (std::get<2>(of.param) == &test::egg_crate ? "egg_crate" : "noise");
                         });

// A bare shape has no relief: felt at the brush's own scale or all of it, it is the same.
TEST(FollowShapes, FeelsTheShapeItself) {
  for (const Shape& shape : shapes) {
    for (const char* brush : drawing_brushes) {
      Session own_scale = session_on(shape, nullptr, 0), all = session_on(shape, nullptr, 0);
      const test::MoveError error =
          test::move_error(test::added(own_scale, settings_of(brush, 0), pens_on(shape)),
                           test::added(all, settings_of(brush, 1), pens_on(shape)));
      ASSERT_GT(error.moved, 3000U);
      EXPECT_LT(100 / shape_depth * error.rms, 0.5) << shape.name << ", " << brush;
    }
  }
}

}  // namespace
}  // namespace burin
