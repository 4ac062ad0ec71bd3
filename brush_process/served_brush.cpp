// Calls the functions of the brush with what the host sent.
#include "served_brush.h"

#include <burin/base/error.h>
#include <burin/deform/evaluate/error_text.h>
#include <burin/host/session/carry_state.h>
#include <burin/plugin/detail/error.h>

#include <algorithm>
#include <cstring>
#include <utility>

namespace burin::process {
namespace {

using isolate::Column;
using isolate::LaneCall;
using isolate::MessageReader;
using isolate::MessageWriter;
using isolate::Request;

/// An ability of the brush if all its functions up to `last` are there.
template <class Table, class Member>
const Table* ability(const burin_brush& brush, const char* id, Member Table::*last) {
  const auto* table = static_cast<const Table*>(brush.get_extension(&brush, id));
  if (!table) return nullptr;
  const auto end = reinterpret_cast<const std::byte*>(&(table->*last)) + sizeof(Member) -
                   reinterpret_cast<const std::byte*>(table);
  return table->struct_size >= static_cast<std::size_t>(end) && table->*last ? table : nullptr;
}

const burin_brush* create(const PluginModule& module, const std::string& id, const burin_host& host) {
  ErrorText error;
  const burin_brush* brush = module.create(&host, id.c_str(), error.abi());
  if (!brush) throw Error(error.line(BURIN_ERROR));
  if (!is_whole(*brush)) throw Error("its brush is incomplete");
  return brush;
}

Reply reply_of(burin_status status, const ErrorText& error) {
  return {status, status == BURIN_OK ? std::string() : error.line(status), {}};
}

/// Where the array of a column is. The lane's columns are those that the host laid out.
template <class Array>
Array array_at(std::byte* lane, const Column& column) {
  if (column.kind == Column::none) return {};
  Array array{};
  array.data = reinterpret_cast<decltype(array.data)>(lane + column.offset);
  array.stride = column.kind == Column::each ? 1 : 0;
  return array;
}

template <class Array, std::size_t count>
std::array<Array, count> arrays_at(std::byte* lane, const std::array<Column, count>& columns) {
  std::array<Array, count> arrays{};
  for (std::size_t i = 0; i < count; ++i) arrays[i] = array_at<Array>(lane, columns[i]);
  return arrays;
}

burin_batch batch_of(std::byte* lane, const LaneCall& call) {
  burin_batch batch{};
  batch.struct_size = sizeof batch;
  batch.count = call.count;
  const auto arrays = arrays_at<burin_floats>(lane, call.inputs);
  std::memcpy(reinterpret_cast<std::byte*>(&batch) + offsetof(burin_batch, t), &arrays, sizeof arrays);
  return batch;
}

burin_outputs outputs_of(std::byte* lane, const LaneCall& call) {
  burin_outputs outputs{};
  outputs.struct_size = sizeof outputs;
  outputs.count = call.count;
  const auto arrays = arrays_at<burin_floats_out>(lane, call.outputs);
  std::memcpy(reinterpret_cast<std::byte*>(&outputs) + offsetof(burin_outputs, along), &arrays,
              sizeof arrays);
  return outputs;
}

/// The values of a stroke's parameters with the numbers of a batch.
std::vector<burin_param_value> values_of(std::byte* lane, const LaneCall& call, const burin_params& params) {
  std::vector<burin_param_value> values(params.values, params.values + params.count);
  const auto* column = reinterpret_cast<const Column*>(lane + sizeof(LaneCall));
  for (std::size_t i = 0; i < std::min<std::size_t>(values.size(), call.param_count); ++i) {
    values[i].number = array_at<burin_floats>(lane, *column++);
    for (burin_floats& channel : values[i].colour) channel = array_at<burin_floats>(lane, *column++);
  }
  return values;
}

}  // namespace

ServedBrush::ServedBrush(const std::filesystem::path& module, const std::string& id, const burin_host& host)
    : module_(module, module), brush_(create(module_, id, host)) {
  state_ = state_of(*brush_);
  filter_ = ability(*brush_, BURIN_EXT_CURVE_FILTER, &burin_curve_filter::filter);
  volume_ = ability(*brush_, BURIN_EXT_VOLUME, &burin_volume::distance);
}

ServedBrush::~ServedBrush() {
  const Call ordered(calls_);
  for (auto& [number, stroke] : strokes_) brush_->end(brush_, stroke.handle);
  brush_->destroy(brush_);
}

MessageWriter ServedBrush::offer() const {
  const std::uint32_t offers = (state_ ? isolate::offers_state : 0U) |
                               (filter_ ? isolate::offers_curve_filter : 0U) |
                               (volume_ ? isolate::offers_volume : 0U);
  MessageWriter content;
  content.value(offers).value(state_ ? state_->version : std::uint32_t{0});
  return content;
}

ServedBrush::Stroke& ServedBrush::stroke(std::uint32_t number) {
  const std::lock_guard lock(mutex_);
  const auto found = strokes_.find(number);
  if (found == strokes_.end()) throw Error("no such stroke is open");
  return found->second;
}

Reply ServedBrush::answer(Request what, MessageReader from) {
  const Call ordered(calls_);
  switch (what) {
    case Request::begin:
      return begin(from);
    case Request::end:
      return end(from);
    case Request::curve_reach:
      return reach(from);
    case Request::curve_filter:
      return filter(from);
    case Request::solid_plan:
      return plan(from);
    case Request::save_state:
      return save();
    case Request::load_state:
      return load(from);
    default:
      throw Error("unknown request");
  }
}

Reply ServedBrush::begin(MessageReader& from) {
  // Paths of files may be relative to the host's folder.
  std::error_code error_code;
  std::filesystem::current_path(from.text(), error_code);
  const auto number = from.value<std::uint32_t>();
  const auto context = from.value<burin_stroke_context>();
  Stroke* stroke = nullptr;
  {
    const std::lock_guard lock(mutex_);
    stroke = &strokes_.try_emplace(number, from).first->second;
  }
  auto plan = from.value<burin_stroke_plan>();
  ErrorText error;
  const burin_status status =
      brush_->begin(brush_, &context, &stroke->params.abi(), &plan, &stroke->handle, error.abi());
  Reply reply = reply_of(status, error);
  reply.content.value(plan);
  if (status == BURIN_OK) return reply;
  const std::lock_guard lock(mutex_);
  strokes_.erase(number);
  return reply;
}

Reply ServedBrush::end(MessageReader& from) {
  const auto number = from.value<std::uint32_t>();
  brush_->end(brush_, stroke(number).handle);
  {
    const std::lock_guard lock(mutex_);
    strokes_.erase(number);
    if (!state_ || !strokes_.empty()) return {};
  }
  // What it learnt in the stroke survives the process.
  Reply reply = save();
  return reply.status == BURIN_OK ? reply : Reply{};
}

Reply ServedBrush::reach(MessageReader& from) {
  Stroke& at = stroke(from.value<std::uint32_t>());
  auto reach = from.value<burin_curve_reach>();
  filter_->reach(brush_, at.handle, &reach);
  Reply reply;
  reply.content.value(reach);
  return reply;
}

Reply ServedBrush::filter(MessageReader& from) {
  Stroke& at = stroke(from.value<std::uint32_t>());
  const auto context = from.value<burin_stroke_context>();
  const isolate::ReceivedPoints points(from);
  std::vector<float> along(points.abi().count), across(points.abi().count);
  ErrorText error;
  const burin_status status = filter_->filter(brush_, at.handle, &context, &at.params.abi(), &points.abi(),
                                              {along.data(), 1, 0}, {across.data(), 1, 0}, error.abi());
  Reply reply = reply_of(status, error);
  reply.content.block(std::as_bytes(std::span(along))).block(std::as_bytes(std::span(across)));
  return reply;
}

Reply ServedBrush::plan(MessageReader& from) {
  Stroke& at = stroke(from.value<std::uint32_t>());
  const auto context = from.value<burin_stroke_context>();
  auto plan = from.value<burin_solid_plan>();
  ErrorText error;
  const burin_status status =
      volume_->plan(brush_, at.handle, &context, &at.params.abi(), &plan, error.abi());
  Reply reply = reply_of(status, error);
  reply.content.value(plan);
  return reply;
}

Reply ServedBrush::save() {
  SavedState saved = save_state(*brush_, *state_);
  Reply reply{saved.status, std::move(saved.problem), {}};
  if (reply.status != BURIN_OK) reply.text = "its state cannot be saved: " + reply.text;
  if (reply.status != BURIN_OK || (state_told_ && saved.bytes == told_state_)) return reply;
  reply.content.value(state_->version).block(saved.bytes);
  told_state_ = std::move(saved.bytes);
  state_told_ = true;
  return reply;
}

Reply ServedBrush::load(MessageReader& from) {
  const auto version = from.value<std::uint32_t>();
  const std::span<const std::byte> state = from.block();
  ErrorText error;
  state_told_ = false;
  return reply_of(state_->load(brush_, version, state.data(), state.size(), error.abi()), error);
}

void ServedBrush::answer(std::byte* lane) {
  const Call ordered(calls_);
  auto& call = *reinterpret_cast<LaneCall*>(lane);
  burin_text text{sizeof(burin_text), sizeof call.text, call.text};
  call.text[0] = '\0';
  burin_status status = BURIN_ERROR;
  const burin_status own = plugin::guarded(&text, [&] {
    Stroke& at = stroke(call.stroke);
    const std::vector<burin_param_value> values = values_of(lane, call, at.params.abi());
    const burin_params params{sizeof params, static_cast<std::uint32_t>(values.size()), values.data()};
    burin_batch batch = batch_of(lane, call);
    batch.params = &params;
    if (call.what == isolate::Batch::distance) {
      status = volume_->distance(brush_, at.handle, &call.context, &batch,
                                 array_at<burin_floats>(lane, call.height),
                                 array_at<burin_floats_out>(lane, call.distance), &text);
    } else {
      const burin_outputs outputs = outputs_of(lane, call);
      status = brush_->evaluate(brush_, at.handle, &call.context, &batch, &outputs, &text);
    }
  });
  call.status = own == BURIN_OK ? status : own;
}

}  // namespace burin::process
