// Tests strokes over base surfaces, over relief that an earlier stroke could have left.
#include <cmath>
#include <tuple>
#include <utility>

#include "moves.h"
#include "support/relief.h"

namespace burin {
namespace {

constexpr double follow_radius = 0.4, follow_depth = 0.25 * follow_radius;

/// A rectangle with edges of a twentieth of the radius and bumps of this height, in shares of the
/// radius.
Session bumpy_session(test::Relief bumps, double height) {
  return Session(
      make_surface(test::shuffled(
          test::patch(
              {.u_min = -1.6, .u_max = 1.6, .v_min = -0.9, .v_max = 0.9, .cells_u = 160, .cells_v = 90},
              [=](double x, double y) {
                return Vec3d(
                    x, y,
                    height > 0 ? height * follow_radius * bumps(x / follow_radius, y / follow_radius) : 0);
              }),
          3)),
      test::brushes());
}

/// A brush that moves places by about a quarter of the radius.
StrokeSettings settings_of(const std::string& brush) {
  StrokeSettings settings = test::settings(brush, follow_radius);
  if (brush == "org.burin.groove") settings.params = {{"depth", 0.25}};
  if (brush == "org.burin.bead") settings.params = {{"height", 0.25}};
  return settings;
}

/// The displacement of each vertex by a stroke of a pen seen from above.
std::vector<Vec3d> added(Session& session, const StrokeSettings& settings) {
  test::Pens pens;
  for (int i = 0; i < 150; ++i) {
    const float x = -1 + 2 * static_cast<float>(i) / 149;
    pens.push_back({{x, 0.15F * std::sin(3 * x), 5}, {0, 0, -1}});
  }
  return test::added(session, settings, pens);
}

using Case = std::tuple<const char*, test::Relief>;
class Follow : public testing::TestWithParam<Case> {};

// Root mean square over the vertices that either stroke moves, at least so many, in percent of the
// depth.
void expect_same_over_bumps(const StrokeSettings& settings, test::Relief bumps, std::size_t fewest_moved) {
  Session bare = bumpy_session(bumps, 0);
  const std::vector<Vec3d> expected = added(bare, settings);
  for (const auto& [height, percent] : {std::pair(0.01, 0.5), {0.05, 1.}, {0.12, 2.}, {0.25, 5.}}) {
    Session bumpy = bumpy_session(bumps, height);
    const test::MoveError error = test::move_error(added(bumpy, settings), expected);
    ASSERT_GT(error.moved, fewest_moved);
    EXPECT_LT(100 / follow_depth * error.rms, percent) << "bumps of " << height;
    EXPECT_LT(error.farthest, 2 * follow_depth) << "bumps of " << height;
  }
}

TEST_P(Follow, AddsToReliefWhatItAddsToTheBarePlane) {
  const auto& [brush, bumps] = GetParam();
  expect_same_over_bumps(settings_of(brush), bumps, 3000);
}

// Dabs side by side: where they overlap, which of two a vertex between them follows is a matter of bits, and
// beads lean away from each other. And dabs that overlap, each of which adds to what those before made.
TEST_P(Follow, AddsToReliefWithDabsWhatTheyAddToTheBarePlane) {
  const auto& [brush, bumps] = GetParam();
  StrokeSettings settings = settings_of(brush);
  settings.dab_spacing = 2.1;
  expect_same_over_bumps(settings, bumps, 2000);
  settings.dab_spacing = 0.7;
  settings.strength = 0.3;
  settings.accumulate = Accumulate::from_current;
  expect_same_over_bumps(settings, bumps, 3000);
}

INSTANTIATE_TEST_SUITE_P(Brushes, Follow,
                         testing::Combine(testing::Values("org.burin.groove", "org.burin.bead"),
                                          testing::Values(&test::egg_crate, &test::band_noise)));

/// Root mean square heights of what lies at most half a radius from the middle of a stroke,
/// before and after it, in shares of the bumps' height.
struct Heights {
  double before, after;
};

Heights heights_under(const std::string& brush, const ParamSettings& params, double bumps) {
  Session session = bumpy_session(test::egg_crate, bumps);
  const std::vector<Vec3f> before(session.positions().begin(), session.positions().end());
  StrokeSettings settings = test::settings(brush, follow_radius);
  settings.params = params;
  session.begin_stroke(settings);
  for (int i = 0; i < 100; ++i)
    session.add_sample(Ray{.origin = {-1 + 0.02F * static_cast<float>(i), 0, 5}, .direction = {0, 0, -1}},
                       i / 240., {}, Show::later);
  session.end_stroke();
  Heights squares{0, 0};
  double count = 0;
  for (std::size_t v = 0; v < before.size(); ++v) {
    if (std::abs(before[v].x()) > 0.6F || std::abs(before[v].y()) > 0.4 * follow_radius) continue;
    squares.before += std::pow(before[v].z(), 2);
    squares.after += std::pow(session.positions()[v].z(), 2);
    ++count;
  }
  const double unit = bumps * follow_radius;
  return {std::sqrt(squares.before / count) / unit, std::sqrt(squares.after / count) / unit};
}

// An egg crate has a root mean square of half its height.
TEST(FollowedRelief, IsWhatFlattenLevels) {
  for (const double bumps : {0.01, 0.05, 0.12}) {
    const Heights heights = heights_under("org.burin.flatten", {{"fade", 0.01}}, bumps);
    EXPECT_NEAR(heights.before, 0.5, 0.02);
    EXPECT_LT(heights.after, 0.02) << "bumps of " << bumps;
  }
}

// Bumps of seven edges shrink to a tenth in 40 passes, with free motion and along normals.
TEST(FollowedRelief, IsWhatSmoothSmooths) {
  for (const char* motion : {"free", "normal"}) {
    for (const double bumps : {0.01, 0.05, 0.12}) {
      const Heights heights = heights_under(
          "org.burin.smooth",
          {{"passes", 40.}, {"amount", 1.}, {"fade", 0.2}, {"motion", std::string(motion)}}, bumps);
      EXPECT_NEAR(heights.before, 0.5, 0.02);
      EXPECT_LT(heights.after, 0.05) << motion << ", bumps of " << bumps;
    }
  }
}

// Brushes that move points to a target are given points of the base surface.
TEST(FollowedRelief, StaysOnWhatIsMovedToAPlane) {
  for (const double bumps : {0.05, 0.12}) {
    Session session = bumpy_session(test::egg_crate, bumps);
    const std::vector<Vec3f> before(session.positions().begin(), session.positions().end());
    StrokeSettings settings = test::settings("org.burin.test.raise-to", follow_radius);
    session.begin_stroke(settings);
    for (int i = 0; i < 50; ++i)
      session.add_sample(Ray{.origin = {-1 + 0.04F * static_cast<float>(i), 0, 5}, .direction = {0, 0, -1}},
                         i / 240., {}, Show::later);
    session.end_stroke();
    std::size_t count = 0;
    for (std::size_t v = 0; v < before.size(); ++v) {
      if (std::abs(before[v].x()) > 0.8F || std::abs(before[v].y()) > 0.8 * follow_radius) continue;
      ASSERT_NEAR(session.positions()[v].z() - before[v].z(), 0.1, 0.1 * bumps * follow_radius);
      ++count;
    }
    EXPECT_GT(count, 2000U);
  }
}

/// Pens that point at places of a wave in the plane from one direction.
test::Pens pens_from(const Vec3f& direction) {
  test::Pens pens;
  for (int i = 0; i <= 120; ++i) {
    const float x = -1 + static_cast<float>(i) / 60;
    pens.push_back({Vec3f(x, 0.45F + 0.15F * std::sin(3 * x), 0) - 5 * direction, direction});
  }
  return pens;
}

// Bumps seen at an angle hide places behind them and shift where rays meet the surface, by their height and
// more.
TEST(FollowedRelief, LeavesThePenOnItsWayFromWhereverItIsSeen) {
  const StrokeSettings groove = test::settings("org.burin.groove", follow_radius);
  for (const Vec3f& view : {Vec3f(0, 0, -1), Vec3f(0, 0.7F, -0.7F), Vec3f(0.75F, 0.3F, -0.6F)}) {
    Session bare = bumpy_session(test::egg_crate, 0);
    test::added(bare, groove, pens_from(view));
    for (const double bumps : {0.05, 0.12}) {
      Session bumpy = bumpy_session(test::egg_crate, bumps);
      test::added(bumpy, groove, pens_from(view));
      EXPECT_NEAR(bumpy.curve().length() / bare.curve().length(), 1, 1e-3) << "bumps of " << bumps;
      for (const CurvePoint& point : bumpy.curve().points) {
        const Vec3f& at = point.at.position;
        ASSERT_NEAR(at.z(), 0, 0.05 * bumps * follow_radius);
        ASSERT_NEAR(at.y(), 0.45F + 0.15F * std::sin(3 * at.x()), 0.1 * bumps * follow_radius);
      }
    }
  }
}

// The egg crate is no mirror image of itself, what is added to it is one.
TEST(FollowedRelief, LeavesImagesOnTheirWayToo) {
  StrokeSettings groove = test::settings("org.burin.groove", follow_radius);
  groove.symmetry.mirror_y = true;
  const test::Pens pens = pens_from({0, 0, -1});
  Session bare = bumpy_session(test::egg_crate, 0), bumpy = bumpy_session(test::egg_crate, 0.12);
  const std::vector<Vec3d> expected = test::added(bare, groove, pens);
  const test::MoveError error = test::move_error(test::added(bumpy, groove, pens), expected);
  ASSERT_GT(error.moved, 5000U);
  EXPECT_LT(100 / follow_depth * error.rms, 2);
}

TEST(Follow, RefusesSharesBeyondOne) {
  Session session = test::plane_session();
  StrokeSettings settings = test::settings("org.burin.groove");
  settings.follow = 1.5;
  EXPECT_EQ(test::error_of([&] { session.begin_stroke(settings); }),
            "how much a stroke follows must be from 0 to 1, not 1.5");
}

}  // namespace
}  // namespace burin
