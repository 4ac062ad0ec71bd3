#include <burin/abi/stroke.h>
#include <burin/base/parallel.h>
#include <burin/deform/stroke_nodes.h>

#include <utility>

namespace burin {
namespace {

NodePen node_pen(const PenAt& at, std::uint64_t inputs) {
  NodePen pen;
  if (inputs & BURIN_INPUT_PRESSURE) pen.pressure = at.pen.pressure;
  if (inputs & BURIN_INPUT_TILT) {
    pen.tilt_x = at.pen.tilt_x;
    pen.tilt_y = at.pen.tilt_y;
  }
  if (inputs & BURIN_INPUT_TWIST) pen.twist = at.pen.twist;
  if (inputs & BURIN_INPUT_SPEED) pen.speed = static_cast<float>(at.speed);
  if (inputs & BURIN_INPUT_TIME) pen.time = static_cast<float>(at.time);
  return pen;
}

}  // namespace

StrokeNodes make_stroke_nodes(Chart chart, const SurfaceCurve& curve, double radius, std::uint64_t varying) {
  StrokeNodes nodes{std::move(chart), {}, {}};
  if (varying == 0) return nodes;
  const std::size_t size = nodes.chart.size();
  if (varying & BURIN_INPUT_RADIUS) nodes.half_width.resize(size);
  if (varying & ~BURIN_INPUT_RADIUS) nodes.pen.resize(size);
  parallel_blocks(size, 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const PenAt at = pen_at(curve, nodes.chart.t[i]);
      if (!nodes.half_width.empty()) nodes.half_width[i] = static_cast<float>(radius * at.width);
      if (!nodes.pen.empty()) nodes.pen[i] = node_pen(at, varying);
    }
  });
  return nodes;
}

std::uint64_t pen_inputs_present(const PenFields& fields) {
  std::uint64_t inputs = 0;
  if (fields.pressure) inputs |= BURIN_INPUT_PRESSURE;
  if (fields.tilt) inputs |= BURIN_INPUT_TILT;
  if (fields.twist) inputs |= BURIN_INPUT_TWIST;
  if (fields.time) inputs |= BURIN_INPUT_SPEED | BURIN_INPUT_TIME;
  return inputs;
}

}  // namespace burin
