// Implements the probe's brushes, which check what they get, and draw a round ridge.
#include "brush.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "abilities.h"
#include "calls.h"
#include "checks/arrays.h"
#include "checks/check_batch.h"
#include "checks/check_host.h"
#include "checks/check_values.h"
#include "descriptors.h"
#include "rules.h"
#include "strokes.h"

namespace burin_probe {
namespace {

bool check_first_context(const burin_stroke_context* context) {
  const bool whole = context && BURIN_HAS(context, burin_stroke_context, object_scale);
  if (!expect(Rule::begin_context, whole, "struct_size", context ? context->struct_size : 0)) return false;
  expect(Rule::begin_context, context->length == 0, "length", context->length);
  expect(Rule::begin_context, context->pass == 0, "pass", context->pass);
  expect(Rule::begin_context, context->radius_min > 0 && context->radius_min <= context->radius_max,
         "radius_min", context->radius_min);
  expect(Rule::begin_context, std::isfinite(context->radius_max), "radius_max", context->radius_max);
  expect(Rule::begin_context, std::isfinite(context->object_scale) && context->object_scale > 0,
         "object_scale", context->object_scale);
  return true;
}

bool check_plan(const burin_stroke_plan* plan, void** stroke) {
  const bool whole = plan && BURIN_HAS(plan, burin_stroke_plan, end_influence) && stroke;
  if (!expect(Rule::begin_plan, whole, "struct_size", plan ? plan->struct_size : 0)) return false;
  expect(Rule::begin_plan, plan->passes == 1, "passes", plan->passes);
  expect(Rule::begin_plan, plan->end_influence == 0, "end_influence", plan->end_influence);
  return true;
}

/// Whether parameters can be read; what check_params() tells.
bool readable(const burin_params* params) { return params && params->values && params->count == param_count; }

burin_status BURIN_CALL begin(const burin_brush* abi, const burin_stroke_context* context,
                              const burin_params* params, burin_stroke_plan* plan, void** handle,
                              burin_text* error) {
  const Brush* brush = check_alive(abi);
  check_text(error);
  check_params(params, 1);
  const bool context_whole = check_first_context(context), plan_whole = check_plan(plan, handle);
  if (!brush || !context_whole || !plan_whole || !readable(params)) return BURIN_INVALID_ARGUMENT;
  check_single(params);
  Stroke* stroke = open_stroke(*abi, *handle);
  if (!stroke) return BURIN_OUT_OF_MEMORY;
  const float wanted = params->values[passes].number.data ? params->values[passes].number.data[0] : 1;
  plan->passes = wanted >= 1 && wanted <= 4 ? static_cast<std::uint32_t>(wanted) : 1;
  plan->end_influence = context->radius_max;
  stroke->thread = thread_number();
  // That of an older host is shorter.
  stroke->context = {};
  std::memcpy(&stroke->context, context, std::min<std::size_t>(context->struct_size, sizeof stroke->context));
  stroke->plan = *plan;
  keep_numbers(*stroke, *params);
  note_call(Call::begin, stroke->number);
  return BURIN_OK;
}

/// Draws the ridge; masks and paints it.
void draw(const Brush& brush, const Stroke& stroke, const burin_stroke_context& context,
          const burin_batch& batch, const burin_outputs& outputs) {
  for (std::uint32_t i = 0; i < batch.count; ++i) {
    const float up = displacement(context, batch, i, context.pass, stroke.plan.passes);
    at(outputs.up, i) = up;
    if (brush.descriptor != &everything) continue;
    const float share = std::fmin(1.0f, up / at(batch.radius, i));
    at(outputs.mask, i) = at(batch.mask, i) * (1 - share);
    at(outputs.colour[0], i) = share;
    at(outputs.colour[3], i) = share;
  }
}

bool check_sizes(const burin_batch* batch, const burin_outputs* outputs) {
  const bool whole = batch && outputs && BURIN_HAS(batch, burin_batch, fine_mean_curvature) &&
                     BURIN_HAS(outputs, burin_outputs, colour) && batch->count > 0 && batch->params;
  return expect(Rule::batch_size, whole && outputs->count == batch->count, "count", batch ? batch->count : 0);
}

/// The batch of a host of any version, without the arrays that an older one does not know.
burin_batch whole_batch(const burin_batch& batch) {
  burin_batch whole{};
  std::memcpy(&whole, &batch, std::min<std::size_t>(batch.struct_size, sizeof whole));
  return whole;
}

burin_status evaluate_open(const Brush& brush, Stroke& stroke, const burin_stroke_context& context,
                           const burin_batch& batch, const burin_outputs& outputs) {
  check_context(stroke, context);
  check_params(batch.params, batch.count);
  if (!readable(batch.params)) return BURIN_INVALID_ARGUMENT;
  check_constant(stroke, *batch.params, batch.count);
  const bool inputs_there = check_batch(context, batch, brush.descriptor->inputs_read);
  if (!inputs_there || !check_outputs(batch, outputs, brush.descriptor->outputs_written) ||
      !batch.params->values[height].number.data)
    return BURIN_INVALID_ARGUMENT;
  if (brush.descriptor == &everything && context.pass < stroke.plan.passes)
    check_passes(context, batch, stroke.plan.passes);
  draw(brush, stroke, context, batch, outputs);
  return BURIN_OK;
}

burin_status BURIN_CALL evaluate(const burin_brush* abi, void* handle, const burin_stroke_context* context,
                                 const burin_batch* batch, const burin_outputs* outputs, burin_text* error) {
  const Brush* brush = check_alive(abi);
  check_text(error);
  Stroke* stroke = brush ? find_stroke(*abi, handle) : nullptr;
  expect(Rule::stroke_open, stroke, "evaluate");
  if (!stroke || !context || !check_sizes(batch, outputs)) return BURIN_INVALID_ARGUMENT;
  note_running(++stroke->running);
  note_call(Call::evaluate, stroke->number, batch->count);
  ++stroke->evaluated;
  if (context->flags & BURIN_STROKE_FINAL) stroke->final_seen = true;
  const burin_status status = evaluate_open(*brush, *stroke, *context, whole_batch(*batch), *outputs);
  --stroke->running;
  return status;
}

void BURIN_CALL end(const burin_brush* abi, void* handle) {
  Stroke* stroke = check_alive(abi) ? find_stroke(*abi, handle) : nullptr;
  if (!expect(Rule::stroke_open, stroke, "end")) return;
  note_call(Call::end, stroke->number);
  expect(Rule::stroke_thread, stroke->thread == thread_number(), "begin was on thread", stroke->thread);
  expect(Rule::stroke_running, stroke->running == 0, "evaluate calls", stroke->running);
  close_stroke(*stroke);
}

const void* BURIN_CALL get_extension(const burin_brush* abi, const char* id) {
  const Brush* brush = check_alive(abi);
  if (!expect(Rule::extension_id, id, "id") || !brush) return nullptr;
  note_call(Call::get_extension, brush->number);
  return ability(*brush->descriptor, id);
}

void BURIN_CALL destroy(const burin_brush* abi) {
  Brush* brush = check_alive(abi);
  if (!brush) return;
  check_main_thread();
  note_call(Call::destroy, brush->number);
  const int open = open_strokes(*abi);
  expect(Rule::destroy_strokes, open == 0, "open strokes", open);
  if (brush->host) check_host_lives(brush->host, brush->host_then);
  brush->number = 0;
}

}  // namespace

Brush* check_alive(const burin_brush* abi) {
  Brush* brush = find_brush(abi);
  expect(Rule::brush_alive, brush, "brush");
  return brush;
}

void fill(Brush& brush) {
  brush.abi = {sizeof(burin_brush), 0, &brush, destroy, get_extension, begin, evaluate, end};
}

}  // namespace burin_probe
