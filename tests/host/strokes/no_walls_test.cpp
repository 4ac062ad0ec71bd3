// Checks that where a stroke overlaps itself the result of a brush has no steps that it does not have
// along a straight stroke.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <string_view>

#include "host/stock_brush_uses.h"
#include "host/strokes/moves.h"
#include "support/drawn_strokes.h"

namespace burin {
namespace {

using test::BrushUse, test::line;

constexpr double radius = 0.2;

/// The samples of each piece of a stroke.
using Pieces = std::vector<std::vector<Vec3d>>;

/// A square with ripples, narrow against the radius, for brushes that change what is there.
TriangleMesh rippled_square() {
  TriangleMesh mesh = test::plane(1, 0.025, 4);
  for (Vec3f& p : mesh.positions) p.z() += 0.004f * std::sin(25 * p.x()) * std::sin(25 * p.y() + 1);
  return mesh;
}

/// One round of a closed way, of this parameter from 0 to 2 pi, and some of the next.
std::vector<Vec3d> round(const std::function<Vec3d(double)>& way, double rounds) {
  std::vector<Vec3d> places;
  const int count = static_cast<int>(100 * rounds);
  for (int i = 0; i <= count; ++i) places.push_back(way(2 * std::numbers::pi * i / 100));
  return places;
}

struct DrawnStroke {
  const char* name;
  Pieces pieces;
  double dab_spacing = 0;
};

std::vector<DrawnStroke> overlapping_strokes() {
  const Vec3d left(-0.6, 0, 0), right(0.6, 0, 0);
  // Nowhere do they bend more sharply than the radius.
  const auto loop = [](double s) { return Vec3d(0.4 * std::sin(s) + 0.07 * s - 0.3, -0.4 * std::cos(s), 0); };
  const auto eight = [](double s) { return Vec3d(0.6 * std::sin(s), 0.35 * std::sin(2 * s), 0); };
  const auto spiral = [](double s) {
    return Vec3d((0.35 + 0.02 * s) * std::cos(s), (0.35 + 0.02 * s) * std::sin(s), 0);
  };
  Pieces hatching;
  for (const double y : {-0.3, -0.17, 0., 0.1, 0.3})
    hatching.push_back(line({-0.5, y, 0}, {0.5, y + 0.1, 0}));
  return {{"a loop that crosses itself", {round(loop, 1.3)}},
          {"a figure eight", {round(eight, 1)}},
          {"a spiral that is narrower than the stroke", {round(spiral, 2)}},
          {"a cross of two pieces", {line(left, right), line({0.1, -0.5, 0}, {-0.1, 0.5, 0})}},
          {"a line in two pieces", {line(left, {-0.02, 0, 0}), line({0.02, 0, 0}, right)}},
          {"hatching", hatching},
          {"dabs", {line(left, right)}, 0.4},
          {"close dabs", {line(left, right)}, 0.1}};
}

DrawnStroke as_drawn(std::string_view kind, std::mt19937& random) {
  std::vector<Vec3d> places;
  for (const Vec2d& sample : test::drawn_stroke(kind, random))
    places.emplace_back(radius * sample.x(), radius * sample.y(), 0);
  return {"as drawn", {places}};
}

/// The reference strokes, which do not overlap themselves; for dabs single dabs.
std::vector<DrawnStroke> simple_strokes(bool dabs) {
  if (dabs) return {{"one dab", {{Vec3d(0, 0, 0)}}, 1}, {"another", {{Vec3d(-0.3, 0.11, 0)}}, 1}};
  return {{"a line", {line({-0.6, 0, 0}, {0.6, 0, 0})}},
          {"another", {line({-0.1, -0.6, 0}, {0, 0.6, 0})}},
          {"a slanting line", {line({-0.5, -0.4, 0}, {0.5, 0.5, 0})}}};
}

/// Draws with one brush on the square.
class Steps {
 public:
  explicit Steps(const BrushUse& use)
      : use_(use), session_(make_surface(rippled_square()), test::brushes()) {}

