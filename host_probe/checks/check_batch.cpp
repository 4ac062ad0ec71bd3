// Checks what evaluate gets against what stroke.h promises.
#include "check_batch.h"

#include <algorithm>
#include <cmath>

#include "../descriptors.h"
#include "../rules.h"
#include "arrays.h"

namespace burin_probe {
namespace {

/// Rounding that lengths of single precision may have.
constexpr float slack = 1e-4f;

bool in_unit_interval(float value) { return value >= 0 && value <= 1; }

/// Whether all declared arrays are there.
bool check_presence(const burin_batch& batch, std::uint64_t inputs) {
  bool all = true;
  for (const Array& array : arrays_of(batch)) {
    if (inputs & array.input)
      all = expect(Rule::batch_declared, array.data, array.name) && all;
    else
      expect(Rule::batch_undeclared, !array.data, array.name);
  }
  return all;
}

void check_finite(const burin_batch& batch, std::uint64_t inputs) {
  for (const Array& array : arrays_of(batch)) {
    const bool read = !array.whole && (inputs & array.input);
    const auto* floats = static_cast<const float*>(read ? array.data : nullptr);
    for (std::uint32_t i = 0; floats && i < batch.count; ++i)
      if (const float value = floats[std::size_t{i} * array.stride]; !std::isfinite(value)) {
        expect(Rule::batch_finite, false, array.name, static_cast<double>(value));
        return;
      }
  }
  expect(Rule::batch_finite, true, "all");
}

void check_radius(const burin_stroke_context& context, float radius) {
  const double margin = static_cast<double>(slack) * context.radius_max;
  const auto wide = static_cast<double>(radius);
  expect(Rule::batch_radius,
         radius > 0 && wide >= context.radius_min - margin && wide <= context.radius_max + margin, "radius",
         wide);
}

/// The distance of a node to the stroke: in round caps that to the end.
float distance(const burin_stroke_context& context, float t, float d) {
  if (context.flags & BURIN_STROKE_CLOSED) return std::fabs(d);
  if (t < 0) return std::hypot(t, d);
  const auto past = static_cast<float>(static_cast<double>(t) - context.length);
  return past > 0 ? std::hypot(past, d) : std::fabs(d);
}

void check_unit(const burin_vectors& vectors, std::uint32_t i, const char* name) {
  const float length = std::hypot(at(vectors.x, i), at(vectors.y, i), at(vectors.z, i));
  expect(Rule::batch_unit, std::fabs(length - 1) < 1e-3f, name, static_cast<double>(length));
}

void check_frame(const burin_batch& batch, std::uint32_t i) {
  check_unit(batch.normal, i, "normal");
  check_unit(batch.e1, i, "e1");
  check_unit(batch.fine_normal, i, "fine_normal");
  check_unit(batch.foot_normal, i, "foot_normal");
  const float dot = at(batch.normal.x, i) * at(batch.e1.x, i) + at(batch.normal.y, i) * at(batch.e1.y, i) +
                    at(batch.normal.z, i) * at(batch.e1.z, i);
  expect(Rule::batch_tangent, std::fabs(dot) < 1e-3f, "e1 . normal", static_cast<double>(dot));
}

void check_ranges(const burin_batch& batch, std::uint32_t i) {
  const auto within = [&](bool kept, const char* name, const burin_floats& floats) {
    expect(Rule::batch_ranges, kept, name, static_cast<double>(at(floats, i)));
  };
  within(in_unit_interval(at(batch.mask, i)), "mask", batch.mask);
  for (const burin_floats* channel : {&batch.colour.r, &batch.colour.g, &batch.colour.b, &batch.colour.a})
    within(in_unit_interval(at(*channel, i)), "colour", *channel);
  within(in_unit_interval(at(batch.pressure, i)), "pressure", batch.pressure);
  within(at(batch.twist, i) >= 0 && at(batch.twist, i) < 6.2832f, "twist", batch.twist);
  within(at(batch.speed, i) >= 0, "speed", batch.speed);
  within(at(batch.time, i) >= 0, "time", batch.time);
  within(at(batch.stretch, i) >= 0, "stretch", batch.stretch);
  within(at(batch.footprint_t, i) > 0, "footprint_t", batch.footprint_t);
  within(at(batch.footprint_d, i) > 0, "footprint_d", batch.footprint_d);
}

void check_neutral(const burin_stroke_context& context, const burin_batch& batch, std::uint32_t i) {
  const auto neutral = [&](std::uint64_t input, const burin_floats& floats, float value, const char* name) {
    if (!(context.pen_present & input))
      expect(Rule::batch_neutral, at(floats, i) == value, name, static_cast<double>(at(floats, i)));
  };
  neutral(BURIN_INPUT_PRESSURE, batch.pressure, 1, "pressure");
  neutral(BURIN_INPUT_TILT, batch.tilt_x, 0, "tilt_x");
  neutral(BURIN_INPUT_TILT, batch.tilt_y, 0, "tilt_y");
  neutral(BURIN_INPUT_TWIST, batch.twist, 0, "twist");
  neutral(BURIN_INPUT_SPEED, batch.speed, 0, "speed");
  neutral(BURIN_INPUT_TIME, batch.time, 0, "time");
}

void check_place(const burin_stroke_context& context, const burin_batch& batch, std::uint32_t i) {
  check_radius(context, at(batch.radius, i));
  const float reach = at(batch.radius, i) * (1 + slack),
              far = distance(context, at(batch.t, i), at(batch.d, i));
  expect(Rule::batch_band, far <= reach, "distance", static_cast<double>(far));
}

void check_written(const burin_floats_out& out, bool declared, const char* name) {
  expect(Rule::outputs_declared, declared ? out.data && out.stride > 0 : !out.data, name, out.stride);
}

/// Whether an output has the values of an input, or zeros where there is none.
void check_filled(const burin_floats_out& out, const burin_floats* before, std::uint32_t nodes,
                  const char* name) {
  for (std::uint32_t i = 0; i < nodes; ++i) {
    const float value = at(out, i);
    if (value != (before ? at(*before, i) : 0)) {
      expect(Rule::outputs_filled, false, name, static_cast<double>(value));
      return;
    }
  }
  expect(Rule::outputs_filled, true, name);
}

}  // namespace

void check_context(const Stroke& stroke, const burin_stroke_context& context) {
  const burin_stroke_context& first = stroke.context;
  const bool dab = context.flags & BURIN_STROKE_DAB, closed = context.flags & BURIN_STROKE_CLOSED,
             final = context.flags & BURIN_STROKE_FINAL;
  expect(Rule::context_pass, context.pass < stroke.plan.passes, "pass", context.pass);
  expect(Rule::context_constant,
         context.seed == first.seed && context.pen_present == first.pen_present &&
             context.radius_min == first.radius_min && context.radius_max == first.radius_max &&
             context.object_scale == first.object_scale,
         "radius_max", context.radius_max);
  expect(Rule::context_flags, (final || (!dab && !closed)) && !(dab && closed), "flags",
         static_cast<double>(context.flags));
  expect(Rule::context_length,
         std::isfinite(context.length) && (dab ? context.length == 0 : context.length >= 0), "length",
         context.length);
  if (!BURIN_HAS(&context, burin_stroke_context, dab_t)) return;
  expect(Rule::context_dab, std::isfinite(context.dab_t) && (dab ? context.dab_t >= 0 : context.dab_t == 0),
         "dab_t", context.dab_t);
}

bool check_arrays(const burin_batch& batch, std::uint64_t inputs) {
  if (!check_presence(batch, inputs)) return false;
  check_finite(batch, inputs);
  return true;
}

bool check_batch(const burin_stroke_context& context, const burin_batch& batch, std::uint64_t inputs) {
  if (!check_arrays(batch, inputs)) return false;
  for (std::uint32_t i = 0; i < batch.count; ++i) check_place(context, batch, i);
  for (std::uint32_t i = 0; inputs == everything.inputs_read && i < batch.count; ++i) {
    check_frame(batch, i);
    check_ranges(batch, i);
    check_neutral(context, batch, i);
    expect(Rule::batch_sheets, at(batch.visit_count, i) >= 1 && at(batch.sheet, i) < at(batch.visit_count, i),
           "sheet", at(batch.sheet, i));
  }
  return true;
}

bool check_outputs(const burin_batch& batch, const burin_outputs& outputs, std::uint64_t written) {
  const bool moves = written & BURIN_OUTPUT_DISPLACEMENT, masks = written & BURIN_OUTPUT_MASK,
             paints = written & BURIN_OUTPUT_COLOUR;
  const burin_floats_out displaced[] = {outputs.along, outputs.across, outputs.up};
  for (const burin_floats_out& out : displaced) check_written(out, moves, "displacement");
  check_written(outputs.mask, masks, "mask");
  for (const burin_floats_out& out : outputs.colour) check_written(out, paints, "colour");
  const auto lacks = [](const burin_floats_out& out) { return !out.data; };
  if ((moves && std::any_of(std::begin(displaced), std::end(displaced), lacks)) ||
      (masks && lacks(outputs.mask)) ||
      (paints && std::any_of(std::begin(outputs.colour), std::end(outputs.colour), lacks)))
    return false;
  for (const burin_floats_out& out : displaced)
    if (moves) check_filled(out, nullptr, batch.count, "displacement");
  const burin_floats* before[] = {&batch.colour.r, &batch.colour.g, &batch.colour.b, &batch.colour.a};
  if (masks) check_filled(outputs.mask, &batch.mask, batch.count, "mask");
  for (int i = 0; paints && i < 4; ++i) check_filled(outputs.colour[i], before[i], batch.count, "colour");
  return true;
}

float displacement(const burin_stroke_context& context, const burin_batch& batch, std::uint32_t node,
                   std::uint32_t pass, std::uint32_t passes) {
  const float radius = at(batch.radius, node),
              share = distance(context, at(batch.t, node), at(batch.d, node)) / radius,
              rim = std::max(0.0f, 1 - share * share);
  return at(batch.params->values[height].number, node) * radius * rim * rim * static_cast<float>(pass + 1) /
         static_cast<float>(passes);
}

void check_passes(const burin_stroke_context& context, const burin_batch& batch, std::uint32_t passes) {
  for (std::uint32_t i = 0; i < batch.count; ++i) {
    const float up = context.pass == 0 ? 0 : displacement(context, batch, i, context.pass - 1, passes);
    expect(Rule::batch_passes,
           at(batch.displacement.x, i) == 0 && at(batch.displacement.y, i) == 0 &&
               at(batch.displacement.z, i) == up,
           "displacement.z", static_cast<double>(at(batch.displacement.z, i)));
  }
}

}  // namespace burin_probe
