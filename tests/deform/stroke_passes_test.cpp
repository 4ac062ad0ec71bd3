#include "deform_fixtures.h"

#include <burin/deform/stroke_passes.h>
#include <burin/surface/geometry/unit_tangent.h>
#include <burin/surface/topology/surroundings.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace burin {
namespace {

constexpr float share = 0.5f;
constexpr std::uint32_t passes = 6;

using test::at;
Vec3f at(const burin_vectors& vectors, std::size_t i) {
  return {at(vectors.x, i), at(vectors.y, i), at(vectors.z, i)};
}

/// Moves nodes a share of the way to the middle of their neighbours.
burin_status smooth(const burin_stroke_context&, const burin_batch& batch, const burin_outputs& outputs,
                    burin_text*) {
  for (std::uint32_t i = 0; i < batch.count; ++i) {
    const Vec3f way = share * at(batch.laplacian, i), n = at(batch.normal, i), e1 = at(batch.e1, i);
    const Vec3f moved = at(batch.displacement, i);
    outputs.along.data[i] = moved.x() + way.dot(e1);
    outputs.across.data[i] = moved.y() + way.dot(n.cross(e1));
    outputs.up.data[i] = moved.z() + way.dot(n);
  }
  return BURIN_OK;
}

/// A rough height field.
Surface rough(std::uint32_t seed) {
  const Surface flat = test::square(30);
  TriangleMesh mesh{.positions = flat.positions, .triangles = flat.triangles};
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> height(0, 0.02f);
  for (Vec3f& place : mesh.positions) place.z() = height(random);
  return make_surface(std::move(mesh));
}

class StrokePassesTest : public ::testing::Test {
 protected:
  StrokePassesTest()
      : surface_(rough(3)),
        brush_(BURIN_INPUT_LAPLACIAN | BURIN_INPUT_DISPLACEMENT | BURIN_INPUT_NORMAL | BURIN_INPUT_E1,
               smooth) {
    RecordProperty("seed", 3);
    brush_.passes = passes;
    chart_ = test::straight_chart(surface_, 0.8f, 0.3f);
    for (std::size_t i = 0; i < chart_.size(); ++i)
      chart_.e1[i] = unit_tangent(Vec3f::UnitX(), surface_.normals[chart_.vertex[i]]);
  }

  /// Explicit steps of the chart's vertices, the others fixed.
  std::vector<Vec3f> smoothed() const {
    std::vector<Vec3f> places = surface_.positions;
    for (std::uint32_t pass = 0; pass < passes; ++pass) {
      const std::vector<Vec3f> before = places;
      for (const Index vertex : chart_.vertex)
        places[vertex] += share * umbrella(surface_, vertex, [&](Index v) { return before[v]; });
    }
    return places;
  }

  Surface surface_;
  test::TestBrush brush_;
  Chart chart_;
  Evaluator evaluator_;
};

TEST_F(StrokePassesTest, TakeTheExplicitStepsOfSmoothing) {
  const test::DrawnNodes drawn(surface_, chart_);
  const BrushStroke stroke(brush_.brush, brush_.descriptor, brush_.context, brush_.params);
  NodeOutputs outputs;
  outputs.resize(chart_.size(), false);
  EvaluatedInstance instance{{surface_, drawn.nodes, 0.3f}, brush_.context, 1, outputs};
  const std::vector<Index> vertices =
      StrokePasses(surface_, stroke, {&drawn.live}, {}).update(evaluator_, {&instance, 1}, chart_.vertex);
  EXPECT_EQ(vertices.size(), chart_.size());
  std::vector<Vec3f> places(vertices.size());
  const InstanceSheets sheets{&drawn.live, &outputs};
  blend_sheets(surface_, {{&sheets, 1}}, vertices, {}, "some.brush", places);
  const std::vector<Vec3f> expected = smoothed();
  float most = 0;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    ASSERT_LT((places[i] - expected[vertices[i]]).norm(), 1e-6f);
    most = std::max(most, (places[i] - surface_.positions[vertices[i]]).norm());
  }
  EXPECT_GT(most, 0.01f);
}

TEST_F(StrokePassesTest, FollowChangesAsFarAsTheyReach) {
  LiveChart live(surface_.vertex_count());
  StrokeNodes nodes(live, {});
  const BrushStroke stroke(brush_.brush, brush_.descriptor, brush_.context, brush_.params);
  StrokePasses growing(surface_, stroke, {&live}, {});
  NodeOutputs outputs;
  std::size_t most = 0;
  // Column after column.
  for (float to = 0.1f; to < 0.9f; to += 0.1f) {
    live.begin_event(to, false, 0);
    std::vector<Index> added;
    for (Index i = 0; i < chart_.size(); ++i) {
      if (chart_.t[i] < to - 0.1f || chart_.t[i] >= to) continue;
      live.set(static_cast<Index>(live.nodes().size()), chart_.vertex[i], chart_.frame(i), chart_.normal[i]);
      added.push_back(chart_.vertex[i]);
    }
    outputs.resize(live.nodes().size(), false);
    EvaluatedInstance instance{{surface_, nodes, 0.3f}, brush_.context, 1, outputs};
    const std::vector<Index> reached = growing.update(evaluator_, {&instance, 1}, added);
    EXPECT_TRUE(std::ranges::is_sorted(reached));
    EXPECT_GE(reached.size(), added.size());
    most = std::max(most, reached.size());
  }
  ASSERT_EQ(live.nodes().size(), chart_.size());
  EXPECT_LT(most, chart_.size() / 2);
  NodeOutputs fresh;
  fresh.resize(chart_.size(), false);
  EvaluatedInstance instance{{surface_, nodes, 0.3f}, brush_.context, 1, fresh};
  StrokePasses(surface_, stroke, {&live}, {}).update(evaluator_, {&instance, 1}, chart_.vertex);
  EXPECT_EQ(outputs.displacement, fresh.displacement) << "bit for bit";
}

}  // namespace
}  // namespace burin
