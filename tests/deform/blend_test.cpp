#include "deform_fixtures.h"

#include <burin/base/error.h>
#include <burin/deform/blend.h>
#include <burin/deform/displacement.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

namespace burin {
namespace {

constexpr Overlap all_modes[] = {Overlap::latest, Overlap::max, Overlap::min, Overlap::add, Overlap::average};
constexpr Overlap without_order[] = {Overlap::max, Overlap::min, Overlap::add, Overlap::average};

/// One of a vertex's sheets: its e1 at this angle, and what it says.
struct Sheet {
  float angle;
  Vec3f displacement;
};

/// Blends these sheets at one vertex of a flat surface.
class BlendTest : public ::testing::Test {
 protected:
  BlendTest() : surface_(test::square(3)) {}

  Vec3f blended(const std::vector<Sheet>& sheets, Overlap overlap) {
    Chart chart;
    NodeOutputs outputs;
    for (const Sheet& sheet : sheets) {
      chart.sheet.push_back(static_cast<Index>(chart.vertex.size()));
      chart.vertex.push_back(vertex);
      chart.t.push_back(static_cast<double>(chart.t.size()));
      chart.d.push_back(0.5f);
      chart.stretch.push_back(1);
      chart.e1.emplace_back(std::cos(sheet.angle), std::sin(sheet.angle), 0.0f);
      outputs.displacement.push_back(sheet.displacement);
    }
    LiveChart live(surface_.vertex_count());
    live.assign(chart);
    Vec3f place;
    const InstanceSheets sheets_of{&live, &outputs};
    blend_sheets(surface_, {&sheets_of, 1}, {&vertex, 1}, {.overlap = overlap}, "some.brush", {&place, 1});
    return place;
  }
  Vec3f moved(const Sheet& sheet) const {
    const Vec3f e1(std::cos(sheet.angle), std::sin(sheet.angle), 0.0f);
    return displaced(base(), e1, surface_.normals[vertex], sheet.displacement);
  }
  const Vec3f& base() const { return surface_.positions[vertex]; }

  static constexpr Index vertex = 4;
  Surface surface_;
};

TEST_F(BlendTest, TakesAVertexWithoutSheetsBackToItsBase) {
  for (const Overlap mode : all_modes) EXPECT_EQ(blended({}, mode), base());
}

TEST_F(BlendTest, LeavesOneSheetAsItIs) {
  const Sheet sheet{0.3f, {0.1f, 0.02f, -0.7f}};
  for (const Overlap mode : all_modes) EXPECT_EQ(blended({sheet}, mode), moved(sheet));
  for (const Overlap mode : all_modes) EXPECT_EQ(blended({{0.3f, Vec3f::Zero()}}, mode), base());
}

TEST_F(BlendTest, DoesWhatTheModeSays) {
  const Sheet a{0, {0.5f, 0, 0.25f}}, b{1, {0, 0.5f, 1}}, c{2, {0.25f, 0, -0.5f}};
  EXPECT_EQ(blended({a, b, c}, Overlap::latest), moved(c));
  EXPECT_EQ(blended({a, b, c}, Overlap::max), moved(b));
  EXPECT_EQ(blended({a, b, c}, Overlap::min), moved(c));
  const Vec3f sum = moved(a) + moved(b) + moved(c) - 3 * base();
  EXPECT_LT((blended({a, b, c}, Overlap::add) - base() - sum).norm(), 1e-6f);
  EXPECT_LT((blended({a, b, c}, Overlap::average) - base() - sum / 3).norm(), 1e-6f);
  EXPECT_NEAR(sum.z(), 0.75f, 1e-6f);
}

TEST_F(BlendTest, LeavesTheBaseWhereSheetsCancelOut) {
  const Sheet up{0.4f, {0, 0, 0.25f}}, down{0.4f, {0, 0, -0.25f}};
  EXPECT_EQ(blended({up, down}, Overlap::add), base());
  EXPECT_EQ(blended({up, down, up, down}, Overlap::average), base());
}

TEST_F(BlendTest, DoesNotSeeTheOrderOfSheets) {
  const unsigned seed = 5;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> number(-1, 1);
  std::size_t ties = 0;
  for (int round = 0; round < 500; ++round) {
    std::vector<Sheet> sheets(2 + random() % 5);
    for (Sheet& sheet : sheets) {
      // Heights in steps, so that some are equal.
      const float up = std::round(3 * number(random)) / 3;
      sheet = {3 * number(random), {number(random), number(random), up}};
    }
    ties += sheets[0].displacement.z() == sheets[1].displacement.z();
    std::vector<Vec3f> before;
    for (const Overlap mode : without_order) before.push_back(blended(sheets, mode));
    std::ranges::shuffle(sheets, random);
    for (std::size_t mode = 0; mode < before.size(); ++mode)
      ASSERT_LE((blended(sheets, without_order[mode]) - before[mode]).norm(), mode < 2 ? 0.0f : 1e-6f)
          << mode;
  }
  EXPECT_GT(ties, 50u);
}

TEST_F(BlendTest, NamesThePlaceBeyondTheRangeOfFloats) {
  constexpr float far = std::numeric_limits<float>::max();
  const std::vector<Sheet> sheets(3, {0, {0, 0, far}});
  EXPECT_EQ(blended(sheets, Overlap::max).z(), far);
  EXPECT_EQ(blended(sheets, Overlap::average).z(), far);
  try {
    blended(sheets, Overlap::add);
    FAIL();
  } catch (const ContractError& error) {
    EXPECT_STREQ(error.what(), "some.brush: displaces beyond the range of floats at t = 0, d = 0.5");
  }
}

}  // namespace
}  // namespace burin
