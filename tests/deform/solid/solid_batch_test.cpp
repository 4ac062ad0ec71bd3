#include <burin/deform/evaluate/supported_inputs.h>
#include <burin/deform/solid/solid_batch.h>
#include <gtest/gtest.h>

#include <numeric>
#include <random>
#include <type_traits>

#include "deform/deform_fixtures.h"

namespace burin {
namespace {

float at(const burin_floats& floats, std::size_t i) { return floats.data[i * floats.stride]; }
Vec3f at(const burin_vectors& vectors, std::size_t i) {
  return {at(vectors.x, i), at(vectors.y, i), at(vectors.z, i)};
}

/// Points between nodes of a straight chart, whose slots are in reverse order of the points' numbers.
class SolidBatchTest : public ::testing::Test {
 protected:
  SolidBatchTest()
      : surface_(test::square(12)),
        reads_{.radius = 0.3,
               .inputs = SolidBatch::inputs_offered,
               .varying = BURIN_INPUT_PRESSURE | BURIN_INPUT_TILT | BURIN_INPUT_TIME},
        drawn_(surface_, test::straight_chart(surface_, 1, 0.3F), reads_) {
    slots_.resize(chart().size());
    std::iota(slots_.rbegin(), slots_.rend(), 0u);
    std::mt19937 random(3);
    for (int i = 0; i < 40; ++i) {
      ShellPoint point;
      for (Index& node : point.nodes) node = static_cast<Index>(random() % chart().size());
      const float a = 0.1F * static_cast<float>(random() % 5), b = 0.1F * static_cast<float>(random() % 5);
      point.weights = Vec3f(a, b, 1 - a - b);
      point.t = 0.25 + 0.01 * i;
      point.d = 0.125F;
      point.h = 0.5F * static_cast<float>(i);
      points_.push_back(point);
    }
  }

  const Chart& chart() const { return drawn_.live.nodes(); }
  Index slot(std::size_t point, std::size_t corner) const { return slots_[points_[point].nodes[corner]]; }

  /// Of the values of its nodes.
  template <class Value>
  std::invoke_result_t<Value, Index> mixed(std::size_t point, const Value& value) const {
    const Vec3f& w = points_[point].weights;
    return (w[0] * value(slot(point, 0)) + w[1] * value(slot(point, 1)) + w[2] * value(slot(point, 2)));
  }

  const burin_batch& fill(std::uint64_t inputs, bool mirrored = false) {
    batch_.fill({.surface = surface_, .nodes = drawn_.nodes, .radius = 0.3F, .mirrored = mirrored}, inputs,
                params_, points_, slots_);
    return batch_.inputs();
  }

  Surface surface_;
  ReadInputs reads_;
  test::DrawnNodes drawn_;
  std::vector<Index> slots_;
  std::vector<ShellPoint> points_;
  burin_params params_{sizeof(burin_params), 0, nullptr};
  SolidBatch batch_;
};

TEST_F(SolidBatchTest, HasThePointsOwnCoordinates) {
  const burin_batch& batch = fill(BURIN_INPUT_T | BURIN_INPUT_D);
  ASSERT_EQ(batch.count, points_.size());
  for (std::size_t i = 0; i < points_.size(); ++i) {
    EXPECT_EQ(at(batch.t, i), static_cast<float>(points_[i].t));
    EXPECT_EQ(at(batch.d, i), points_[i].d);
    EXPECT_EQ(at(batch_.heights(), i), points_[i].h);
  }
  EXPECT_EQ(at(fill(BURIN_INPUT_D, true).d, 3), -points_[3].d);
}

TEST_F(SolidBatchTest, InterpolatesWhatHoldsAtTheNodes) {
  const burin_batch& batch = fill(SolidBatch::inputs_offered);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const Vec3f position = mixed(i, [&](Index s) -> Vec3f { return surface_.positions[chart().vertex[s]]; });
    EXPECT_LE((at(batch.position, i) - position).norm(), 1e-6F);
    EXPECT_NEAR(at(batch.pressure, i), mixed(i, [&](Index s) { return drawn_.nodes.pen()[s].pressure; }),
                1e-6F);
    EXPECT_NEAR(at(batch.time, i), mixed(i, [&](Index s) { return drawn_.nodes.pen()[s].time; }), 1e-6F);
    EXPECT_LE((at(batch.normal, i) - Vec3f::UnitZ()).norm(), 1e-6F);
    EXPECT_LE((at(batch.e1, i) - Vec3f::UnitX()).norm(), 1e-6F);
    EXPECT_EQ(at(batch.radius, i), 0.3F);
    Eigen::Index heaviest = 0;
    points_[i].weights.maxCoeff(&heaviest);
    EXPECT_EQ(batch.node_id.data[i * batch.node_id.stride],
              surface_.source_vertex[chart().vertex[slot(i, static_cast<std::size_t>(heaviest))]]);
  }
}

TEST_F(SolidBatchTest, LeavesWhatIsNotDeclaredNull) {
  const burin_batch& batch = fill(BURIN_INPUT_T);
  EXPECT_NE(batch.t.data, nullptr);
  for (const float* array : {batch.d.data, batch.radius.data, batch.position.x.data, batch.pressure.data})
    EXPECT_EQ(array, nullptr);
  EXPECT_EQ(batch.node_id.data, nullptr);
}

TEST(SolidInputs, AreAmongThoseThatTheHostOffers) {
  EXPECT_EQ(SolidBatch::inputs_offered & ~supported_inputs, 0u);
}

}  // namespace
}  // namespace burin
