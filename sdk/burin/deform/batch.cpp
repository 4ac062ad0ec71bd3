#include <burin/deform/batch.h>
#include <burin/deform/displacement.h>

#include <algorithm>

namespace burin {
namespace {

constexpr std::size_t output_columns = 3;
// t, d, radius, stretch; position, normal, e1, displacement; six of the pen
constexpr std::size_t input_columns = 22;

constexpr float zero = 0, one = 1;

burin_floats uniform(const float& value) { return {&value, 0, 0}; }

}  // namespace

Batch::Batch()
    : columns_((output_columns + input_columns) * capacity),
      sheets_(capacity),
      visit_counts_(capacity),
      node_ids_(capacity) {}

void Batch::fill(const NodeSource& source, std::uint64_t inputs, std::uint64_t outputs,
                 const burin_params& params, std::span<const Index> nodes,
                 std::span<const Vec3f> displacement) {
  batch_ = {};
  batch_.struct_size = sizeof(burin_batch);
  batch_.count = static_cast<std::uint32_t>(nodes.size());
  batch_.params = &params_.fill(params, source.nodes.dynamics(), nodes);
  outputs_ = {};
  outputs_.struct_size = sizeof(burin_outputs);
  outputs_.count = batch_.count;
  used_columns_ = 0;
  if (outputs & BURIN_OUTPUT_DISPLACEMENT) {
    for (burin_floats_out* out : {&outputs_.along, &outputs_.across, &outputs_.up}) {
      *out = {next_column(), 1, 0};
      std::fill_n(out->data, nodes.size(), 0.0f);
    }
  }
  fill_chart(source, inputs, nodes);
  fill_place(source, inputs, nodes, displacement);
  fill_pen(source.nodes.pen(), inputs, nodes);
  fill_names(source, inputs, nodes);
}

Vec3f Batch::displacement(std::size_t i) const {
  if (!outputs_.up.data) return Vec3f::Zero();
  return {outputs_.along.data[i], outputs_.across.data[i], outputs_.up.data[i]};
}

float* Batch::next_column() { return columns_.data() + capacity * used_columns_++; }

template <class Value>
burin_floats Batch::numbers(std::span<const Index> nodes, const Value& value) {
  float* column = next_column();
  for (std::size_t i = 0; i < nodes.size(); ++i) column[i] = value(nodes[i]);
  return {column, 1, 0};
}

template <class Value>
burin_indices Batch::numbers(std::span<const Index> nodes, std::vector<std::uint32_t>& column,
                             const Value& value) {
  for (std::size_t i = 0; i < nodes.size(); ++i) column[i] = value(nodes[i]);
  return {column.data(), 1, 0};
}

template <class Value>
burin_vectors Batch::vectors(std::size_t count, const Value& value) {
  float *x = next_column(), *y = next_column(), *z = next_column();
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3f vector = value(i);
    x[i] = vector.x();
    y[i] = vector.y();
    z[i] = vector.z();
  }
  return {{x, 1, 0}, {y, 1, 0}, {z, 1, 0}};
}

void Batch::fill_chart(const NodeSource& source, std::uint64_t inputs, std::span<const Index> nodes) {
  const Chart& chart = source.nodes.chart();
  if (inputs & BURIN_INPUT_T)
    batch_.t = numbers(nodes, [&](Index node) { return static_cast<float>(chart.t[node]); });
  if (inputs & BURIN_INPUT_D) batch_.d = numbers(nodes, [&](Index node) { return chart.d[node]; });
  if (inputs & BURIN_INPUT_E1)
    batch_.e1 = vectors(nodes.size(), [&](std::size_t i) { return chart.e1[nodes[i]]; });
  if (inputs & BURIN_INPUT_STRETCH)
    batch_.stretch = numbers(nodes, [&](Index node) { return chart.stretch[node]; });
  radius_ = source.radius;
  if (inputs & BURIN_INPUT_RADIUS) {
    const std::vector<float>& half_width = source.nodes.half_width();
    batch_.radius =
        half_width.empty() ? uniform(radius_) : numbers(nodes, [&](Index node) { return half_width[node]; });
  }
}

void Batch::fill_place(const NodeSource& source, std::uint64_t inputs, std::span<const Index> nodes,
                       std::span<const Vec3f> displacement) {
  const Chart& chart = source.nodes.chart();
  const Surface& surface = source.surface;
  if (inputs & BURIN_INPUT_POSITION)
    batch_.position = vectors(nodes.size(), [&](std::size_t i) {
      const Index vertex = chart.vertex[nodes[i]];
      const Vec3f& base = surface.positions[vertex];
      if (displacement.empty()) return base;
      return displaced(base, chart.e1[nodes[i]], surface.normals[vertex], displacement[i]);
    });
  if (inputs & BURIN_INPUT_NORMAL)
    batch_.normal =
        vectors(nodes.size(), [&](std::size_t i) { return surface.normals[chart.vertex[nodes[i]]]; });
  if (!(inputs & BURIN_INPUT_DISPLACEMENT)) return;
  batch_.displacement = displacement.empty()
                            ? burin_vectors{uniform(zero), uniform(zero), uniform(zero)}
                            : vectors(nodes.size(), [&](std::size_t i) { return displacement[i]; });
}

void Batch::fill_pen(const std::vector<NodePen>& pen, std::uint64_t inputs, std::span<const Index> nodes) {
  const auto field = [&](std::uint64_t input, float NodePen::*member, const float& neutral) {
    if (!(inputs & input)) return burin_floats{};
    if (pen.empty()) return uniform(neutral);
    return numbers(nodes, [&](Index node) { return pen[node].*member; });
  };
  batch_.pressure = field(BURIN_INPUT_PRESSURE, &NodePen::pressure, one);
  batch_.tilt_x = field(BURIN_INPUT_TILT, &NodePen::tilt_x, zero);
  batch_.tilt_y = field(BURIN_INPUT_TILT, &NodePen::tilt_y, zero);
  batch_.twist = field(BURIN_INPUT_TWIST, &NodePen::twist, zero);
  batch_.speed = field(BURIN_INPUT_SPEED, &NodePen::speed, zero);
  batch_.time = field(BURIN_INPUT_TIME, &NodePen::time, zero);
}

void Batch::fill_names(const NodeSource& source, std::uint64_t inputs, std::span<const Index> nodes) {
  const Chart& chart = source.nodes.chart();
  if (inputs & BURIN_INPUT_SHEET)
    batch_.sheet = numbers(nodes, sheets_, [&](Index node) { return chart.sheet[node]; });
  if (inputs & BURIN_INPUT_VISIT_COUNT)
    batch_.visit_count = numbers(nodes, visit_counts_, [&](Index node) {
      return source.nodes.live().sheet_count(chart.vertex[node]);
    });
  if (inputs & BURIN_INPUT_NODE_ID)
    batch_.node_id = numbers(nodes, node_ids_,
                             [&](Index node) { return source.surface.source_vertex[chart.vertex[node]]; });
}

}  // namespace burin