  /// The largest difference of displacement between the ends of an edge that a stroke makes.
  double largest(const DrawnStroke& stroke, std::optional<Overlap> overlap = {}) {
    const std::vector<Vec3f> moved = displacements(stroke, overlap);
    double step = 0;
    for (Index vertex = 0; vertex < session_.surface().vertex_count(); ++vertex)
      for (const Index other : session_.surface().neighbours[vertex])
        step = std::max(step, static_cast<double>((moved[vertex] - moved[other]).norm()));
    return step;
  }

  /// The largest step of strokes that do not overlap themselves, or of single dabs.
  double of_simple(bool dabs) {
    double step = 0;
    for (const DrawnStroke& stroke : simple_strokes(dabs)) step = std::max(step, largest(stroke));
    return step;
  }

  /// The largest difference of displacement between any two vertices under a straight stroke.
  double extent() {
    std::vector<Vec3f> moved = displacements(simple_strokes(false)[0], {});
    std::erase_if(moved, [](const Vec3f& by) { return by.isZero(); });
    double most = 0;
    for (const Vec3f& a : moved)
      for (const Vec3f& b : moved) most = std::max(most, static_cast<double>((a - b).norm()));
    return most;
  }

 private:
  std::vector<Vec3f> displacements(const DrawnStroke& stroke, std::optional<Overlap> overlap) {
    StrokeSettings settings = test::settings(use_.id, radius);
    settings.params = use_.params;
    settings.overlap = overlap;
    settings.dab_spacing = stroke.dab_spacing;
    session_.begin_stroke(settings);
    double time = 0;
    for (const std::vector<Vec3d>& piece : stroke.pieces) {
      for (const Vec3d& place : piece) session_.add_sample(place, time += 0.01, {}, Show::later);
      session_.end_piece();
    }
    std::vector<Vec3f> moved;
    for (Index v = 0; v < session_.surface().vertex_count(); ++v)
      moved.emplace_back(session_.positions()[v] - session_.surface().positions[v]);
    session_.cancel_stroke();
    return moved;
  }

