#include "deform_fixtures.h"

#include <burin/deform/batch.h>
#include <burin/deform/offered.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <numeric>

namespace burin {
namespace {

class BatchTest : public ::testing::Test {
 protected:
  BatchTest() : surface_(test::square(12)) { use(test::straight_chart(surface_, 0.6f, 0.3f)); }

  void use(const Chart& chart, const ReadInputs& reads = {},
           const SurfaceCurve& curve = test::straight_curve()) {
    drawn_ = std::make_unique<test::DrawnNodes>(surface_, chart, reads, curve);
    listed_.resize(chart.size() - 5);
    std::iota(listed_.begin(), listed_.end(), 5u);
  }

  const burin_batch& fill(std::uint64_t inputs, std::span<const Vec3f> displacement = {},
                          std::uint64_t outputs = BURIN_OUTPUT_DISPLACEMENT) {
    const FootLine foot(test::straight_curve(), 0.3);
    batch_.fill({.surface = surface_, .nodes = drawn_->nodes, .radius = 0.3f, .foot = &foot}, inputs, outputs,
                params_, listed_, displacement);
    return batch_.inputs();
  }

  Chart chart() const { return drawn_->live.nodes(); }
  Index vertex(std::size_t i) const { return drawn_->live.nodes().vertex[listed_[i]]; }

