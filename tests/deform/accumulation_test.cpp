#include "deform_fixtures.h"
#include "support/shapes.h"

#include <burin/deform/accumulation.h>
#include <burin/surface/geometry/unit_tangent.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace burin {
namespace {

constexpr double apart = 10;  ///< in t, from visit to visit

/// A stroke that visits all of a surface several times.
Chart visits(const Surface& surface, int count) {
  Chart chart;
  chart.length = apart * count;
  chart.resize(static_cast<std::size_t>(count) * surface.vertex_count());
  for (Index vertex = 0; vertex < surface.vertex_count(); ++vertex)
    for (int visit = 0; visit < count; ++visit)
      chart.set(vertex * static_cast<Index>(count) + static_cast<Index>(visit), vertex,
                static_cast<std::uint32_t>(visit),
                {.t = apart * visit,
                 .d = 0,
                 .e1 = unit_tangent(Vec3f(1, 0.2f, 0.1f), surface.normals[vertex]),
                 .curvature = 0,
                 .stretch = 1},
                surface.normals[vertex]);
  return chart;
}

/// The positions of the vertices after the stroke.
std::vector<Vec3f> accumulated(const Surface& surface, const Chart& chart, test::TestBrush& brush,
                               double radius = 1) {
  const test::DrawnNodes drawn(surface, chart);
  const BrushStroke stroke(brush.brush, brush.descriptor, brush.context, brush.params);
  NodeOutputs outputs;
  outputs.resize(chart.size(), false);
  EvaluatedInstance instance{{surface, drawn.nodes, static_cast<float>(radius)}, brush.context, 1, outputs};
  std::vector<Index> vertices(surface.vertex_count()), reached;
  std::iota(vertices.begin(), vertices.end(), 0u);
  Evaluator evaluator;
  Accumulation(surface, stroke, radius).update(evaluator, instance, drawn.live, vertices, reached);
  EXPECT_EQ(reached.size(), chart.size());
  std::vector<Vec3f> places(vertices.size());
  const InstanceSheets sheets{&drawn.live, &outputs};
  blend_sheets(surface, {{&sheets, 1}}, vertices, {.overlap = Overlap::add}, "some.brush", places);
  return places;
}

using test::at;

constexpr std::uint64_t read = BURIN_INPUT_T | BURIN_INPUT_POSITION;

/// Raises all along the normal.
burin_status raise(const burin_stroke_context&, const burin_batch& batch, const burin_outputs& outputs,
                   burin_text*) {
  for (std::uint32_t i = 0; i < batch.count; ++i) outputs.up.data[i] = 0.1f;
  return BURIN_OK;
}

TEST(Accumulation, GoesOnAlongTheNormalOfASlope) {
  const Surface surface = test::square(9);
  // First a slope of 45 degrees, then up from that, more where it is higher.
  test::TestBrush brush(read,
                        [](const burin_stroke_context&, const burin_batch& batch,
                           const burin_outputs& outputs, burin_text*) -> burin_status {
                          for (std::uint32_t i = 0; i < batch.count; ++i)
                            outputs.up.data[i] =
                                at(batch.t, i) < 5 ? at(batch.position.x, i) : 0.1f * at(batch.position.z, i);
                          return BURIN_OK;
                        });
  const std::vector<Vec3f> places = accumulated(surface, visits(surface, 2), brush);
  for (Index vertex = 0; vertex < surface.vertex_count(); ++vertex) {
    const Vec3f& base = surface.positions[vertex];
    const Vec3f slope(base.x(), base.y(), base.x());
    const Vec3f expected = slope + 0.1f * base.x() * Vec3f(-1, 0, 1).normalized();
    EXPECT_LT((places[vertex] - expected).norm(), 1e-6f) << vertex;
  }
}

TEST(Accumulation, AddsUpWhereNormalsStay) {
  const Surface plane = test::square(9), sphere = make_surface(test::sphere(3, 0.2, 4));
  for (const int count : {1, 2, 5}) {
    test::TestBrush brush(read, raise);
    const auto up = 0.1f * static_cast<float>(count);
    const std::vector<Vec3f> flat = accumulated(plane, visits(plane, count), brush);
    for (Index vertex = 0; vertex < plane.vertex_count(); ++vertex)
      ASSERT_LT((flat[vertex] - plane.positions[vertex] - Vec3f(0, 0, up)).norm(), 1e-6f);
    const std::vector<Vec3f> round = accumulated(sphere, visits(sphere, count), brush);
    for (Index vertex = 0; vertex < sphere.vertex_count(); ++vertex)
      ASSERT_LT((round[vertex] - (1 + up) * sphere.positions[vertex]).norm(), 1e-5f) << count;
  }
}

TEST(Accumulation, ShowsTheUmbrellaOfWhatStandsThere) {
  const Surface sphere = make_surface(test::sphere(3, 0.2, 4));
  // Grows to twice the size, then takes the umbrella as a whole.
  test::TestBrush brush(
      read | BURIN_INPUT_LAPLACIAN | BURIN_INPUT_NORMAL | BURIN_INPUT_E1 | BURIN_INPUT_DISPLACEMENT,
      [](const burin_stroke_context&, const burin_batch& batch, const burin_outputs& outputs,
         burin_text*) -> burin_status {
        for (std::uint32_t i = 0; i < batch.count; ++i) {
          const auto vector = [&](const burin_vectors& of) {
            return Vec3f(at(of.x, i), at(of.y, i), at(of.z, i));
          };
          const Vec3f n = vector(batch.normal), e1 = vector(batch.e1), way = vector(batch.laplacian);
          const bool first = at(batch.t, i) < 5;
          if (vector(batch.displacement) != Vec3f(0, 0, 0)) return BURIN_ERROR;
          outputs.along.data[i] = first ? 0 : way.dot(e1);
          outputs.across.data[i] = first ? 0 : way.dot(n.cross(e1));
          outputs.up.data[i] = first ? 1 : way.dot(n);
        }
        return BURIN_OK;
      });
  const std::vector<Vec3f> places = accumulated(sphere, visits(sphere, 2), brush);
  for (Index vertex = 0; vertex < sphere.vertex_count(); ++vertex) {
    Vec3f middle = Vec3f::Zero();
    for (const Index neighbour : sphere.neighbours[vertex]) middle += 2 * sphere.positions[neighbour];
    middle /= static_cast<float>(sphere.neighbours[vertex].size());
    ASSERT_LT((places[vertex] - middle).norm(), 1e-5f);
  }
}

TEST(Accumulation, TakesOneVisitAroundTheSeamForOne) {
  const Surface surface = test::square(9);
  // Half of the nodes just before the seam, half just behind it: all on the base, no matter how steep.
  Chart seam = visits(surface, 1);
  seam.length = 20;
  seam.closed = true;
  for (Index i = 0; i < seam.size(); ++i) seam.t[i] = i % 2 ? 0.2 : 19.9;
  test::TestBrush brush(read,
                        [](const burin_stroke_context&, const burin_batch& batch,
                           const burin_outputs& outputs, burin_text*) -> burin_status {
                          for (std::uint32_t i = 0; i < batch.count; ++i)
                            outputs.up.data[i] = at(batch.position.x, i);
                          return BURIN_OK;
                        });
  const std::vector<Vec3f> places = accumulated(surface, seam, brush);
  for (Index vertex = 0; vertex < surface.vertex_count(); ++vertex)
    EXPECT_EQ(places[vertex], surface.positions[vertex] + Vec3f(0, 0, surface.positions[vertex].x()));
}

/// The neighbour's visits count although the vertex itself had no other.
TEST(Accumulation, FollowsANeighbourThatLostItsNode) {
  const Surface surface = test::square(9);
  LiveChart live(surface.vertex_count());
  StrokeNodes nodes(live, {});
  test::TestBrush brush(read, raise);
  const BrushStroke stroke(brush.brush, brush.descriptor, brush.context, brush.params);
  const Index vertex = 40, neighbour = surface.neighbours[vertex][0];
  const auto node = [](double t) {
    return ChartFrame{.t = t, .d = 0, .e1 = Vec3f::UnitX(), .curvature = 0, .stretch = 1};
  };
  live.begin_event(apart, false, 0);
  live.set(0, neighbour, node(0), surface.normals[neighbour]);
  live.set(1, vertex, node(apart), surface.normals[vertex]);
  NodeOutputs outputs;
  outputs.resize(2, false);
  EvaluatedInstance instance{{surface, nodes, 1}, brush.context, 1, outputs};
  const Accumulation accumulation(surface, stroke, 1);
  Evaluator evaluator;
  std::vector<Index> reached;
  const Index both[] = {vertex, neighbour};
  accumulation.update(evaluator, instance, live, both, reached);
  EXPECT_NE(outputs.displacement[1], Vec3f(0, 0, 0.1f)) << "it leans on the raised neighbour";
  live.begin_event(apart, false, 0);
  live.remove(0);
  accumulation.update(evaluator, instance, live, {&neighbour, 1}, reached);
  EXPECT_EQ(outputs.displacement[1], Vec3f(0, 0, 0.1f));
}

}  // namespace
}  // namespace burin
