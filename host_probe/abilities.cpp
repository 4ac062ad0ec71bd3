// Serves the optional interfaces of the probe: a state, and for the probe of solids a solid and a moved
// curve.
#include "abilities.h"

#include <burin/abi/ext/curve_filter.h>
#include <burin/abi/ext/state.h>
#include <burin/abi/ext/volume.h>

#include <cmath>
#include <cstring>

#include "brush.h"
#include "calls.h"
#include "checks/arrays.h"
#include "checks/check_batch.h"
#include "checks/check_values.h"
#include "descriptors.h"
#include "error_text.h"
#include "rules.h"
#include "strokes.h"

namespace burin_probe {
namespace {

/// The open stroke that an ability is called for, or null.
Stroke* check_open(const burin_brush* brush, const void* handle, const char* what) {
  Stroke* stroke = check_alive(brush) ? find_stroke(*brush, handle) : nullptr;
  expect(Rule::stroke_open, stroke, what);
  return stroke;
}

burin_status BURIN_CALL plan_solid(const burin_brush* brush, void* handle,
                                   const burin_stroke_context* context, const burin_params* params,
                                   burin_solid_plan* plan, burin_text* error) {
  const Stroke* stroke = check_open(brush, handle, "solid plan");
  check_text(error);
  check_params(params, 1);
  if (!stroke || !context || !plan) return BURIN_INVALID_ARGUMENT;
  note_call(Call::plan_solid, stroke->number);
  check_single(params);
  expect(Rule::solid_plan, context->flags & BURIN_STROKE_FINAL, "flags", static_cast<double>(context->flags));
  expect(Rule::solid_plan, plan->operation == 0 && plan->h_min == 0 && plan->h_max == 0 && plan->detail == 0,
         "h_max", plan->h_max);
  plan->h_min = -0.1 * context->radius_max;
  plan->h_max = 0.5 * context->radius_max;
  plan->detail = 0.3 * context->radius_max;
  return BURIN_OK;
}

/// A slab whose faces lie at 0 and 0.4 radii and whose edges are half a radius to either side.
float distance_to_slab(float d, float h, float radius) {
  return std::fmax(std::fabs(h - 0.2f * radius) - 0.2f * radius, std::fabs(d) - 0.5f * radius);
}

burin_status BURIN_CALL distance(const burin_brush* brush, void* handle, const burin_stroke_context* context,
                                 const burin_batch* batch, burin_floats h, burin_floats_out out,
                                 burin_text* error) {
  const Stroke* stroke = check_open(brush, handle, "solid distance");
  check_text(error);
  if (!stroke || !context || !batch) return BURIN_INVALID_ARGUMENT;
  note_call(Call::distance, stroke->number, batch->count);
  if (!expect(Rule::solid_points, h.data && out.data && out.stride > 0, "stride", out.stride) ||
      !check_arrays(*batch, solid.inputs_read))
    return BURIN_INVALID_ARGUMENT;
  for (std::uint32_t i = 0; i < batch->count; ++i) {
    expect(Rule::solid_points, std::isfinite(at(h, i)), "h", static_cast<double>(at(h, i)));
    at(out, i) = distance_to_slab(at(batch->d, i), at(h, i), at(batch->radius, i));
  }
  return BURIN_OK;
}

void BURIN_CALL reach(const burin_brush* brush, void* handle, burin_curve_reach* reach) {
  const Stroke* stroke = check_open(brush, handle, "curve reach");
  if (!stroke) return;
  note_call(Call::reach, stroke->number);
  expect(Rule::curve_reach, reach && reach->behind == 0 && reach->ahead == 0, "ahead",
         reach ? reach->ahead : 0);
}

void check_points(const burin_curve_points& points, const burin_floats_out& along,
                  const burin_floats_out& across) {
  for (std::uint32_t i = 0; i < points.count; ++i) {
    expect(Rule::curve_points, i == 0 || at(points.t, i) >= at(points.t, i - 1), "t",
           static_cast<double>(at(points.t, i)));
    expect(Rule::curve_offsets, at(along, i) == 0 && at(across, i) == 0, "across",
           static_cast<double>(at(across, i)));
  }
}

burin_status BURIN_CALL filter(const burin_brush* brush, void* handle, const burin_stroke_context* context,
                               const burin_params* params, const burin_curve_points* points,
                               burin_floats_out along, burin_floats_out across, burin_text* error) {
  const Stroke* stroke = check_open(brush, handle, "curve filter");
  check_text(error);
  check_params(params, 1);
  if (!stroke || !context || !points) return BURIN_INVALID_ARGUMENT;
  note_call(Call::filter, stroke->number, points->count);
  check_single(params);
  const bool there = points->count > 0 && points->t.data && points->position.x.data &&
                     points->normal.x.data && points->e1.x.data && along.data && across.data;
  if (!expect(Rule::curve_points, there, "count", points->count)) return BURIN_INVALID_ARGUMENT;
  check_points(*points, along, across);
  return BURIN_OK;
}

/// Checks that a call about the state comes when no stroke is open.
Brush* check_state_call(const burin_brush* abi, Call call, burin_text* error) {
  Brush* brush = check_alive(abi);
  check_text(error);
  if (!brush) return nullptr;
  check_main_thread();
  note_call(call, brush->number);
  const int open = open_strokes(*abi);
  expect(Rule::state_when, open == 0, "open strokes", open);
  return brush;
}

burin_status BURIN_CALL save(const burin_brush* abi, void* data, std::uint64_t capacity, std::uint64_t* size,
                             burin_text* error) {
  const Brush* brush = check_state_call(abi, Call::save, error);
  if (!expect(Rule::state_data, size && (data || capacity == 0), "capacity", static_cast<double>(capacity)) ||
      !brush)
    return BURIN_INVALID_ARGUMENT;
  const std::uint32_t state = brush->state;
  *size = sizeof state;
  if (capacity < sizeof state) return BURIN_INVALID_ARGUMENT;
  std::memcpy(data, &state, sizeof state);
  return BURIN_OK;
}

burin_status BURIN_CALL load(const burin_brush* abi, std::uint32_t version, const void* data,
                             std::uint64_t size, burin_text* error) {
  Brush* brush = check_state_call(abi, Call::load, error);
  if (version != 1) return say(error, "no such version of the state"), BURIN_UNSUPPORTED;
  if (!expect(Rule::state_data, data || size == 0, "size", static_cast<double>(size)) || !brush)
    return BURIN_INVALID_ARGUMENT;
  std::uint32_t state = 0;
  if (size != sizeof state) return say(error, "the state has another size"), BURIN_ERROR;
  std::memcpy(&state, data, sizeof state);
  brush->state = state;
  return BURIN_OK;
}

constexpr burin_state state_table{sizeof(burin_state), 1, save, load};
constexpr burin_volume volume_table{sizeof(burin_volume), 0, plan_solid, distance};
constexpr burin_curve_filter filter_table{sizeof(burin_curve_filter), 0, reach, filter};

}  // namespace

const void* ability(const burin_brush_descriptor& descriptor, const char* id) {
  if (std::strcmp(id, BURIN_EXT_STATE) == 0) return &state_table;
  if (&descriptor != &solid) return nullptr;
  if (std::strcmp(id, BURIN_EXT_VOLUME) == 0) return &volume_table;
  if (std::strcmp(id, BURIN_EXT_CURVE_FILTER) == 0) return &filter_table;
  return nullptr;
}

}  // namespace burin_probe
