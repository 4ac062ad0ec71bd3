// Checks that calls leave the process as it was, and that what they were lent is not kept.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cfenv>
#include <clocale>
#include <cstring>
#include <functional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>
#if defined(__SSE__)
#include <xmmintrin.h>
#endif

#include "validate/probe/process_state.h"
#include "validate/probe/repeat.h"
#include "validate/probe/stroke.h"

namespace burin::validate {
namespace {

/// Loads the module, draws a stroke of 1000 nodes with each brush, and calls `look` with the name of each
/// step once it is done: "begin".
void each_step(const Subject& subject, const std::function<void(const char* step)>& look) {
  each_brush(subject, [&](const Plugin& plugin, const burin_brush_descriptor& descriptor) {
    look("loading and init");
    {
      ProbeBrush brush(plugin, descriptor, subject);
      look("create");
      {
        ProbeStroke stroke(brush);
        look("begin");
        stroke.evaluate(random_nodes(1000, subject.seed));
        look("evaluate");
      }
      look("end");
    }
    look("destroy");
  });
}

void check_process_state(const Subject& subject) {
  const ProcessState before = process_state();
  each_step(subject, [&](const char* step) {
    const char* changed = difference(before, process_state());
    require(!changed, fmt::format("{} changes {}", step, changed ? changed : ""));
  });
}

/// How numbers are rounded, and what becomes of denormals.
struct FloatModes {
  int rounding = std::fegetround();
#if defined(__SSE__)
  unsigned control = _mm_getcsr() & ~0x3Fu;
#else
  unsigned control = 0;
#endif
};

void restore(const FloatModes& modes) {
#if defined(__SSE__)
  _mm_setcsr(modes.control);
#endif
  std::fesetround(modes.rounding);
}

void check_float_modes_of_calls(const Subject& subject) {
  const FloatModes before;
  each_step(subject, [&](const char* step) {
    const FloatModes now;
    restore(before);
    require(now.rounding == before.rounding, fmt::format("{} changes the rounding mode", step));
    require(
        now.control == before.control,
        fmt::format("{} changes whether denormals are flushed, as -ffast-math and -Ofast do where a module "
                    "is linked",
                    step));
  });
}

void check_locale_of_calls(const Subject& subject) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  each_step(subject, [&](const char* step) {
    require(std::setlocale(LC_ALL, nullptr) == before, fmt::format("{} changes the locale", step));
  });
}

/// What a plugin is lent for the time of a call.
enum class Lent { nothing, plugin_path, brush_id, context, params, plan };
constexpr std::array<std::pair<Lent, const char*>, 5> all_lent = {{{Lent::plugin_path, "plugin_path of init"},
                                                                   {Lent::brush_id, "brush_id of create"},
                                                                   {Lent::context, "context of begin"},
                                                                   {Lent::params, "params of begin"},
                                                                   {Lent::plan, "plan of begin"}}};

/// A copy of values, whose memory can be made useless.
class LentParams {
 public:
  LentParams(const burin_params& from, const burin_brush_descriptor& brush)
      : values_(from.values, from.values + from.count),
        numbers_(from.count),
        knots_(from.count),
        texts_(from.count) {
    for (std::uint32_t i = 0; i < from.count; ++i) copy(i, brush.params[i]->type);
    params_ = {from.struct_size, from.count, values_.data()};
  }
  LentParams(const LentParams&) = delete;
  LentParams& operator=(const LentParams&) = delete;

  const burin_params& abi() const { return params_; }

  void spoil() {
    for (auto& numbers : numbers_) numbers.fill(-7e30f);
    for (auto& knots : knots_) std::ranges::fill(knots, -7e30f);
    for (std::string& text : texts_) std::ranges::fill(text, '#');
    for (auto& value : values_) value = {};
    params_ = {};
  }

 private:
  void copy(std::uint32_t i, burin_param_type type) {
    burin_param_value& value = values_[i];
    if (value.text) value.text = (texts_[i] = value.text).c_str();
    if (value.number.data) value.number.data = &(numbers_[i][0] = *value.number.data);
    for (std::size_t c = 0; type == BURIN_PARAM_COLOUR && c < 4; ++c)
      value.colour[c].data = &(numbers_[i][c] = *value.colour[c].data);
    if (!value.knots) return;
    knots_[i].assign(value.knots, value.knots + 2 * std::size_t{value.knot_count});
    value.knots = knots_[i].data();
  }

