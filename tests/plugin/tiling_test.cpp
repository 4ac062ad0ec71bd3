#include <burin/plugin/tiling.h>
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <limits>
#include <map>
#include <numbers>
#include <random>

#include "driver.h"

namespace burin {
namespace {

using plugin::Cell;
using plugin::Stroke;
using plugin::Tile;
using plugin::TileLayout;
using plugin::Tiling;
using std::numbers::pi_v;

/// A stroke of radius 1 and length 10, finished.
struct Context : burin_stroke_context {
  explicit Context(double arc_length = 10, std::uint64_t more_flags = 0) : burin_stroke_context{} {
    struct_size = sizeof(burin_stroke_context);
    flags = BURIN_STROKE_FINAL | more_flags;
    length = arc_length;
    radius_min = radius_max = 1;
    seed = 17;
  }
};

Tile tile_at(const TileLayout& layout, const Context& context, float t, float d, float angle = 0) {
  return Tiling(layout, Stroke(context)).at({t, d, 1, 0, 0}, angle);
}

std::mt19937 engine() {
  const unsigned seed = std::random_device{}();
  testing::Test::RecordProperty("seed", static_cast<int>(seed));
  std::cout << "seed " << seed << '\n';
  return std::mt19937(seed);
}

TEST(Tiling, CountsColumnsForwardAndRowsToTheRight) {
  TileLayout layout;
  layout.length = 2;
  layout.width = 0.5f;
  const Tile tile = tile_at(layout, Context(), 4.5f, 0.65f);
  EXPECT_EQ(tile.column, 2);
  EXPECT_EQ(tile.row, -1);
  EXPECT_EQ(tile.role, Tile::middle);
  EXPECT_FLOAT_EQ(tile.area.at.u, 0.25f);
  EXPECT_NEAR(tile.area.at.v, 0.2f, 1e-6) << "0.15 to the left of the row's middle, that is 0.3 tiles up";
}

TEST(Tiling, MovesTilesByTheirOffset) {
  TileLayout layout;
  const Tile before = tile_at(layout, Context(), 4.5f, 0.25f);
  layout.offset_along = 0.25f;
  layout.offset_across = -0.5f;
  const Tile after = tile_at(layout, Context(), 5, 1.25f);
  EXPECT_EQ(after.column, before.column);
  EXPECT_FLOAT_EQ(after.area.at.u, before.area.at.u);
  EXPECT_FLOAT_EQ(after.area.at.v, before.area.at.v);
}

TEST(Tiling, SpansTheWidthWithWholeRows) {
  for (const int rows : {1, 2, 3, 4}) {
    SCOPED_TRACE(rows);
    TileLayout layout;
    layout.span(rows);
    const Tiling tiling(layout, Stroke(Context()));
    for (const float radius : {1.0f, 0.4f}) {
      const Tile left = tiling.at({3, 0.99999f * radius, radius, 0, 0});
      const Tile right = tiling.at({3, -0.99999f * radius, radius, 0, 0});
      EXPECT_EQ(right.row - left.row, rows - 1);
      EXPECT_NEAR(left.area.at.v, 0, 1e-4);
      EXPECT_NEAR(right.area.at.v, 1, 1e-4);
    }
  }
}

TEST(Tiling, TurnsTheStampAroundItsMiddle) {
  TileLayout layout;
  layout.length = 2;
  layout.width = 1;
  const float angle = pi_v<float> / 2;  // the stamp's right side points to the left of the travel
  const Tile tile = tile_at(layout, Context(), 5, 0.3f, angle);
  EXPECT_NEAR(tile.area.at.u, 0.5 + 0.3 / 2, 1e-6);
  EXPECT_NEAR(tile.area.at.v, 0.5, 1e-6);
  EXPECT_NEAR(tile.along(1, 0), 0, 1e-6);
  EXPECT_NEAR(tile.across(1, 0), 1, 1e-6);
  EXPECT_NEAR(tile.along(0, 1), -1, 1e-6);
}

TEST(Tiling, GivesTheCellsFootprintInTheStampsFrame) {
  TileLayout layout;
  layout.length = 4;
  layout.width = 2;
  const Tiling tiling(layout, Stroke(Context()));
  const float turn = pi_v<float> / 6;
  const Tile tile = tiling.at({1, 0, 1, 0.2f, 0.1f}, turn);
  EXPECT_NEAR(tile.area.along.u, 0.2 * std::cos(turn) / 4, 1e-7);
  EXPECT_NEAR(tile.area.along.v, 0.2 * std::sin(turn) / 2, 1e-7) << "v runs down";
  EXPECT_NEAR(tile.area.across.u, 0.1 * std::sin(turn) / 4, 1e-7);
  EXPECT_NEAR(tile.area.across.v, -0.1 * std::cos(turn) / 2, 1e-7);
  // The area equals the difference of the points at the cell's sides.
  const Tile beside = tiling.at({1.1f, 0.05f, 1, 0, 0}, turn);
  EXPECT_NEAR(beside.area.at.u - tile.area.at.u, (tile.area.along.u + tile.area.across.u) / 2, 1e-6);
  EXPECT_NEAR(beside.area.at.v - tile.area.at.v, (tile.area.along.v + tile.area.across.v) / 2, 1e-6);
}

TEST(Tiling, MirrorsPlacesAndVectorsAlike) {
  TileLayout layout;
  layout.mirror_along = layout.mirror_across = true;
  const Tile tile = tile_at(layout, Context(), 2.5f, -1.5f);
  EXPECT_EQ(tile.column, 1);
  EXPECT_EQ(tile.row, 1);
  EXPECT_FLOAT_EQ(tile.area.at.u, 0.75f);
  EXPECT_FLOAT_EQ(tile.area.at.v, 0.75f);
  EXPECT_EQ(tile.along(1, 0), -1);
  EXPECT_EQ(tile.across(0, 1), -1);
}

TEST(Tiling, LeavesGapsBetweenTiles) {
  TileLayout layout;
  layout.length = 1.5f;
  layout.gap = 0.5f;
  EXPECT_NEAR(tile_at(layout, Context(), 2.25f, 0).area.at.u, 0, 1e-6);
  EXPECT_NEAR(tile_at(layout, Context(), 3.75f, 0).area.at.u, 1, 1e-6);
  EXPECT_LT(tile_at(layout, Context(), 2.1f, 0).area.at.u, 0);
  EXPECT_EQ(Tiling::options(layout).wrap_u, BURIN_WRAP_BLACK);
}

/// A wave that the stamp's borders join with all derivatives.
double periodic(double u, double v) {
  return std::sin(2 * pi_v<double> * u) * std::cos(2 * pi_v<double> * v) +
         0.5 * std::cos(2 * pi_v<double> * (2 * u + v));
}

/// No symmetry, no period.
double skew(double u, double v) { return u * u + 0.3 * u + std::sin(1.7 * v) * (1 + u); }

/// Greatest jump of the height across the borders of tiles: along the stroke of columns 1 .. n - 1 and, on a
/// closed one, where it meets itself; across it of the rows in |d| < 1.
template <class Image>
double greatest_jump(const TileLayout& layout, const Context& context, const Image& image) {
  const Tiling tiling(layout, Stroke(context));
  const auto height = [&](float t, float d) {
    const Tile tile = tiling.at({t, d, 1, 0, 0});
    return image(tile.area.at.u, tile.area.at.v);
  };
  const bool closed = Stroke(context).closed();
  double pitch = layout.length;
  if (closed || layout.fit) {
    const double pair = closed && layout.mirror_along ? 2 : 1;
    pitch = context.length / (pair * std::max(1.0, std::round(context.length / (pair * pitch))));
  }
  constexpr float step = 1e-5f;
  double jump = 0;
  for (float d = -0.95f; d < 1; d += 0.05f) {
    for (double t = pitch; t < context.length - 0.5 * pitch; t += pitch)
      jump = std::max(jump, std::abs(height(std::nextafter(static_cast<float>(t), 0.0f), d) -
                                     height(std::nextafter(static_cast<float>(t), 1e9f), d)));
    if (closed)
      jump = std::max(
          jump, std::abs(height(std::nextafter(static_cast<float>(context.length), 0.0f), d) - height(0, d)));
  }
  for (float t = 0.1f; t < 10; t += 0.1f)
    for (float border = -4; border <= 4; border += 1) {
      const float d = (0.5f - border) * layout.width;
      jump = std::max(jump, std::abs(height(t, d - step / 10) - height(t, d + step / 10)));
    }
  return jump;
}

TEST(Tiling, JoinsPeriodicTilesWithoutASeam) {
  TileLayout layout;
  layout.length = 1.3f;
  layout.width = 0.7f;
  for (const std::uint64_t closed : {std::uint64_t{0}, BURIN_STROKE_CLOSED})
    for (const bool fit : {false, true}) {
      layout.fit = fit;
      EXPECT_LE(greatest_jump(layout, Context(10, closed), periodic), 1e-4);
      EXPECT_GT(greatest_jump(layout, Context(10, closed), skew), 0.5) << "the borders were looked at";
    }
}

TEST(Tiling, JoinsMirroredTilesOfAnyImageWithoutASeam) {
  TileLayout layout;
  layout.length = 1.3f;
  layout.width = 0.7f;
  layout.mirror_along = layout.mirror_across = true;
  EXPECT_EQ(Tiling::options(layout).wrap_u, BURIN_WRAP_MIRROR);
  for (const double length : {10.0, 9.1, 3.9, 1.0})  // 8, 7, 3 and 1 tiles before the loop makes them even
    for (const std::uint64_t closed : {std::uint64_t{0}, BURIN_STROKE_CLOSED})
      EXPECT_LE(greatest_jump(layout, Context(length, closed), skew), 1e-4) << length;
}

TEST(Tiling, FitsWholeTilesAlways) {
  TileLayout layout;
  layout.length = 3;
  EXPECT_EQ(tile_at(layout, Context(10, BURIN_STROKE_CLOSED), 9.9f, 0).column, 2);
  EXPECT_NEAR(tile_at(layout, Context(10, BURIN_STROKE_CLOSED), 10.0f - 1e-4f, 0).area.at.u, 1, 1e-4);
  EXPECT_LT(tile_at(layout, Context(), 9.999f, 0).area.at.u, 0.4f);
  layout.fit = true;
  EXPECT_NEAR(tile_at(layout, Context(), 10.0f - 1e-4f, 0).area.at.u, 1, 1e-4);
  const Context open;
  EXPECT_EQ(Tiling::end_influence(layout, Stroke(open)), std::numeric_limits<double>::infinity());
  EXPECT_EQ(tile_at(layout, Context(0.2), 0.19f, 0).column, 0) << "one tile at least";
  EXPECT_TRUE(std::isfinite(tile_at(layout, Context(0), 0.5f, 0).area.at.u)) << "the pen has not moved";
}

TEST(Tiling, BeginsAndEndsWithTilesOfTheirOwn) {
  TileLayout layout;
  layout.length = 3;
  layout.fit = layout.start = layout.end = true;  // tiles of 10 / 3
  const Tile before = tile_at(layout, Context(), -0.5f, 0), first = tile_at(layout, Context(), 1, 0);
  EXPECT_EQ(before.role, Tile::start);
  EXPECT_LT(before.area.at.u, 0);
  EXPECT_EQ(first.role, Tile::start);
  EXPECT_NEAR(first.area.at.u, 0.3, 1e-6);
  EXPECT_EQ(tile_at(layout, Context(), 5, 0).role, Tile::middle);
  const Tile last = tile_at(layout, Context(), 9, 0), after = tile_at(layout, Context(), 10.5f, 0);
  EXPECT_EQ(last.role, Tile::end);
  EXPECT_NEAR(last.area.at.u, 0.7, 1e-6);
  EXPECT_GT(after.area.at.u, 1);
  for (const float t : {1.0f, 5.0f, 9.0f})
    EXPECT_EQ(tile_at(layout, Context(10, BURIN_STROKE_CLOSED), t, 0).role, Tile::middle);
}

TEST(Tiling, ShowsHalfOfBothEndsWhereTheStrokeIsShort) {
  TileLayout layout;
  layout.length = 3;
  layout.start = layout.end = true;
  for (const bool fit : {false, true}) {
    layout.fit = fit;
    EXPECT_EQ(tile_at(layout, Context(2), 0.9f, 0).role, Tile::start);
    EXPECT_EQ(tile_at(layout, Context(2), 1.1f, 0).role, Tile::end);
  }
  EXPECT_NEAR(tile_at(layout, Context(2), 2, 0).area.at.u, 1, 1e-6);
}

TEST(Tiling, KeepsItsTilesWhileTheStrokeGrows) {
  auto random = engine();
  TileLayout layout;
  layout.length = 0.7f;
  layout.flip_along = layout.flip_across = layout.mirror_along = true;
  layout.choices = 3;
  layout.start = layout.end = true;
  const Context shorter(8), longer(12);
  const double kept = 8 - Tiling::end_influence(layout, Stroke(shorter));
  std::uniform_real_distribution<float> along(-1, static_cast<float>(kept)), across(-1, 1);
  for (int i = 0; i < 1000; ++i) {
    const float t = along(random), d = across(random);
    const Tile a = tile_at(layout, shorter, t, d), b = tile_at(layout, longer, t, d);
    EXPECT_EQ(a.role, b.role) << t;
    EXPECT_EQ(a.choice, b.choice);
    EXPECT_EQ(a.area.at.u, b.area.at.u);
    EXPECT_EQ(a.area.at.v, b.area.at.v);
  }
  EXPECT_GT(kept, 6);
}

TEST(Tiling, ChoosesAtRandomByTileAndSeed) {
  TileLayout layout;
  layout.length = 0.01f;
  layout.width = 0.01f;
  layout.flip_along = layout.flip_across = true;
  layout.choices = 4;
  Context context(100);
  std::map<std::uint32_t, int> chosen;
  int flipped = 0, upside_down = 0, same_as_next = 0, same_with_seed = 0;
  constexpr int count = 10000;
  for (int i = 0; i < count; ++i) {
    const float t = 0.01f * (static_cast<float>(i) + 0.5f), d = 0.01f * static_cast<float>(i % 7);
    context.seed = 17;
    const Tile tile = tile_at(layout, context, t, d), next = tile_at(layout, context, t + 0.01f, d);
    const Tile inside = tile_at(layout, context, t + 0.004f, d - 0.004f);
    ASSERT_EQ(tile.choice, inside.choice) << "one choice a tile";
    ASSERT_EQ(tile.right, inside.right);
    context.seed = 18;
    ++chosen[tile.choice];
    flipped += tile.right < 0;
    upside_down += tile.top < 0;
    same_as_next += tile.choice == next.choice;
    same_with_seed += tile.choice == tile_at(layout, context, t, d).choice;
  }
  // Six standard deviations, sqrt(count p (1 - p)) = 43 and 50.
  ASSERT_EQ(chosen.size(), 4u);
  for (const auto& [choice, times] : chosen) EXPECT_NEAR(times, count / 4, 260) << choice;
  EXPECT_NEAR(flipped, count / 2, 300);
  EXPECT_NEAR(upside_down, count / 2, 300);
  EXPECT_NEAR(same_as_next, count / 4, 260);
  EXPECT_NEAR(same_with_seed, count / 4, 260);
}

TEST(Tiling, IsExactForTheTGivenFarFromTheStart) {
  auto random = engine();
  TileLayout layout;
  layout.length = 1.1f;
  const double length = layout.length;
  std::uniform_real_distribution<float> along(0, 11000);
  for (int i = 0; i < 10000; ++i) {
    const float t = along(random);
    const double u = t / length - std::floor(t / length);
    EXPECT_NEAR(tile_at(layout, Context(12000), t, 0).area.at.u, u, 1e-7);
  }
  // The error is that of the float t itself, as documented.
  const float far = 10000 * layout.length;
  EXPECT_LT((std::nextafter(far, 1e9f) - far) / 2 / length, 1.0 / 1600);
}

TEST(Tiling, CentresATileOnADab) {
  Context dab(0, BURIN_STROKE_DAB);
  TileLayout layout;
  layout.choices = 2;
  layout.fit = layout.start = layout.end = true;
  std::map<std::uint32_t, int> chosen;
  for (int i = 0; i < 400; ++i) {
    dab.dab_t = 0.5 * i;
    const Tile tile = tile_at(layout, dab, -0.5f, 0.5f);
    EXPECT_EQ(tile.role, Tile::middle);
    EXPECT_FLOAT_EQ(tile.area.at.u, 0.25f);
    EXPECT_FLOAT_EQ(tile.area.at.v, 0.25f);
    ++chosen[tile.choice];
  }
  EXPECT_NEAR(chosen[0], 200, 60) << "each dab chooses by its place";
}

TEST(Tiling, TellsTilesWhoseMiddleIsOnTheStroke) {
  TileLayout layout;
  layout.offset_along = -0.5f;  // middles at 0, 2, .. 10
  const auto on_stroke = [&](double length, float t) {
    return tile_at(layout, Context(length), t, 0).on_stroke;
  };
  EXPECT_TRUE(on_stroke(10, -0.9f));
  EXPECT_TRUE(on_stroke(10, 10.9f));
  EXPECT_FALSE(on_stroke(10, -1.1f));
  EXPECT_FALSE(on_stroke(9.9, 9.5f));
  EXPECT_TRUE(on_stroke(0, 0.5f)) << "one stamp where the pen went down";
}

TEST(SampleTiles, SamplesEachTilesStamp) {
  test::TestHost host;
  for (const float grey : {1.0f, 2.0f, 3.0f})
    host.pictures[std::to_string(static_cast<int>(grey))] = {
        8, 8, 1, [grey](std::uint32_t, double u, double) { return grey + static_cast<float>(u) / 2; }};
  std::vector<plugin::Stamp> stamps;
  for (const char* name : {"1", "2", "3"}) stamps.emplace_back(plugin::Host(&host.abi), name);
  TileLayout layout;
  layout.length = 0.5f;
  layout.choices = 3;
  const Tiling tiling(layout, Stroke(Context()));
  std::vector<float> values(1000);
  const auto tile = [&](std::size_t i) {
    return tiling.at({0.01f * static_cast<float>(i) + 0.003f, 0, 1, 0, 0});
  };
  plugin::sample_tiles(
      values.size(), tile, [&](const Tile& shown) -> const plugin::Stamp& { return stamps[shown.choice]; },
      plugin::FloatsOut(values.data(), 1));
  std::map<std::uint32_t, int> used;
  for (std::size_t i = 0; i < values.size(); ++i) {
    EXPECT_FLOAT_EQ(values[i], 1 + static_cast<float>(tile(i).choice) + tile(i).area.at.u / 2) << i;
    ++used[tile(i).choice];
  }
  EXPECT_EQ(used.size(), 3u);
}

}  // namespace
}  // namespace burin
