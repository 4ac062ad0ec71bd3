#include "deform/deform_fixtures.h"

#include <burin/base/error.h>
#include <burin/deform/blend/blend.h>
#include <burin/deform/evaluate/displacement.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <limits>
#include <random>

namespace burin {
namespace {

constexpr Overlap all_modes[] = {Overlap::latest, Overlap::max,     Overlap::min,
                                 Overlap::add,    Overlap::average, Overlap::strongest};
constexpr Overlap without_order[] = {Overlap::max, Overlap::min, Overlap::add, Overlap::average,
                                     Overlap::strongest};

/// One of a vertex's sheets: its e1 at this angle, and what it says. It is near to the stroke.
struct SheetAt {
  float angle;
  Vec3f displacement;
};

/// Blends these sheets at one vertex of a flat surface.
class BlendTest : public ::testing::Test {
 protected:
  BlendTest() : surface_(test::square(3)) {}

  Vec3f blended(const std::vector<SheetAt>& sheets, Overlap overlap) {
    Chart chart;
    chart.length = static_cast<double>(sheets.size());
    NodeOutputs outputs;
    for (const SheetAt& sheet : sheets) {
      chart.sheet.push_back(static_cast<Index>(chart.vertex.size()));
      chart.vertex.push_back(vertex);
      chart.t.push_back(static_cast<double>(chart.t.size()));
      chart.d.push_back(0.5f);
      chart.stretch.push_back(1);
      chart.curvature.push_back(0);
      chart.normal.push_back(surface_.normals[vertex]);
      chart.e1.emplace_back(std::cos(sheet.angle), std::sin(sheet.angle), 0.0f);
      outputs.displacement.push_back(sheet.displacement);
    }
    LiveChart live(surface_.vertex_count());
    live.assign(chart);
    Vec3f place;
    const InstanceSheets sheets_of{&live, &outputs};
    blend_sheets(surface_, {{&sheets_of, 1}}, {&vertex, 1}, {.overlap = overlap, .radius = 4}, "some.brush",
                 {&place, 1});
    return place;
  }
  Vec3f moved(const SheetAt& sheet) const {
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
  const SheetAt sheet{0.3f, {0.1f, 0.02f, -0.7f}};
  for (const Overlap mode : all_modes) EXPECT_EQ(blended({sheet}, mode), moved(sheet));
  for (const Overlap mode : all_modes) EXPECT_EQ(blended({{0.3f, Vec3f::Zero()}}, mode), base());
}

TEST_F(BlendTest, DoesWhatTheModeSays) {
  const SheetAt a{0, {0.5f, 0, 0.25f}}, b{1, {0, 0.5f, 1}}, c{2, {0.25f, 0, -0.5f}};
  EXPECT_EQ(blended({a, b, c}, Overlap::latest), moved(c));
  EXPECT_EQ(blended({a, b, c}, Overlap::max), moved(b));
  EXPECT_EQ(blended({a, b, c}, Overlap::min), moved(c));
  const Vec3f sum = moved(a) + moved(b) + moved(c) - 3 * base();
  EXPECT_LT((blended({a, b, c}, Overlap::add) - base() - sum).norm(), 1e-6f);
  EXPECT_LT((blended({a, b, c}, Overlap::average) - base() - sum / 3).norm(), 1e-6f);
  EXPECT_NEAR(sum.z(), 0.75f, 1e-6f);
}

TEST_F(BlendTest, LeavesTheBaseWhereSheetsCancelOut) {
  const SheetAt up{0.4f, {0, 0, 0.25f}}, down{0.4f, {0, 0, -0.25f}};
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
    std::vector<SheetAt> sheets(2 + random() % 5);
    for (SheetAt& sheet : sheets) {
      // Heights in steps, so that some are equal.
      const float up = std::round(3 * number(random)) / 3;
      sheet = {3 * number(random), {number(random), number(random), up}};
    }
    ties += sheets[0].displacement.z() == sheets[1].displacement.z();
    std::vector<Vec3f> before;
    for (const Overlap mode : without_order) before.push_back(blended(sheets, mode));
    std::ranges::shuffle(sheets, random);
    for (std::size_t mode = 0; mode < before.size(); ++mode)
      ASSERT_EQ(blended(sheets, without_order[mode]), before[mode]) << mode;
  }
  EXPECT_GT(ties, 50u);
}

TEST_F(BlendTest, NamesThePlaceBeyondTheRangeOfFloats) {
  constexpr float far = std::numeric_limits<float>::max();
  const std::vector<SheetAt> sheets(3, {0, {0, 0, far}});
  EXPECT_EQ(blended(sheets, Overlap::max).z(), far);
  EXPECT_EQ(blended(sheets, Overlap::average).z(), far);
  try {
    blended(sheets, Overlap::add);
    FAIL();
  } catch (const ContractError& error) {
    EXPECT_STREQ(error.what(), "some.brush: displaces beyond the range of floats at t = 0, d = 0.5");
  }
}

/// A node of one symmetry instance.
struct ImageNode {
  double t;
  float d;
  Vec3f displacement;
  Tint tint = Tint::Zero();
};

/// Blends instances, each with some nodes at one vertex of a flat surface, of strokes of length 1 along x.
class InstancesTest : public ::testing::Test {
 protected:
  InstancesTest() : surface_(test::square(3)) {}

