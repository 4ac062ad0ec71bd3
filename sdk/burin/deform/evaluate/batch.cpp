// Keeps the buffers of one call of a brush: float columns for all inputs and outputs, allocated once and
// filled for up to 1024 nodes at a time.
#include <burin/deform/evaluate/batch.h>
#include <burin/deform/evaluate/supported_inputs.h>

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

/// Clamps to 0..1; a value that is not finite stays as it is, so that it is detected later.
float in_range(float value) { return std::isfinite(value) ? std::clamp(value, 0.0f, 1.0f) : value; }

}  // namespace

Batch::Batch()
    : columns_((sum(all_outputs).columns + sum(all_inputs).columns) * capacity),
      sheets_(capacity),
      visit_counts_(capacity),
      node_ids_(capacity) {}

void Batch::fill(const NodeSource& source, std::uint64_t inputs, std::uint64_t outputs,
                 const burin_params& params, std::span<const Index> nodes,
                 std::span<const Vec3f> displacement) {
  source_ = &source;
  mirrored_ = source.mirrored;
  batch_ = {};
  batch_.struct_size = sizeof(burin_batch);
  batch_.count = static_cast<std::uint32_t>(nodes.size());
  batch_.params = &params_.fill(params, source.nodes.dynamics(), nodes);
  used_columns_ = 0;
  fill_outputs(outputs, nodes);
  fill_chart(inputs, nodes);
  fill_radius(inputs, nodes);
  fill_positions(inputs, nodes, displacement);
  fill_fine(inputs, nodes, displacement);
  fill_surroundings(inputs, nodes);
  fill_paint(inputs, nodes);
  fill_foot(inputs, nodes);
  fill_end_distance(inputs, nodes);
  fill_pen(inputs, nodes);
  fill_names(inputs, nodes);
}

void Batch::fill_outputs(std::uint64_t outputs, std::span<const Index> nodes) {
  outputs_ = {};
  outputs_.struct_size = sizeof(burin_outputs);
  outputs_.count = batch_.count;
  if (outputs & BURIN_OUTPUT_DISPLACEMENT) {
    for (burin_floats_out* out : {&outputs_.along, &outputs_.across, &outputs_.up}) {
      *out = {next_column(), 1, 0};
      std::fill_n(out->data, nodes.size(), 0.0f);
    }
  }
  if (!(outputs & (BURIN_OUTPUT_MASK | BURIN_OUTPUT_COLOUR))) return;
  const Paint& paint = source_->painted();
  tints_before_.resize(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i)
    tints_before_[i] = tint_of(paint.colour_of(vertex(nodes[i])), paint.mask_of(vertex(nodes[i])));
  const auto prepare = [&](const auto& before) {
    float* column = next_column();
    for (std::size_t i = 0; i < nodes.size(); ++i) column[i] = before(vertex(nodes[i]));
    return burin_floats_out{column, 1, 0};
  };
  if (outputs & BURIN_OUTPUT_MASK) outputs_.mask = prepare([&](Index v) { return paint.mask_of(v); });
  if (outputs & BURIN_OUTPUT_COLOUR)
    for (int k = 0; k < 4; ++k) outputs_.colour[k] = prepare([&](Index v) { return paint.colour_of(v)[k]; });
}

Vec3f Batch::displacement(std::size_t i) const {
  if (!outputs_.up.data) return Vec3f::Zero();
  return in_brush_frame({outputs_.along.data[i], outputs_.across.data[i], outputs_.up.data[i]});
}

Tint Batch::tint(std::size_t i) const {
  const Tint& before = tints_before_[i];
  const auto& rgba = outputs_.colour;
  const float mask = outputs_.mask.data ? in_range(outputs_.mask.data[i]) : before[4];
  const auto channel = [&](int k) { return in_range(rgba[k].data[i]); };
  if (rgba[0].data) return tint_of({channel(0), channel(1), channel(2), channel(3)}, mask);
  Tint tint = before;
  tint[4] = mask;
  return tint;
}

float* Batch::next_column() { return columns_.data() + capacity * used_columns_++; }

}  // namespace burin
