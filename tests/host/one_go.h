#pragma once
#include <burin/chart/stroke_chart_builder.h>
#include <burin/deform/evaluate/evaluate.h>
#include <burin/deform/evaluate/stroke_nodes.h>
#include <burin/deform/stroke_passes.h>
#include <burin/host/plugin/param_snapshot.h>

#include "sessions.h"

namespace burin::test {

/// A stroke of the brush that mixes every input.
inline StrokeSettings every_input(Overlap overlap = Overlap::latest) {
  StrokeSettings every = settings("org.burin.test.every-input");
  every.fields = {.time = true, .pressure = true, .tilt = true, .twist = true};
  every.overlap = overlap;
  return every;
}

/// The positions after a finished stroke, computed at once from its final curve.
inline std::vector<Vec3f> in_one_go(const Surface& base, const SurfaceCurve& curve,
                                    const StrokeSettings& settings) {
  const BrushEntry& entry = brushes().find(settings.brush);
  const BrushPtr brush = brushes().create(entry);
  const ParamSnapshot params(*entry.descriptor, settings.params);
  const std::uint64_t pen = pen_inputs_present(settings.fields);
  const double radius = settings.radius;
  const DrivenStroke driven{settings.fields, radius, settings.seed};
  const StrokeWidth width(settings.pressure_width, settings.dynamics, driven);
  const ParamDynamics dynamics(*entry.descriptor, params.abi(), settings.dynamics, driven);
  const std::uint64_t varying = pen | (width.varies() ? BURIN_INPUT_RADIUS : 0);
  const burin_stroke_context context{.struct_size = sizeof(burin_stroke_context),
                                     .pass = 0,
                                     .flags = BURIN_STROKE_FINAL | (curve.closed ? BURIN_STROKE_CLOSED : 0),
                                     .pen_present = pen,
                                     .seed = settings.seed,
                                     .length = curve.length(),
                                     .radius_min = radius * width.narrowest(),
                                     .radius_max = radius,
                                     .object_scale = base.scale,
                                     .dab_t = 0};
  const BrushStroke stroke(*brush, *entry.descriptor, context, params.abi());
  LiveChart chart(base.vertex_count());
  StrokeNodes nodes(chart, {radius, entry.descriptor->inputs_read, varying, &dynamics});
  const SurfaceLevels levels(base);
  StrokeChartBuilder builder(base, &levels);
  chart.assign(builder.chart(curve, {.radius = radius, .cap = settings.cap, .follow = settings.follow}));
  const EndDistances ends(curve, radius, stroke.plan().end_influence);
  const std::vector<Index> vertices =
      nodes.follow(curve, 0, -std::numeric_limits<double>::infinity(), {&ends}).vertices;
  const FootLine foot(curve, radius);
  const NodeSource source{.surface = base,
                          .nodes = nodes,
                          .radius = static_cast<float>(radius),
                          .foot = &foot,
                          .base = builder.base()};
  NodeOutputs outputs;
  outputs.resize(chart.nodes().size(), paints(*entry.descriptor));
  EvaluatedInstance instance{source, context, static_cast<float>(settings.strength), outputs};
  const Overlap chosen = settings.overlap.value_or(overlap_of(*entry.descriptor));
  const BlendOptions blend{.overlap = over_passes(chosen, stroke.plan().passes), .radius = radius};
  Evaluator evaluator;
  StrokePasses(base, stroke, {&chart}, blend).update(evaluator, {&instance, 1}, vertices);
  std::vector<Vec3f> places(vertices.size()), positions = base.positions;
  const InstanceSheets sheets{&chart, &outputs, nodes.half_width()};
  blend_sheets(base, {{&sheets, 1}}, vertices, blend, entry.descriptor->id, places);
  for (std::size_t i = 0; i < vertices.size(); ++i) positions[vertices[i]] = places[i];
  return positions;
}

}  // namespace burin::test
