// Copies the arrays of a batch into a lane, one column each, and its outputs back. Costs the bytes of both.
#include <burin/base/error.h>
#include <burin/host/isolate/lane_batch.h>

#include <algorithm>
#include <cstring>

namespace burin::isolate {
namespace {

/// Columns begin at multiples of this.
constexpr std::size_t alignment = 64;

constexpr std::size_t aligned(std::size_t bytes) { return (bytes + alignment - 1) / alignment * alignment; }

std::array<burin_floats, batch_arrays> inputs_of(const burin_batch& batch) {
  std::array<burin_floats, batch_arrays> arrays{};
  std::memcpy(&arrays, reinterpret_cast<const std::byte*>(&batch) + offsetof(burin_batch, t), sizeof arrays);
  return arrays;
}

std::array<burin_floats_out, output_arrays> outputs_of(const burin_outputs& outputs) {
  std::array<burin_floats_out, output_arrays> arrays{};
  std::memcpy(&arrays, reinterpret_cast<const std::byte*>(&outputs) + offsetof(burin_outputs, along),
              sizeof arrays);
  return arrays;
}

burin_floats read_of(const burin_floats_out& array) { return {array.data, array.stride, 0}; }

/// Puts columns into a lane one after the other.
class Packer {
 public:
  Packer(std::byte* lane, std::size_t begin, std::size_t first, std::size_t count)
      : lane_(lane), end_(aligned(begin)), first_(first), count_(count) {}

  Column add(const burin_floats& array) {
    if (!array.data) return {};
    const bool one = array.stride == 0;
    const Column column{one ? Column::one : Column::each, static_cast<std::uint32_t>(end_)};
    auto* to = reinterpret_cast<float*>(lane_ + end_);
    const std::size_t values = one ? 1 : count_;
    // By bytes: arrays of whole numbers pass here too.
    if (array.stride <= 1)
      std::memcpy(to, array.data + first_ * array.stride, values * sizeof(float));
    else
      for (std::size_t i = 0; i < values; ++i)
        std::memcpy(to + i, array.data + (first_ + i) * array.stride, sizeof(float));
    end_ += aligned(values * sizeof(float));
    return column;
  }

 private:
  std::byte* lane_;
  std::size_t end_, first_, count_;
};

/// Calls `use` with each array that the brush reads, outputs included, in the order in which they are packed.
template <class Use>
void for_arrays(const BatchCall& call, const Use& use) {
  const burin_params* params = call.batch.params;
  for (std::size_t i = 0; params && i < params->count; ++i) {
    use(params->values[i].number);
    for (const burin_floats& channel : params->values[i].colour) use(channel);
  }
  for (const burin_floats& array : inputs_of(call.batch)) use(array);
  for (const burin_floats_out& array : outputs_of(call.outputs)) use(read_of(array));
  use(call.height);
  use(read_of(call.distance));
}

std::size_t bytes_before_columns(const BatchCall& call) {
  const std::size_t params = call.batch.params ? call.batch.params->count : 0;
  return aligned(sizeof(LaneCall) + params * param_arrays * sizeof(Column));
}

}  // namespace

std::size_t elements_that_fit(const BatchCall& call) {
  std::size_t fixed = bytes_before_columns(call), each = 0;
  for_arrays(call, [&](const burin_floats& array) {
    if (!array.data) return;
    fixed += alignment;  // its one value, or what its column is longer than its values
    if (array.stride != 0) each += sizeof(float);
  });
  if (fixed + each > lane_bytes) throw Error("has too many parameters for a process of its own");
  return (lane_bytes - fixed) / std::max<std::size_t>(each, 1);
}

PackedOutputs pack(const BatchCall& call, std::size_t first, std::size_t count, std::byte* lane) {
  auto& shared = *reinterpret_cast<LaneCall*>(lane);
  auto* param_columns = reinterpret_cast<Column*>(lane + sizeof(LaneCall));
  shared.what = call.what;
  shared.stroke = call.stroke;
  shared.count = static_cast<std::uint32_t>(count);
  shared.context = call.context;
  const burin_params* params = call.batch.params;
  shared.param_count = params ? params->count : 0;
  Packer packer(lane, bytes_before_columns(call), first, count);
  for (std::size_t i = 0; i < shared.param_count; ++i) {
    *param_columns++ = packer.add(params->values[i].number);
    for (const burin_floats& channel : params->values[i].colour) *param_columns++ = packer.add(channel);
  }
  const auto inputs = inputs_of(call.batch);
  for (std::size_t i = 0; i < batch_arrays; ++i) shared.inputs[i] = packer.add(inputs[i]);
  PackedOutputs packed{};
  const auto outputs = outputs_of(call.outputs);
  for (std::size_t i = 0; i < output_arrays; ++i) packed.outputs[i] = packer.add(read_of(outputs[i]));
  shared.height = packer.add(call.height);
  packed.distance = packer.add(read_of(call.distance));
  shared.outputs = packed.outputs;
  shared.distance = packed.distance;
  return packed;
}

namespace {

void take(const Column& column, const std::byte* lane, const burin_floats_out& to, std::size_t first,
          std::size_t count) {
  if (!to.data) return;
  const std::byte* from = lane + column.offset;
  if (to.stride == 1) {
    std::memcpy(to.data + first, from, count * sizeof(float));
    return;
  }
  for (std::size_t i = 0; i < count; ++i)
    std::memcpy(to.data + (first + i) * to.stride, from + i * sizeof(float), sizeof(float));
}

}  // namespace

void unpack(const PackedOutputs& packed, const std::byte* lane, const BatchCall& call, std::size_t first,
            std::size_t count) {
  const auto outputs = outputs_of(call.outputs);
  for (std::size_t i = 0; i < output_arrays; ++i) take(packed.outputs[i], lane, outputs[i], first, count);
  take(packed.distance, lane, call.distance, first, count);
}

}  // namespace burin::isolate