  std::vector<burin_param_value> values_;
  std::vector<std::array<float, 4>> numbers_;
  std::vector<std::vector<float>> knots_;
  std::vector<std::string> texts_;
  burin_params params_{};
};

/// Begins a stroke, spoils what was lent, and evaluates. Returns the bits of the result.
std::string drawn_without(ProbeBrush& probe, const burin_brush& brush, Lent gone, std::uint64_t seed) {
  LentParams params(probe.values.abi(), probe.descriptor);
  burin_stroke_context begun = empty_stroke_context();
  const burin_stroke_context context = stroke_context();
  burin_stroke_plan plan{sizeof plan, 1, 0};
  void* stroke = nullptr;
  require(brush.begin(&brush, &begun, &params.abi(), &plan, &stroke, nullptr) == BURIN_OK, "begin fails");
  if (gone == Lent::params) params.spoil();
  if (gone == Lent::context) std::memset(&begun, 0xEE, sizeof begun);
  if (gone == Lent::plan) std::memset(&plan, 0xEE, sizeof plan);
  const Nodes nodes = random_nodes(300, seed);
  std::vector<Row> rows(nodes.size());
  const burin_batch batch = batch_of(nodes, 0, nodes.size(), probe.values.abi());
  const burin_outputs outputs = outputs_of(rows);
  brush.evaluate(&brush, stroke, &context, &batch, &outputs, nullptr);
  brush.end(&brush, stroke);
  return bits_of(rows);
}

/// Draws with a brush of the module in a process of its own, where what was lent is soon useless.
std::string drawn_alone(const Subject& subject, std::size_t number, Lent gone) {
  return in_process([&] {
    std::string path = subject.module.string();
    const Plugin plugin(subject, path.c_str());
    if (gone == Lent::plugin_path) std::ranges::fill(path, '#');
    const burin_brush_descriptor& descriptor = *plugin.brushes()[number];
    ProbeBrush probe(plugin, descriptor, subject);
    { const ProbeStroke first(probe); }  // It finds a file that the brush takes.
    std::string id = descriptor.id;
    const burin_brush* brush =
        plugin.factory().create(&plugin.factory(), probe.host.abi(), id.c_str(), nullptr);
    require(brush, "cannot be created");
    if (gone == Lent::brush_id) std::ranges::fill(id, '#');
    std::string bits = drawn_without(probe, *brush, gone, subject.seed);
    brush->destroy(brush);
    return bits;
  });
}

void require_not_kept(const Subject& subject, std::size_t number) {
  const std::string bits = drawn_alone(subject, number, Lent::nothing);
  if (drawn_alone(subject, number, Lent::nothing) != bits)
    throw Skipped("two processes give different results, see repeat.processes");
  for (const auto& [lent, name] : all_lent) {
    std::string without;
    try {
      without = drawn_alone(subject, number, lent);
    } catch (const Failed&) {
    }
    require(without == bits,
            fmt::format("keeps a pointer into the {}: it crashes or draws otherwise once the host uses that "
                        "memory for something else",
                        name));
  }
}

/// The ids of the module's brushes, asked for in another process, since this one must not load the module.
std::vector<std::string> brush_ids(const Subject& subject) {
  std::istringstream lines(in_process([&] {
    std::string text;
    const Plugin plugin(subject);
    for (const burin_brush_descriptor* brush : plugin.brushes())
      text += fmt::format("{}\n", brush->id ? brush->id : "");
    return text;
  }));
  std::vector<std::string> ids;
  for (std::string line; std::getline(lines, line);) ids.push_back(line);
  return ids;
}

void check_lent(const Subject& subject) {
  std::string reason = "the module has no brushes";
  bool ran = false;
  const std::vector<std::string> ids = brush_ids(subject);
  for (std::size_t number = 0; number < ids.size(); ++number) {
    try {
      tell_where(ids[number] + ": ", [&] { require_not_kept(subject, number); });
      ran = true;
    } catch (const Skipped& skipped) {
      reason = skipped.what();
    }
  }
  if (!ran) throw Skipped(reason);
}

constexpr Check process_list[] = {
    {"process.state", 2,
     "base.h: a call leaves the process as it was: standard streams, signal handlers, working directory, "
     "environment",
     "Compares streams, handlers, folder and environment before and after each call of a stroke.",
     check_process_state},
    {"process.float-modes", 2,
     "base.h: a call leaves rounding mode and the flushing of denormals as they were",
     "Compares both before and after loading and each call of a stroke.", check_float_modes_of_calls},
    {"process.locale", 2, "base.h: a call leaves the locale as it was",
     "Compares the locale before and after each call of a stroke.", check_locale_of_calls},
    {"process.lent", 2,
     "plugin.h: plugin_path and brush_id are valid during the call only; param.h: so are values of "
     "parameters",
     "Draws where what init, create and begin were lent is overwritten after the call.", check_lent},
};

}  // namespace

std::span<const Check> process_checks() { return process_list; }

}  // namespace burin::validate