  using Instances = std::vector<std::vector<ImageNode>>;

  Vec3f moved(const Instances& instances, const BlendOptions& options) {
    build(instances);
    Vec3f place;
    blend_sheets(surface_, {sheets_}, {&vertex, 1}, options, "some.brush", {&place, 1});
    return place - surface_.positions[vertex];
  }
  Tint tinted(const Paint& paint, const Instances& instances, const BlendOptions& options) {
    build(instances);
    Tint tint;
    blend_tints(paint, {sheets_}, {&vertex, 1}, options, {&tint, 1});
    return tint;
  }

  void build(const Instances& instances) {
    sheets_.clear();
    lives_.clear();
    outputs_.clear();
    for (const std::vector<ImageNode>& nodes : instances) {
      Chart chart;
      chart.length = 1;
      chart.resize(nodes.size());
      NodeOutputs& outputs = outputs_.emplace_back();
      for (Index i = 0; i < nodes.size(); ++i) {
        chart.set(i, vertex, i,
                  {.t = nodes[i].t, .d = nodes[i].d, .e1 = Vec3f::UnitX(), .curvature = 0, .stretch = 1},
                  surface_.normals[vertex]);
        outputs.displacement.push_back(nodes[i].displacement);
        outputs.tint.push_back(nodes[i].tint);
      }
      lives_.emplace_back(surface_.vertex_count()).assign(chart);
      sheets_.push_back({&lives_.back(), &outputs});
    }
  }

