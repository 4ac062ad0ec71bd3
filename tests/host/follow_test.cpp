// Strokes at the brush's own scale over relief that an earlier stroke could have left.
#include <cmath>
#include <numbers>
#include <random>
#include <tuple>
#include <utility>

#include "sessions.h"

namespace burin {
namespace {

constexpr double radius = 0.4, depth = 0.25 * radius;

double egg_crate(double x, double y) {
  const double k = 2 * std::numbers::pi / (0.35 * radius);
  return std::sin(k * x) * std::sin(k * y);
}

/// Waves of 0.25 to 0.45 radii in all directions, as rough as the egg crate on the whole.
double noise(double x, double y) {
  constexpr int waves = 64;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> share(0, 1);
  double sum = 0;
  for (int i = 0; i < waves; ++i) {
    const double k = 2 * std::numbers::pi / (radius * (0.25 + 0.2 * share(random)));
    const double along = 2 * std::numbers::pi * share(random), phase = 2 * std::numbers::pi * share(random);
    sum += std::sin(k * (std::cos(along) * x + std::sin(along) * y) + phase);
  }
  return sum / std::sqrt(2. * waves);
}

/// A rectangle with edges of a twentieth of the radius and bumps of this height, in shares of the radius.
Session bumpy_session(double (*bumps)(double, double), double height) {
  return Session(
      make_surface(test::shuffled(
          test::patch(
              {.u_min = -1.6, .u_max = 1.6, .v_min = -0.9, .v_max = 0.9, .cells_u = 160, .cells_v = 90},
              [=](double x, double y) {
                return Vec3d(x, y, height > 0 ? height * radius * bumps(x, y) : 0);
              }),
          3)),
      test::brushes());
}

/// What a stroke with a pen seen from above adds to each vertex, by source.
std::vector<Vec3d> added(Session& session, const std::string& brush) {
  StrokeSettings settings = test::settings(brush, radius);
  settings.follow = 0;
  settings.params = {{brush == "org.burin.groove" ? "depth" : "height", 0.25}};
  const std::vector<Vec3f> before(session.positions().begin(), session.positions().end());
  session.begin_stroke(settings);
  for (int i = 0; i < 150; ++i) {
    const float x = -1 + 2 * static_cast<float>(i) / 149;
    const Ray ray{.origin = {x, 0.15F * std::sin(3 * x), 5}, .direction = {0, 0, -1}};
    EXPECT_EQ(session.add_sample(ray, i / 240., {}).outcome, StrokeEvent::Outcome::drawn);
  }
  session.end_stroke();
  std::vector<Vec3d> moves(before.size());
  for (std::size_t v = 0; v < before.size(); ++v)
    moves[session.surface().source_vertex[v]] = (session.positions()[v] - before[v]).cast<double>();
  return moves;
}

using Case = std::tuple<const char*, double (*)(double, double)>;
class Follow : public testing::TestWithParam<Case> {};

// Root mean square over the vertices that either stroke moves, in percent of the depth.
TEST_P(Follow, AddsToReliefWhatItAddsToTheBarePlane) {
  const auto& [brush, bumps] = GetParam();
  Session bare = bumpy_session(bumps, 0);
  const std::vector<Vec3d> expected = added(bare, brush);
  for (const auto& [height, percent] : {std::pair(0.01, 0.5), {0.05, 1.}, {0.12, 2.}, {0.25, 5.}}) {
    Session bumpy = bumpy_session(bumps, height);
    const std::vector<Vec3d> moves = added(bumpy, brush);
    double squares = 0, farthest = 0;
    std::size_t count = 0;
    for (std::size_t v = 0; v < moves.size(); ++v) {
      if (moves[v].isZero(0) && expected[v].isZero(0)) continue;
      squares += (moves[v] - expected[v]).squaredNorm();
      farthest = std::max(farthest, moves[v].norm());
      ++count;
    }
    ASSERT_GT(count, 3000U);
    EXPECT_LT(100 / depth * std::sqrt(squares / static_cast<double>(count)), percent)
        << "bumps of " << height;
    EXPECT_LT(farthest, 2 * depth) << "bumps of " << height;
  }
}

INSTANTIATE_TEST_SUITE_P(Brushes, Follow,
                         testing::Combine(testing::Values("org.burin.groove", "org.burin.bead"),
                                          testing::Values(&egg_crate, &noise)));

TEST(Follow, RefusesSharesBeyondOne) {
  Session session = test::plane_session();
  StrokeSettings settings = test::settings("org.burin.groove");
  settings.follow = 1.5;
  EXPECT_EQ(test::error_of([&] { session.begin_stroke(settings); }),
            "how much a stroke follows must be from 0 to 1, not 1.5");
}

}  // namespace
}  // namespace burin
