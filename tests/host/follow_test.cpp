// Strokes at the brush's own scale over relief that an earlier stroke could have left.
#include <cmath>
#include <tuple>
#include <utility>

#include "moves.h"
#include "support/relief.h"

namespace burin {
namespace {

constexpr double radius = 0.4, depth = 0.25 * radius;

/// A rectangle with edges of a twentieth of the radius and bumps of this height, in shares of the radius.
Session bumpy_session(test::Relief bumps, double height) {
  return Session(
      make_surface(test::shuffled(
          test::patch(
              {.u_min = -1.6, .u_max = 1.6, .v_min = -0.9, .v_max = 0.9, .cells_u = 160, .cells_v = 90},
              [=](double x, double y) {
                return Vec3d(x, y, height > 0 ? height * radius * bumps(x / radius, y / radius) : 0);
              }),
          3)),
      test::brushes());
}

/// What a stroke with a pen seen from above adds to each vertex.
std::vector<Vec3d> added(Session& session, const std::string& brush) {
  StrokeSettings settings = test::settings(brush, radius);
  settings.params = {{brush == "org.burin.groove" ? "depth" : "height", 0.25}};
  test::Pens pens;
  for (int i = 0; i < 150; ++i) {
    const float x = -1 + 2 * static_cast<float>(i) / 149;
    pens.push_back({{x, 0.15F * std::sin(3 * x), 5}, {0, 0, -1}});
  }
  return test::added(session, settings, pens);
}

using Case = std::tuple<const char*, test::Relief>;
class Follow : public testing::TestWithParam<Case> {};

// Root mean square over the vertices that either stroke moves, in percent of the depth.
TEST_P(Follow, AddsToReliefWhatItAddsToTheBarePlane) {
  const auto& [brush, bumps] = GetParam();
  Session bare = bumpy_session(bumps, 0);
  const std::vector<Vec3d> expected = added(bare, brush);
  for (const auto& [height, percent] : {std::pair(0.01, 0.5), {0.05, 1.}, {0.12, 2.}, {0.25, 5.}}) {
    Session bumpy = bumpy_session(bumps, height);
    const std::vector<Vec3d> moves = added(bumpy, brush);
    const test::MoveError error = test::move_error(moves, expected);
    ASSERT_GT(error.moved, 3000U);
    EXPECT_LT(100 / depth * error.rms, percent) << "bumps of " << height;
    EXPECT_LT(error.farthest, 2 * depth) << "bumps of " << height;
  }
}

INSTANTIATE_TEST_SUITE_P(Brushes, Follow,
                         testing::Combine(testing::Values("org.burin.groove", "org.burin.bead"),
                                          testing::Values(&test::egg_crate, &test::band_noise)));

TEST(Follow, RefusesSharesBeyondOne) {
  Session session = test::plane_session();
  StrokeSettings settings = test::settings("org.burin.groove");
  settings.follow = 1.5;
  EXPECT_EQ(test::error_of([&] { session.begin_stroke(settings); }),
            "how much a stroke follows must be from 0 to 1, not 1.5");
}

}  // namespace
}  // namespace burin
