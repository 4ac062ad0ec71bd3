#pragma once
#include <atomic>
#include <cstddef>
#include <cstdint>

namespace burin_probe {

/// The rules for hosts that the probe watches: a name, and the sentence of the ABI that states it.
#define BURIN_PROBE_RULES(RULE)                                                                              \
  RULE(init_path, "init.path", "plugin.h: plugin_path is the file of the module, UTF-8")                     \
  RULE(init_paired, "init.paired", "plugin.h: each init that returned BURIN_OK is paired with one deinit")   \
  RULE(factory_when, "factory.when", "plugin.h: get_factory is called between init and deinit")              \
  RULE(main_thread, "main.thread",                                                                           \
       "base.h: [main-thread] is the one thread on which the host loads plugins")                            \
  RULE(create_factory, "create.factory", "plugin.h: create gets the factory that get_factory returned")      \
  RULE(host_complete, "host.complete", "host.h: every member of burin_host is filled")                       \
  RULE(host_unknown, "host.unknown", "host.h: get_extension returns null when the host has no such service") \
  RULE(host_services, "host.services", "host.h: all functions of a returned service work")                   \
  RULE(host_lives, "host.lives", "host.h: the host lives until after the brush is destroyed")                \
  RULE(text_buffer, "text.buffer", "base.h: a text has its capacity in bytes at data")                       \
  RULE(brush_alive, "brush.alive", "brush.h: a brush lives from create to destroy")                          \
  RULE(brush_destroyed, "brush.destroyed", "plugin.h: every brush is destroyed before the last deinit")      \
  RULE(destroy_strokes, "destroy.strokes", "brush.h: destroy is called with no stroke open")                 \
  RULE(extension_id, "extension.id", "brush.h: get_extension is asked for an id")                            \
  RULE(begin_context, "begin.context", "brush.h: the context of begin is that of an empty stroke")           \
  RULE(begin_plan, "begin.plan", "brush.h: the host sets struct_size and the defaults of the plan")          \
  RULE(begin_numbers, "begin.numbers", "brush.h: numbers in begin's params have stride 0")                   \
  RULE(param_count, "param.count", "param.h: params has the values of all parameters")                       \
  RULE(param_range, "param.range", "param.h: numbers are finite, within the hard range and of their type")   \
  RULE(param_text, "param.text", "param.h: texts and paths are UTF-8, never null")                           \
  RULE(param_curve, "param.curve", "param.h: the x of knots increase, and there is at least one")            \
  RULE(param_constant, "param.constant", "param.h: what is not dynamic is constant during a stroke")         \
  RULE(stroke_open, "stroke.open", "brush.h: evaluate and end get a stroke that begin returned, until end")  \
  RULE(stroke_thread, "stroke.thread", "base.h: [stroke-thread] is the one thread that owns a stroke")       \
  RULE(stroke_running, "stroke.running", "brush.h: end comes after the last evaluate")                       \
  RULE(context_pass, "context.pass", "stroke.h: pass is 0 .. passes - 1")                                    \
  RULE(context_constant, "context.constant",                                                                 \
       "stroke.h: seed, pen_present, object_scale and the bounds of the radius stay as in begin")            \
  RULE(context_flags, "context.flags", "stroke.h: CLOSED and DAB come with FINAL, never with each other")    \
  RULE(context_length, "context.length", "stroke.h: length is an arc length, 0 for a dab")                   \
  RULE(context_dab, "context.dab", "stroke.h: dab_t is the arc length of a dab, else 0")                     \
  RULE(batch_size, "batch.size", "stroke.h: count is at least 1 and that of the outputs")                    \
  RULE(batch_declared, "batch.declared", "stroke.h: a batch fills what inputs_read declares")                \
  RULE(batch_undeclared, "batch.undeclared", "stroke.h: an array is null if the brush did not declare it")   \
  RULE(batch_finite, "batch.finite", "stroke.h: inputs are finite")                                          \
  RULE(batch_radius, "batch.radius", "stroke.h: radius is above 0 and within the context's bounds")          \
  RULE(batch_band, "batch.band", "stroke.h: no node is farther from the stroke than its radius")             \
  RULE(batch_unit, "batch.unit", "stroke.h: normals and e1 are unit vectors")                                \
  RULE(batch_tangent, "batch.tangent", "stroke.h: e1 is tangent to the base surface")                        \
  RULE(batch_ranges, "batch.ranges", "stroke.h: mask, colour and pen inputs lie in their ranges")            \
  RULE(batch_neutral, "batch.neutral", "stroke.h: what the pen does not report has its neutral value")       \
  RULE(batch_sheets, "batch.sheets", "stroke.h: sheets count from 0 to below visit_count, at least 1")       \
  RULE(batch_passes, "batch.passes", "stroke.h: displacement is what the previous pass wrote")               \
  RULE(outputs_declared, "outputs.declared",                                                                 \
       "stroke.h: declared outputs have data and a stride, others none")                                     \
  RULE(outputs_filled, "outputs.filled",                                                                     \
       "stroke.h: displacement is filled with zero, colour and mask with "                                   \
       "those before the stroke, anew in every pass")                                                        \
  RULE(solid_plan, "solid.plan", "volume.h: plan is for a finished stroke and gets zeros")                   \
  RULE(solid_points, "solid.points", "volume.h: every point has a height, and room for its distance")        \
  RULE(curve_reach, "curve.reach", "curve_filter.h: reach gets zeros")                                       \
  RULE(curve_points, "curve.points", "curve_filter.h: points are in the order of t")                         \
  RULE(curve_offsets, "curve.offsets", "curve_filter.h: the host fills the offsets with zero")               \
  RULE(state_when, "state.when", "state.h: save and load are called with no stroke open")                    \
  RULE(state_data, "state.data", "state.h: data has its size in bytes")

enum class Rule : unsigned {
#define BURIN_PROBE_ENUMERATOR(name, id, clause) name,
  BURIN_PROBE_RULES(BURIN_PROBE_ENUMERATOR)
#undef BURIN_PROBE_ENUMERATOR
};

#define BURIN_PROBE_COUNT(name, id, clause) +1
inline constexpr std::size_t rule_count = BURIN_PROBE_RULES(BURIN_PROBE_COUNT);
#undef BURIN_PROBE_COUNT

/// What was seen of a rule. Written in evaluate too, so without locks or memory of its own.
struct Seen {
  std::atomic<std::uint64_t> kept{0}, broken{0};
  const char* first_what = nullptr;  ///< what broke the rule first, and its value
  double first_value = 0;
  unsigned first_thread = 0;
};

struct RuleText {
  const char* id;
  const char* clause;
};

/// [Rule]
const RuleText* rule_texts();
Seen* rules_seen();

/// Notes that a rule was kept or broken by `what`, a text that stays, which had this value. Returns `kept`.
bool expect(Rule rule, bool kept, const char* what, double value = 0);

/// The number of the calling thread, from 1 in the order of their first calls.
unsigned thread_number();
unsigned thread_count();

}  // namespace burin_probe
