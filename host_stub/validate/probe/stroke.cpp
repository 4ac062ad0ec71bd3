// Calls a brush as a host does, and keeps what it wrote, node by node.
#include "validate/probe/stroke.h"

#include <burin/deform/evaluate/error_text.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace burin::validate {
namespace {

constexpr std::array output_names = {"along", "across", "up", "mask", "r", "g", "b", "a"};
constexpr Row before = {0, 0, 0, 1, 0.5f, 0.5f, 0.5f, 0.5f};

}  // namespace

ProbeBrush::ProbeBrush(const Plugin& plugin, const burin_brush_descriptor& brush, const Subject& subject)
    : descriptor(brush),
      values(brush, subject),
      brush_(plugin.factory().create(&plugin.factory(), host.abi(), brush.id, nullptr)) {
  require(brush_, "cannot be created");
}

ProbeBrush::~ProbeBrush() { brush_->destroy(brush_); }

bool ProbeBrush::begins(burin_text* error) {
  burin_stroke_plan plan{sizeof plan, 1, 0};
  void* stroke = nullptr;
  const burin_stroke_context context = empty_stroke_context();
  const burin_status status = brush_->begin(brush_, &context, &values.abi(), &plan, &stroke, error);
  if (status == BURIN_OK) brush_->end(brush_, stroke);
  require(status != BURIN_STATUS_UNKNOWN, "begin returns no status");
  return status == BURIN_OK;
}

ProbeStroke::ProbeStroke(ProbeBrush& brush, const burin_stroke_context& drawn)
    : context(drawn), brush_(brush), params_(&brush.values.abi()) {
  const std::string error = begin();
  if (error.empty() || (brush.values.choose_solids() && begin().empty())) return;
  if (brush.values.needs_file()) throw Skipped("it needs a file of its user: " + error);
  throw Failed(error);
}

std::string ProbeStroke::begin() {
  ErrorText error;
  burin_stroke_context empty = context;
  empty.length = 0;
  plan = {sizeof plan, 1, 0};
  params_ = &brush_.values.abi();
  const burin_status status =
      brush_.abi().begin(&brush_.abi(), &empty, params_, &plan, &stroke_, error.abi());
  return status == BURIN_OK ? std::string() : "begin fails: " + error.line(status);
}

ProbeStroke::~ProbeStroke() { brush_.abi().end(&brush_.abi(), stroke_); }

burin_status ProbeStroke::call(const burin_batch& batch, const burin_outputs& outputs,
                               burin_text* text) const {
  return brush_.abi().evaluate(&brush_.abi(), stroke_, &context, &batch, &outputs, text);
}

std::vector<Row> ProbeStroke::evaluate(const Nodes& nodes, std::size_t begin, std::size_t end) const {
  ErrorText error;
  std::vector<Row> rows(end - begin);
  const burin_outputs outputs = outputs_of(rows);
  const burin_status status = call(batch_of(nodes, begin, end - begin, *params_), outputs, error.abi());
  require(status == BURIN_OK, fmt::format("evaluate of {} nodes fails: {}", end - begin, error.line(status)));
  return rows;
}

burin_floats& array_of(burin_batch& batch, const InputColumns& input, std::size_t member) {
  return *reinterpret_cast<burin_floats*>(reinterpret_cast<char*>(&batch) + input.offset +
                                          member * sizeof(burin_floats));
}

burin_batch batch_of(const Nodes& nodes, std::size_t begin, std::size_t count, const burin_params& params) {
  burin_batch batch{};
  batch.struct_size = sizeof batch;
  batch.count = static_cast<std::uint32_t>(count);
  batch.params = &params;
  std::size_t column = 0;
  for (const InputColumns& input : input_columns())
    for (std::size_t member = 0; member < input.count; ++member)
      array_of(batch, input, member) = {nodes.columns[column++].data() + begin, 1, 0};
  return batch;
}

std::array<burin_floats_out*, 8> arrays_of(burin_outputs& outputs) {
  return {&outputs.along,     &outputs.across,    &outputs.up,        &outputs.mask,
          &outputs.colour[0], &outputs.colour[1], &outputs.colour[2], &outputs.colour[3]};
}

burin_outputs outputs_of(std::vector<Row>& rows) {
  std::fill(rows.begin(), rows.end(), before);
  burin_outputs outputs{};
  outputs.struct_size = sizeof outputs;
  outputs.count = static_cast<std::uint32_t>(rows.size());
  std::size_t k = 0;
  for (burin_floats_out* array : arrays_of(outputs)) *array = {rows[0].data() + k++, 8, 0};
  return outputs;
}

const char* output_name(std::size_t array) { return output_names[array]; }

bool writes(const burin_brush_descriptor& brush, std::size_t array) {
  const std::uint64_t bit = array < 3    ? BURIN_OUTPUT_DISPLACEMENT
                            : array == 3 ? BURIN_OUTPUT_MASK
                                         : BURIN_OUTPUT_COLOUR;
  return brush.outputs_written & bit;
}

std::string difference(const std::vector<Row>& a, const std::vector<Row>& b, const Nodes& nodes) {
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t k = 0; k < a[i].size(); ++k)
      if (std::memcmp(&a[i][k], &b[i][k], sizeof(float)) != 0)
        return fmt::format("at t {} and d {} '{}' is {} and {}", nodes.t(i), nodes.d(i), output_names[k],
                           a[i][k], b[i][k]);
  return {};
}

std::string bits_of(const std::vector<Row>& rows) {
  return {reinterpret_cast<const char*>(rows.data()), rows.size() * sizeof(Row)};
}

void require_finite(const std::vector<Row>& rows, const Nodes& nodes) {
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t k = 0; k < rows[i].size(); ++k)
      require(std::isfinite(rows[i][k]), fmt::format("writes {} to '{}' at t {} and d {}", rows[i][k],
                                                     output_names[k], nodes.t(i), nodes.d(i)));
}

float distance(const std::vector<Row>& a, const std::vector<Row>& b) {
  float most = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t k = 0; k < a[i].size(); ++k) most = std::max(most, std::abs(a[i][k] - b[i][k]));
  return most;
}

}  // namespace burin::validate
