#include "deform/deform_fixtures.h"

#include <burin/deform/blend/blend.h>
#include <burin/deform/evaluate/displacement.h>
#include <gtest/gtest.h>

#include <vector>

namespace burin {
namespace {

/// Pieces that each have one node at the middle of a square, which they move up or down.
class EarlierPiecesTest : public ::testing::Test {
 protected:
  EarlierPiecesTest() : live_(surface_.vertex_count()) {}

  InstanceSheets piece(const Vec3f& displacement) {
    Chart chart;
    chart.length = 1;
    chart.resize(1);
    chart.set(0, vertex, 0, {.t = 0.5, .d = 0, .e1 = Vec3f(0.6f, 0.8f, 0), .curvature = 0, .stretch = 1},
              surface_.normals[vertex]);
    live_.assign(chart);
    outputs_.displacement = {displacement};
    return {&live_, &outputs_};
  }

  Vec3f blended(std::span<const InstanceSheets> now, Overlap overlap) {
    Vec3f place;
    blend_sheets(surface_, {now, &earlier_}, {&vertex, 1}, {.overlap = overlap, .radius = 0.5}, "some.brush",
                 {&place, 1});
    return place;
  }
  float height(const Vec3f& displacement, Overlap overlap) {
    const InstanceSheets now = piece(displacement);
    return blended({&now, 1}, overlap).z();
  }

  static constexpr Index vertex = 4;
  Surface surface_ = test::square(3);
  LiveChart live_;
  NodeOutputs outputs_;
  EarlierPieces earlier_;
};

TEST_F(EarlierPiecesTest, StayAsTheyAreBitForBit) {
  const Vec3f displacement(0.1f, -0.3f, 0.7f);
  const InstanceSheets first = piece(displacement);
  const Vec3f alone =
      displaced(surface_.positions[vertex], live_.nodes().e1[0], surface_.normals[vertex], displacement);
  earlier_.add({&first, 1}, 0.5);
  EXPECT_EQ(earlier_.count(), 1u);
  EXPECT_EQ(earlier_.at(vertex).size(), 1u);
  EXPECT_TRUE(earlier_.at(vertex + 1).empty());
  for (const auto& [name, overlap] : named_overlaps) EXPECT_EQ(blended({}, overlap), alone) << name;
}

TEST_F(EarlierPiecesTest, AreSheetsBesideThoseOfTheLaterPiece) {
  for (const float up : {-0.5f, 0.125f}) {
    const InstanceSheets now = piece({0, 0, up});
    earlier_.add({&now, 1}, 0.5);
  }
  const Vec3f last(0, 0, -0.25f);
  EXPECT_FLOAT_EQ(height(last, Overlap::latest), -0.25f);
  EXPECT_FLOAT_EQ(height(last, Overlap::max), 0.125f);
  EXPECT_FLOAT_EQ(height(last, Overlap::min), -0.5f);
  EXPECT_FLOAT_EQ(height(last, Overlap::add), -0.625f);
  EXPECT_FLOAT_EQ(height(last, Overlap::average), -0.625f / 3);
  EXPECT_FLOAT_EQ(height(last, Overlap::strongest), -0.375f);
}

}  // namespace
}  // namespace burin