  static constexpr Index vertex = 4;
  Surface surface_;
  std::deque<LiveChart> lives_;
  std::deque<NodeOutputs> outputs_;
  std::vector<InstanceSheets> sheets_;
};

const Vec3f up_one(0, 0, 1);

TEST_F(InstancesTest, CountsTheLastSheetOfEachTheNearerTheMore) {
  const BlendOptions options{.overlap = Overlap::latest, .radius = 0.5};
  const ImageNode early{0.1, 0, {9, 9, 9}}, near{0.5, 0, {0, 0, 1}}, half{0.6, 0.25f, {0, 1, 0}};
  // The weight at half a radius is a quarter.
  EXPECT_LT((moved({{early, near}, {half}}, options) - Vec3f(0, 0.2f, 0.8f)).norm(), 1e-6f);
  EXPECT_EQ(moved({{half}, {early, near}}, options), moved({{early, near}, {half}}, options));
  EXPECT_EQ(moved({{early, near}, {}}, options), up_one) << "one that is not there has no say";
}

TEST_F(InstancesTest, HaveNoSayWhereTheirRegionBegins) {
  const BlendOptions options{.overlap = Overlap::latest, .radius = 0.5};
  const ImageNode inside{0.5, 0.25f, up_one};
  const auto step = [&] { return (moved({{inside}}, options) - up_one).norm(); };
  EXPECT_EQ(step(), 0);
  for (const ImageNode& rim : {ImageNode{0.5, 0.5f, {0, 0, 0}}, ImageNode{1.5, 0, {0, 0, 0}},
                               ImageNode{1.3, 0.4f, {0, 0, 0}}, ImageNode{-0.5, 0, {0, 0, 0}}})
    EXPECT_LT((moved({{inside}, {rim}}, options) - up_one).norm(), 1e-6f) << rim.t;
  const ImageNode inner{1.1, 0.1f, {0, 0, 0}};
  EXPECT_GT((moved({{inside}, {inner}}, options) - up_one).norm(), 0.1f);
}

TEST_F(InstancesTest, KnowTheRimOfNarrowPartsAndOfDabs) {
  const BlendOptions options{.overlap = Overlap::latest, .radius = 0.5};
  build({{{0.5, 0.1f, up_one}}, {{0.5, 0.2f, {0, 0, 0}}}});
  const float narrow = 0.2f, beside = 0.5f;
  const auto blended = [&] {
    Vec3f place;
    blend_sheets(surface_, {sheets_}, {&vertex, 1}, options, "some.brush", {&place, 1});
    return Vec3f(place - surface_.positions[vertex]);
  };
  EXPECT_LT(blended().z(), 0.9f);
  sheets_[1].half_width = {&narrow, 1};
  EXPECT_NEAR(blended().z(), 1, 1e-6f);
  sheets_[1].half_width = {};
  sheets_[1].dab_t = {&beside, 1};
  EXPECT_NEAR(blended().z(), 1, 1e-6f);
}

TEST_F(InstancesTest, TakeAllSheetsInTheOtherModes) {
  const ImageNode a{0.1, 0, {0, 0, 3}}, b{0.5, 0.02f, {0, 0, -2}}, c{0.7, 0.04f, {0, 0, 5}};
  const auto up = [&](Overlap overlap) {
    return moved({{a, b}, {c}}, {.overlap = overlap, .radius = 0.5}).z();
  };
  EXPECT_FLOAT_EQ(up(Overlap::max), 5);
  EXPECT_FLOAT_EQ(up(Overlap::min), -2);
  EXPECT_FLOAT_EQ(up(Overlap::add), 5) << "the stronger of 3 - 2 and 5: images do not add up";
  EXPECT_FLOAT_EQ(up(Overlap::average), 2);
  EXPECT_FLOAT_EQ(up(Overlap::strongest), 3) << "5 up and 2 down";
}

TEST_F(InstancesTest, GoNoFartherThanTheLimit) {
  const ImageNode a{0.1, 0, {0, 3, 4}}, b{0.5, 0.2f, {0, 3, 4}};
  const BlendOptions options{.overlap = Overlap::add, .radius = 0.5, .limit = 2.5};
  EXPECT_LT((moved({{a, b}}, options) - Vec3f(0, 1.5f, 2)).norm(), 1e-6f) << "straight towards where it went";
  EXPECT_EQ(moved({{{0.1, 0, {0, 1.5f, 0}}}}, options), Vec3f(0, 1.5f, 0));
}

TEST_F(InstancesTest, BlendTints) {
  const Tint red = tint_of({1, 0, 0, 1}, 0.5f), half_blue = tint_of({0, 0, 1, 0.5f}, 0.25f);
  Paint paint;
  paint.mask.assign(surface_.vertex_count(), 0.75f);
  const ImageNode first{0.1, 0, {0, 0, 0}, red}, second{0.6, 0, {0, 0, 0}, half_blue};
  const auto tint = [&](Overlap overlap) {
    return tinted(paint, {{first, second}}, {.overlap = overlap, .radius = 0.5});
  };
  const auto numbers = [](float r, float b, float coverage, float mask) {
    Tint expected;
    expected << r, 0, b, coverage, mask;
    return expected;
  };
  EXPECT_EQ(tint(Overlap::latest), half_blue);
  EXPECT_EQ(tint(Overlap::max), numbers(1, 0.5f, 1, 0.5f));
  EXPECT_EQ(tint(Overlap::min), numbers(0, 0, 0.5f, 0.25f));
  EXPECT_EQ(tint(Overlap::add), numbers(1, 0.5f, 1, 0)) << "0.75 - 0.25 - 0.5, and coverage up to 1";
  EXPECT_EQ(tint(Overlap::average), numbers(0.5f, 0.25f, 0.75f, 0.375f));
  const Tint both = tinted(paint, {{first}, {second}}, {.overlap = Overlap::latest, .radius = 0.5});
  EXPECT_EQ(both, numbers(0.5f, 0.25f, 0.75f, 0.375f)) << "instances that are equally near";
  EXPECT_EQ(tinted(paint, {{}}, {}), tint_of(Paint::bare(), 0.75f));
}

TEST_F(InstancesTest, AddUpToColoursWithinTheirRange) {
  Paint black;
  black.colour.assign(surface_.vertex_count(), Vec4f(0, 0, 0, 1));
  const ImageNode white{0.1, 0, {0, 0, 0}, tint_of({1, 1, 1, 1}, 1)};
  const ImageNode erased{0.6, 0, {0, 0, 0}, tint_of({0, 0, 0, 0.1f}, 1)};
  const Vec4f sum = colour_of(tinted(black, {{white, erased}}, {.overlap = Overlap::add, .radius = 0.5}));
  EXPECT_EQ(sum.head<3>(), Vec3f(1, 1, 1));
}

}  // namespace
}  // namespace burin
