// Interpolates the inputs of a brush at points between chart nodes. A batch is filled for each of the points'
// three nodes, and the batches are averaged by the points' weights; directions are normalised again.
#include <burin/deform/evaluate/supported_inputs.h>
#include <burin/deform/solid/solid_batch.h>

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

std::size_t heaviest(const Vec3f& weights) {
  Eigen::Index at = 0;
  weights.maxCoeff(&at);
  return static_cast<std::size_t>(at);
}

float element(const burin_floats& values, std::size_t i) { return values.data[i * values.stride]; }
std::uint32_t element(const burin_indices& values, std::size_t i) { return values.data[i * values.stride]; }

}  // namespace

void SolidBatch::fill(const NodeSource& source, std::uint64_t inputs, const burin_params& params,
                      std::span<const ShellPoint> points, std::span<const Index> slots) {
  points_ = points;
  columns_.resize((sum(all_inputs).columns + params.count) * capacity);
  used_columns_ = 0;
  nodes_.resize(points.size());
  for (std::size_t corner = 0; corner < 3; ++corner) {
    for (std::size_t i = 0; i < points.size(); ++i) nodes_[i] = slots[points[i].nodes[corner]];
    corners_[corner].fill(source, inputs, 0, params, nodes_, {});
  }
  const burin_batch &a = corners_[0].inputs(), &b = corners_[1].inputs(), &c = corners_[2].inputs();
  batch_ = a;
  mix_params();
  mix(batch_.radius, a.radius, b.radius, c.radius);
  mix(batch_.stretch, a.stretch, b.stretch, c.stretch);
  mix(batch_.position.x, a.position.x, b.position.x, c.position.x);
  mix(batch_.position.y, a.position.y, b.position.y, c.position.y);
  mix(batch_.position.z, a.position.z, b.position.z, c.position.z);
  mix_directions(batch_.normal, a.normal, b.normal, c.normal);
  mix_directions(batch_.e1, a.e1, b.e1, c.e1);
  mix(batch_.pressure, a.pressure, b.pressure, c.pressure);
  mix(batch_.tilt_x, a.tilt_x, b.tilt_x, c.tilt_x);
  mix(batch_.tilt_y, a.tilt_y, b.tilt_y, c.tilt_y);
  mix(batch_.twist, a.twist, b.twist, c.twist);
  mix(batch_.speed, a.speed, b.speed, c.speed);
  mix(batch_.time, a.time, b.time, c.time);
  choose(batch_.sheet, sheets_, &burin_batch::sheet);
  choose(batch_.visit_count, visit_counts_, &burin_batch::visit_count);
  choose(batch_.node_id, node_ids_, &burin_batch::node_id);
  fill_coordinates(source, inputs);
}

void SolidBatch::mix(burin_floats& values, const burin_floats& a, const burin_floats& b,
                     const burin_floats& c) {
  if (!a.data || a.stride == 0) return;
  float* column = next_column();
  for (std::size_t i = 0; i < points_.size(); ++i)
    column[i] = points_[i].weights.dot(Vec3f(element(a, i), element(b, i), element(c, i)));
  values = {column, 1, 0};
}

void SolidBatch::mix_directions(burin_vectors& values, const burin_vectors& a, const burin_vectors& b,
                                const burin_vectors& c) {
  if (!a.x.data) return;
  const std::size_t first = used_columns_;
  mix(values.x, a.x, b.x, c.x);
  mix(values.y, a.y, b.y, c.y);
  mix(values.z, a.z, b.z, c.z);
  float *x = columns_.data() + first * capacity, *y = x + capacity, *z = y + capacity;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const Vec3f unit = Vec3f(x[i], y[i], z[i]).stableNormalized();
    x[i] = unit.x();
    y[i] = unit.y();
    z[i] = unit.z();
  }
}

/// Parameters that dynamics drive differ from node to node.
void SolidBatch::mix_params() {
  const burin_params &a = *corners_[0].inputs().params, &b = *corners_[1].inputs().params,
                     &c = *corners_[2].inputs().params;
  param_values_.assign(a.values, a.values + a.count);
  for (std::size_t p = 0; p < param_values_.size(); ++p)
    mix(param_values_[p].number, a.values[p].number, b.values[p].number, c.values[p].number);
  params_ = a;
  params_.values = param_values_.data();
  batch_.params = &params_;
}

void SolidBatch::choose(burin_indices& values, std::vector<std::uint32_t>& column,
                        burin_indices burin_batch::*member) {
  if (!values.data) return;
  column.resize(capacity);
  for (std::size_t i = 0; i < points_.size(); ++i)
    column[i] = element(corners_[heaviest(points_[i].weights)].inputs().*member, i);
  values = {column.data(), 1, 0};
}

void SolidBatch::fill_coordinates(const NodeSource& source, std::uint64_t inputs) {
  const auto fill = [&](burin_floats& values, const auto& value) {
    float* column = next_column();
    for (std::size_t i = 0; i < points_.size(); ++i) column[i] = value(points_[i]);
    values = {column, 1, 0};
  };
  if (inputs & BURIN_INPUT_T)
    fill(batch_.t, [](const ShellPoint& point) { return static_cast<float>(point.t); });
  if (inputs & BURIN_INPUT_D)
    fill(batch_.d, [&](const ShellPoint& point) { return source.mirrored ? -point.d : point.d; });
  heights_.resize(capacity);
  distances_.assign(capacity, 0);
  for (std::size_t i = 0; i < points_.size(); ++i) heights_[i] = points_[i].h;
}

float* SolidBatch::next_column() { return columns_.data() + capacity * used_columns_++; }

}  // namespace burin