  Surface surface_;
  std::unique_ptr<test::DrawnNodes> drawn_;
  std::vector<Index> listed_;
  burin_params params_{sizeof(burin_params), 0, nullptr};
  Batch batch_;
};

float at(const burin_floats& floats, std::size_t i) { return floats.data[i * floats.stride]; }

TEST_F(BatchTest, LeavesWhatIsNotDeclaredNull) {
  const burin_batch& batch = fill(BURIN_INPUT_D);
  EXPECT_EQ(batch.count, listed_.size());
  EXPECT_EQ(batch.params, &params_);
  EXPECT_NE(batch.d.data, nullptr);
  for (const void* array :
       {static_cast<const void*>(batch.t.data), static_cast<const void*>(batch.radius.data),
        static_cast<const void*>(batch.position.x.data), static_cast<const void*>(batch.displacement.z.data),
        static_cast<const void*>(batch.node_id.data), static_cast<const void*>(batch.sheet.data),
        static_cast<const void*>(batch.time.data), static_cast<const void*>(batch.laplacian.x.data)})
    EXPECT_EQ(array, nullptr);
  EXPECT_EQ(batch_.outputs().mask.data, nullptr);
  EXPECT_EQ(batch_.outputs().colour[0].data, nullptr);
}

TEST_F(BatchTest, LeavesOutputsThatAreNotDeclaredNullAndTheSurfaceWhereItIs) {
  fill(BURIN_INPUT_D, {}, 0);
  EXPECT_EQ(batch_.outputs().along.data, nullptr);
  EXPECT_EQ(batch_.outputs().across.data, nullptr);
  EXPECT_EQ(batch_.outputs().up.data, nullptr);
  EXPECT_EQ(batch_.displacement(3), Vec3f(0, 0, 0));
}

TEST_F(BatchTest, FillsTheNodesInTheirOrder) {
  const burin_batch& batch = fill(offered_inputs);
  ASSERT_GT(batch.count, 30u);
  for (std::size_t i = 0; i < batch.count; ++i) {
    const Vec3f& position = surface_.positions[vertex(i)];
    EXPECT_EQ(at(batch.t, i), position.x());
    EXPECT_EQ(at(batch.d, i), position.y() - 0.5f);
    EXPECT_EQ(at(batch.position.y, i), position.y());
    EXPECT_EQ(at(batch.normal.z, i), surface_.normals[vertex(i)].z());
    EXPECT_EQ(at(batch.e1.x, i), 1.0f);
    EXPECT_EQ(at(batch.stretch, i), 1.0f);
    EXPECT_EQ(batch.node_id.data[i * batch.node_id.stride], surface_.source_vertex[vertex(i)]);
  }
}

TEST_F(BatchTest, SaysOnceWhatIsTheSameForAll) {
  const burin_batch& batch = fill(offered_inputs);
  const burin_floats uniform[] = {batch.radius, batch.displacement.x, batch.pressure, batch.tilt_x,
                                  batch.time};
  for (const burin_floats& floats : uniform) EXPECT_EQ(floats.stride, 0u);
  EXPECT_EQ(*batch.radius.data, 0.3f);
  EXPECT_EQ(*batch.displacement.x.data, 0.0f);
  EXPECT_EQ(*batch.pressure.data, 1.0f);
  EXPECT_EQ(*batch.tilt_y.data, 0.0f);
}

TEST_F(BatchTest, FillsThePenWhereNodesHaveOne) {
  use(chart(), {.radius = 0.3, .inputs = BURIN_INPUT_PRESSURE, .varying = BURIN_INPUT_PRESSURE});
  const burin_batch& batch = fill(BURIN_INPUT_PRESSURE | BURIN_INPUT_SPEED);
  for (std::size_t i = 0; i < batch.count; ++i)
    EXPECT_NEAR(at(batch.pressure, i), chart().t[listed_[i]], 1e-6) << "as the curve has it";
  EXPECT_EQ(at(batch.speed, 3), 0.0f);
  EXPECT_EQ(batch.tilt_x.data, nullptr);
}

TEST_F(BatchTest, FillsTheHalfWidthWhereItVaries) {
  SurfaceCurve narrowing = test::straight_curve();
  for (CurvePoint& point : narrowing.points) point.width = 1 - 0.5f * static_cast<float>(point.t);
  use(chart(), {.radius = 0.3, .inputs = BURIN_INPUT_RADIUS, .varying = BURIN_INPUT_RADIUS}, narrowing);
  const burin_batch& batch = fill(BURIN_INPUT_RADIUS);
  for (std::size_t i = 0; i < batch.count; ++i)
    EXPECT_NEAR(at(batch.radius, i), 0.3 - 0.15 * chart().t[listed_[i]], 1e-6);
}

TEST_F(BatchTest, CountsTheSheetsOfEachVertex) {
  // Vertices with one to four nodes, in turn.
  Chart sheets = chart();
  std::vector<Index> counts;
  const std::size_t size = sheets.size();
  for (Index vertex = 0, node = 0; node < size; ++vertex)
    for (Index sheet = 0; sheet <= vertex % 4 && node < size; ++sheet, ++node) {
      sheets.vertex[node] = vertex;
      sheets.t[node] = sheet;
      sheets.sheet[node] = sheet;
    }
  for (const Index of : sheets.vertex)
    counts.push_back(static_cast<Index>(std::ranges::count(sheets.vertex, of)));
  use(sheets);
  const burin_batch& batch = fill(BURIN_INPUT_SHEET | BURIN_INPUT_VISIT_COUNT);
  ASSERT_GT(batch.count, 30u);
  for (std::size_t i = 0; i < batch.count; ++i) {
    EXPECT_EQ(batch.sheet.data[i * batch.sheet.stride], sheets.sheet[listed_[i]]);
    EXPECT_EQ(batch.visit_count.data[i * batch.visit_count.stride], counts[listed_[i]]);
  }
}

TEST_F(BatchTest, ShowsThePassBefore) {
  const std::vector<Vec3f> displacement(listed_.size(), Vec3f(0.1f, 0.2f, 0.3f));
  const burin_batch& batch = fill(BURIN_INPUT_POSITION | BURIN_INPUT_DISPLACEMENT, displacement);
  for (std::size_t i = 0; i < batch.count; ++i) {
    const Vec3f moved = surface_.positions[vertex(i)] + Vec3f(0.1f, 0.2f, 0.3f);
    EXPECT_EQ(Vec3f(at(batch.position.x, i), at(batch.position.y, i), at(batch.position.z, i)), moved);
    EXPECT_EQ(at(batch.displacement.z, i), 0.3f);
  }
}

TEST_F(BatchTest, HandsOutZeroedOutputsEveryTime) {
  fill(BURIN_INPUT_T);
  batch_.outputs().up.data[2] = 7;
  EXPECT_EQ(batch_.displacement(2), Vec3f(0, 0, 7));
  fill(BURIN_INPUT_T);
  EXPECT_EQ(batch_.displacement(2), Vec3f(0, 0, 0));
}

}  // namespace
}  // namespace burin