  BrushUse use_;
  Session session_;
};

class NoWalls : public testing::TestWithParam<BrushUse> {};

INSTANTIATE_TEST_SUITE_P(StockBrushes, NoWalls, testing::ValuesIn(test::stock_brush_uses), test::name_of_use);

TEST_P(NoWalls, WhereAStrokeOverlapsItself) {
  Steps steps(GetParam());
  const double of_stroke = steps.of_simple(false), of_dab = steps.of_simple(true);
  EXPECT_GT(of_stroke, 1e-4);
  for (const DrawnStroke& stroke : overlapping_strokes()) {
    const double once = stroke.dab_spacing > 0 ? of_dab : of_stroke, step = steps.largest(stroke);
    std::cout << fmt::format("{:.2f} of {:.4f}: {}\n", step / once, once, stroke.name);
    EXPECT_LE(step, 1.5 * once) << stroke.name;
  }
}

/// Whether a brush repeats shapes with steep sides of their own. Where t jumps, inside of sharp bends, a
/// shape is cut off, and the cut is as high as the shape.
bool has_sides(const BrushUse& use) {
  const std::string_view brush = use.id;
  return brush == "org.burin.vdm-trail" || (brush == "org.burin.bead" && use.params.contains("form"));
}

TEST_P(NoWalls, HoweverItIsDrawn) {
  Steps steps(GetParam());
  const double once = steps.of_simple(false);
  const double most = has_sides(GetParam()) ? steps.extent() : 1.5 * once;
  const std::uint32_t seed = 8;
  std::mt19937 random(seed);
  for (const std::string_view kind : test::drawn_kinds()) {
    double worst = 0;
    for (int i = 0; i < 3; ++i) worst = std::max(worst, steps.largest(as_drawn(kind, random)));
    std::cout << fmt::format("{:.2f} of {:.4f}, at most {:.2f}: {}\n", worst / once, once, most / once, kind);
    EXPECT_LE(worst, most) << kind << ", seed " << seed;
  }
}

// The groove's profile is smooth everywhere. A sum may be steeper.
TEST(NoWallsOfAGroove, WhicheverWayItOverlaps) {
  Steps steps({"org.burin.groove", {}});
  for (const auto& [name, overlap] : named_overlaps) {
    if (overlap == Overlap::add) continue;
    for (const DrawnStroke& stroke : overlapping_strokes()) {
      const double once = steps.of_simple(stroke.dab_spacing > 0), step = steps.largest(stroke, overlap);
      std::cout << fmt::format("{:.2f} of {:.4f}: {} {}\n", step / once, once, name, stroke.name);
      EXPECT_LE(step, 1.5 * once) << name << ' ' << stroke.name;
    }
  }
}

// Each of several passes starts from the previous one, so a sum over a dozen sheets would overshoot without
// bound.
TEST(NoWallsOfSeveralPasses, DoNotAddUp) {
  Steps steps({"org.burin.smooth", {{"passes", 16.}}});
  std::vector<Vec3d> to_and_fro;
  for (int i = 0; i <= 400; ++i) to_and_fro.emplace_back(0.5 * std::sin(0.2 * i), 0.0005 * i, 0);
  EXPECT_LE(steps.largest({"to and fro", {to_and_fro}}, Overlap::add), 1.5 * steps.of_simple(false));
}

/// The largest step of a groove of each kind of stroke that people draw, over that of a straight one.
void expect_no_walls(const BrushUse& groove) {
  Steps steps(groove);
  const double once = steps.of_simple(false);
  const std::uint32_t seed = 7;
  std::mt19937 random(seed);
  for (const std::string_view kind : test::drawn_kinds()) {
    double worst = 0;
    for (int i = 0; i < 4; ++i) worst = std::max(worst, steps.largest(as_drawn(kind, random)));
    std::cout << fmt::format("{:.2f} of {:.4f}: {}\n", worst / once, once, kind);
    EXPECT_LE(worst, 1.5 * once) << kind << ", seed " << seed;
  }
}

// Hooks, corners, cusps, retraced and scrubbed lines, rests, loops and spirals tighter than the radius.
TEST(NoWallsOfAGroove, HoweverItIsDrawn) { expect_no_walls({"org.burin.groove", {{"taper", 0.}}}); }

// A tapered end has little depth. Where it lies on the inside of a bend, t changes by up to half a turn.
TEST(NoWallsOfAGroove, WhereItsTaperedEndsLieOnIt) { expect_no_walls({"org.burin.groove", {}}); }

// Across the centre of a bend the nearest point changes to the opposite side, half a turn along the stroke
// away.
TEST(NoWallsOfAGroove, AtTheCentreOfATaperedBend) {
  for (const double bend : {0.2, 0.4, 0.6}) {
    // One round from the pen's begin on, and away, so that the other end is far off.
    std::vector<Vec3d> places = round(
        [&](double s) { return Vec3d(radius * bend * std::cos(s), radius * bend * std::sin(s), 0); }, 1);
    for (const Vec3d& place : line(places.back(), places.back() + Vec3d(0, 0.6, 0))) places.push_back(place);
    Steps steps({"org.burin.groove", {}});
    const double once = steps.of_simple(false), seen = steps.largest({"round", {places}});
    std::cout << fmt::format("{:.2f} of {:.4f}: a bend of {} radii\n", seen / once, once, bend);
    EXPECT_LE(seen, 1.5 * once) << bend;
  }
}

// A brush that tapers leaves its whole profile where the pen only touches.
TEST(NoWallsOfAGroove, TapsAreAsDeepAsStrokes) {
  Steps steps({"org.burin.groove", {}});
  EXPECT_NEAR(steps.largest({"tap", {{Vec3d(0.1, 0, 0)}}}), steps.of_simple(false),
              0.1 * steps.of_simple(false));
}

}  // namespace
}  // namespace burin
