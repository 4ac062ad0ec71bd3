#pragma once
#include <burin/abi/brush.h>
#include <burin/deform/evaluate/stroke_nodes.h>
#include <burin/surface/surface.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <utility>

namespace burin::test {

/// A square of `side` x `side` vertices over [0, 1]^2 in the plane z = 0, facing up.
inline Surface square(Index side) {
  TriangleMesh mesh;
  const float step = 1.0f / static_cast<float>(side - 1);
  for (Index row = 0; row < side; ++row)
    for (Index column = 0; column < side; ++column)
      mesh.positions.emplace_back(static_cast<float>(column) * step, static_cast<float>(row) * step, 0.0f);
  for (Index row = 0; row + 1 < side; ++row)
    for (Index column = 0; column + 1 < side; ++column) {
      const Index corner = row * side + column;
      mesh.triangles.push_back({corner, corner + 1, corner + side});
      mesh.triangles.push_back({corner + 1, corner + side + 1, corner + side});
    }
  return make_surface(std::move(mesh));
}

/// The chart of the stroke from (0, 0.5) along x to (length, 0.5) on `square`, of butt caps.
inline Chart straight_chart(const Surface& surface, float length, float radius) {
  Chart chart;
  for (Index vertex = 0; vertex < surface.vertex_count(); ++vertex) {
    const Vec3f& position = surface.positions[vertex];
    const float d = position.y() - 0.5f;
    if (position.x() > length || std::abs(d) > radius) continue;
    chart.vertex.push_back(vertex);
    chart.sheet.push_back(0);
    chart.stretch.push_back(1);
    chart.curvature.push_back(0);
    chart.normal.push_back(surface.normals[vertex]);
    chart.t.push_back(position.x());
    chart.d.push_back(d);
    chart.e1.push_back(Vec3f::UnitX());
  }
  return chart;
}

/// A straight curve along x from (0, 0.5) to (1, 0.5), drawn in 2 s with rising pressure and tilt.
inline SurfaceCurve straight_curve() {
  SurfaceCurve curve;
  for (const float t : {0.0f, 0.5f, 1.0f}) {
    CurvePoint point{};
    point.at.position = Vec3f(t, 0.5f, 0);
    point.normal = Vec3f::UnitZ();
    point.tangent = Vec3f::UnitX();
    point.t = t;
    point.time = 2 * t;
    point.speed = 0.5;
    point.pen = {.pressure = t, .tilt_x = 0.5f * t};
    curve.points.push_back(point);
  }
  return curve;
}

/// The nodes of a chart as a brush sees them that reads these inputs; slot i is node i.
struct DrawnNodes {
  DrawnNodes(const Surface& surface, const Chart& chart, const ReadInputs& reads = {},
             const SurfaceCurve& curve = straight_curve())
      : live(surface.vertex_count()), nodes(live, reads) {
    live.assign(chart);
    const EndDistances ends(curve, 0.3, 0.2);
    nodes.follow(curve, std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
                 {&ends});
  }
  DrawnNodes(const DrawnNodes&) = delete;
  DrawnNodes& operator=(const DrawnNodes&) = delete;

  LiveChart live;
  StrokeNodes nodes;
};

/// A brush whose evaluate is a function of the test.
class TestBrush {
 public:
  using Evaluate = std::function<burin_status(const burin_stroke_context&, const burin_batch&,
                                              const burin_outputs&, burin_text*)>;

  TestBrush(std::uint64_t inputs, Evaluate evaluate) : evaluate_(std::move(evaluate)) {
    descriptor.struct_size = sizeof(descriptor);
    descriptor.id = "org.burin.test.function";
    descriptor.inputs_read = inputs;
    descriptor.outputs_written = BURIN_OUTPUT_DISPLACEMENT;
    brush.struct_size = sizeof(brush);
    brush.self = this;
    brush.begin = [](const burin_brush* self, const burin_stroke_context*, const burin_params*,
                     burin_stroke_plan* plan, void**, burin_text*) -> burin_status {
      TestBrush& test = of(self);
      plan->passes = test.passes;
      plan->end_influence = test.end_influence;
      if (test.begin_status == BURIN_OK) ++test.open_strokes;
      return test.begin_status;
    };
    brush.evaluate = [](const burin_brush* self, void*, const burin_stroke_context* now,
                        const burin_batch* batch, const burin_outputs* outputs,
                        burin_text* error) { return of(self).evaluate_(*now, *batch, *outputs, error); };
    brush.end = [](const burin_brush* self, void*) { --of(self).open_strokes; };
  }
  TestBrush(const TestBrush&) = delete;
  TestBrush& operator=(const TestBrush&) = delete;

  burin_brush brush{};
  burin_brush_descriptor descriptor{};
  burin_params params{sizeof(burin_params), 0, nullptr};
  burin_stroke_context context{};
  std::uint32_t passes = 1;
  double end_influence = 0;
  burin_status begin_status = BURIN_OK;
  int open_strokes = 0;

 private:
  static TestBrush& of(const burin_brush* brush) { return *static_cast<TestBrush*>(brush->self); }

  Evaluate evaluate_;
};

inline float at(const burin_floats& floats, std::size_t i) { return floats.data[i * floats.stride]; }

}  // namespace burin::test
