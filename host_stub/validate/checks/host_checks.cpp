// Checks how a plugin deals with other hosts: older, newer, with fewer services.
#include <burin/abi/ext/lettering.h>
#include <burin/abi/ext/log.h>
#include <burin/abi/ext/stamps.h>
#include <burin/abi/ext/state.h>
#include <burin/abi/ext/vdb_stamps.h>
#include <burin/abi/ext/volume.h>
#include <burin/host/plugin/descriptor_check.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <functional>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include "validate/probe/straight_curve.h"
#include "validate/probe/stroke.h"

namespace burin::validate {
namespace {

using Brush = burin_brush_descriptor;

void check_unknown_extension(const Subject& subject) {
  each_brush(subject, [&](const Plugin& plugin, const Brush& descriptor) {
    const ProbeBrush brush(plugin, descriptor, subject);
    for (const char* id : {"burin.nothing/1", "", "burin.volume/999"})
      require(!brush.interface<void>(id), fmt::format("returns an interface for '{}'", id));
  });
}

void check_unknown_brush(const Subject& subject) {
  const Plugin plugin(subject);
  const ProbeHost host;
  for (const char* id : {"org.burin.nobody", ""})
    require(!plugin.factory().create(&plugin.factory(), host.abi(), id, nullptr),
            fmt::format("creates a brush '{}'", id));
}

/// Lets a call fail with texts of several capacities, and looks at the bytes around them. `fails` returns
/// whether the call failed.
void look_at_texts(const char* of, const std::function<bool(burin_text*)>& fails) {
  if (!fails(nullptr)) return;
  for (const std::uint32_t capacity : {0u, 1u, 16u, 200u}) {
    std::vector<char> bytes(1000, '#');
    burin_text text{sizeof text, capacity, bytes.data()};
    if (!fails(&text)) continue;
    require(std::ranges::all_of(bytes.begin() + capacity, bytes.end(), [](char c) { return c == '#'; }),
            fmt::format("{} writes beyond a text of {} bytes", of, capacity));
    if (capacity == 0) continue;
    require(bytes[0] != '#' || std::memchr(bytes.data(), 0, capacity),
            fmt::format("{} fails without a text", of));
    require(std::memchr(bytes.data(), 0, capacity),
            fmt::format("{} does not end a text of {} bytes", of, capacity));
    require(!bytes[0] || is_text(bytes.data()),
            fmt::format("{} cuts its text within a character, or it is no UTF-8", of));
  }
}

/// Fails where a number is none; brushes may take that, too.
void look_at_texts_of_begin(ProbeBrush& brush) {
  for (std::uint32_t i = 0; i < brush.descriptor.param_count; ++i)
    if (brush.descriptor.params[i]->type == BURIN_PARAM_FLOAT)
      brush.values.set_number(i, std::numeric_limits<float>::quiet_NaN());
  const burin_stroke_context context = empty_stroke_context();
  look_at_texts("begin", [&](burin_text* text) {
    burin_stroke_plan plan{sizeof plan, 1, 0};
    void* stroke = nullptr;
    const burin_status status =
        brush.abi().begin(&brush.abi(), &context, &brush.values.abi(), &plan, &stroke, text);
    if (status == BURIN_OK) brush.abi().end(&brush.abi(), stroke);
    return status != BURIN_OK;
  });
}

void look_at_texts_of_load(const ProbeBrush& brush) {
  const auto* state = brush.interface<burin_state>(BURIN_EXT_STATE);
  if (!state) return;
  const std::array<char, 3> bytes{};
  look_at_texts("load", [&](burin_text* text) {
    return state->load(&brush.abi(), state->version, bytes.data(), bytes.size(), text) != BURIN_OK;
  });
}

void check_text_capacity(const Subject& subject) {
  {
    const Plugin plugin(subject);
    const ProbeHost host;
    look_at_texts("create", [&](burin_text* text) {
      return !plugin.factory().create(&plugin.factory(), host.abi(), "org.burin.nobody", text);
    });
  }
  each_brush(subject, [&](const Plugin& plugin, const Brush& descriptor) {
    ProbeBrush brush(plugin, descriptor, subject);
    look_at_texts_of_load(brush);
    look_at_texts_of_begin(brush);
  });
}

/// Draws with a host that lacks `withheld`; a refusal with a text is fine.
void draw_without(const Plugin& plugin, const Brush& descriptor, const Subject& subject,
                  const std::set<std::string>& withheld) {
  ProbeHost host;
  host.withheld = withheld;
  std::array<char, 400> line{};
  burin_text error{sizeof error, 400, line.data()};
  const burin_brush* brush = plugin.factory().create(&plugin.factory(), host.abi(), descriptor.id, &error);
  require(brush || line[0], "create fails without a text where a service is missing");
  if (!brush) return;
  Values values(descriptor, subject);
  burin_stroke_plan plan{sizeof plan, 1, 0};
  void* stroke = nullptr;
  const burin_stroke_context context = stroke_context(), empty = empty_stroke_context();
  const burin_status status = brush->begin(brush, &empty, &values.abi(), &plan, &stroke, &error);
  if (status == BURIN_OK) {
    const Nodes nodes = random_nodes(64, subject.seed);
    std::vector<Row> rows(nodes.size());
    const burin_batch batch = batch_of(nodes, 0, nodes.size(), values.abi());
    const burin_outputs outputs = outputs_of(rows);
    brush->evaluate(brush, stroke, &context, &batch, &outputs, &error);
    brush->end(brush, stroke);
  }
  brush->destroy(brush);
  require(status == BURIN_OK || line[0], "begin fails without a text where a service is missing");
}

void check_services(const Subject& subject) {
  each_brush(subject, [&](const Plugin& plugin, const Brush& descriptor) {
    const std::array services = {BURIN_EXT_LOG, BURIN_EXT_STAMPS, BURIN_EXT_LETTERING, BURIN_EXT_VDB_STAMPS};
    for (unsigned subset = 1; subset < 1u << services.size(); ++subset) {
      std::set<std::string> withheld;
      for (std::size_t i = 0; i < services.size(); ++i)
        if (subset >> i & 1) withheld.insert(services[i]);
      draw_without(plugin, descriptor, subject, withheld);
    }
  });
}

/// How many bytes larger the structs of a newer host are.
constexpr std::size_t growth = 24;

/// A struct of another size, its bytes beyond `size` set to 0xEE: on the heap, where sanitizers see its end.
template <class Struct>
std::vector<std::byte> resized(const Struct& from, std::size_t size) {
  std::vector<std::byte> bytes(std::max(size, sizeof from), std::byte{0xEE});
  std::memcpy(bytes.data(), &from, std::min(size, sizeof from));
  const auto told = static_cast<std::uint32_t>(size);
  std::memcpy(bytes.data(), &told, sizeof told);
  return bytes;
}

/// Fails if a brush wrote into a struct of another size behind the members that there are.
template <class Struct>
void require_unchanged_behind(const std::vector<std::byte>& filled, const std::string& otherwise) {
  require(std::all_of(filled.begin() + sizeof(Struct), filled.end(),
                      [](std::byte byte) { return byte == std::byte{0xEE}; }),
          otherwise);
}

/// Fails if what a brush filled differs from the struct of this version, or goes on behind it.
template <class Struct>
void require_filled_as(const Struct& expected, const std::vector<std::byte>& filled, const char* name) {
  const auto* bytes = reinterpret_cast<const std::byte*>(&expected);
  require(std::equal(bytes + sizeof(std::uint32_t), bytes + sizeof expected,
                     filled.data() + sizeof(std::uint32_t)),
          fmt::format("fills a larger {} with something else", name));
  require_unchanged_behind<Struct>(filled, fmt::format("writes members of {} that there are not", name));
}

void create_by_larger_host(const Plugin& plugin, const Brush& descriptor) {
  const ProbeHost host;
  const auto larger = resized(*host.abi(), sizeof(burin_host) + growth);
  std::array<char, 200> line{};
  burin_text error{sizeof error, 200, line.data()};
  const burin_brush* brush = plugin.factory().create(
      &plugin.factory(), reinterpret_cast<const burin_host*>(larger.data()), descriptor.id, &error);
  require(brush, fmt::format("create fails with a larger burin_host: {}", line.data()));
  brush->destroy(brush);
}

void plan_larger_solid(const ProbeBrush& brush, const ProbeStroke& stroke) {
  const auto* volume = brush.interface<burin_volume>(BURIN_EXT_VOLUME);
  if (!volume) return;
  const burin_stroke_context context = finished_context();
  const auto plan = [&](burin_solid_plan& to) {
    return volume->plan(&brush.abi(), stroke.self(), &context, &stroke.params(), &to, nullptr);
  };
  burin_solid_plan expected{sizeof expected, 0, 0, 0, 0};
  auto larger = resized(expected, sizeof expected + growth);
  if (plan(expected) != BURIN_OK) return;  // ability.volume tells it.
  require(plan(*reinterpret_cast<burin_solid_plan*>(larger.data())) == BURIN_OK,
          "its plan of a solid fails with a larger burin_solid_plan");
  require_filled_as(expected, larger, "burin_solid_plan");
}

void move_larger_curve(const ProbeBrush& brush, const ProbeStroke& stroke, const burin_curve_filter& filter) {
  const StraightCurve curve(3);
  const auto larger = resized(curve.points(), sizeof(burin_curve_points) + growth);
  const auto moved = [&](const burin_curve_points& points, const char* otherwise) {
    return offsets(brush, stroke, filter, points, 10, otherwise);
  };
  require(moved(curve.points(), "filter fails") ==
              moved(*reinterpret_cast<const burin_curve_points*>(larger.data()),
                    "filter fails with burin_curve_points of another size"),
          "moves larger burin_curve_points elsewhere");
}

void tell_larger_reach(const ProbeBrush& brush, const ProbeStroke& stroke, const burin_curve_filter& filter) {
  burin_curve_reach expected{sizeof expected, 0, 0, 0};
  auto larger = resized(expected, sizeof expected + growth);
  filter.reach(&brush.abi(), stroke.self(), &expected);
  filter.reach(&brush.abi(), stroke.self(), reinterpret_cast<burin_curve_reach*>(larger.data()));
  require_filled_as(expected, larger, "burin_curve_reach");
}

/// Sizes of the structs that a host of some version passes.
struct HostSizes {
  std::size_t context = sizeof(burin_stroke_context), batch = sizeof(burin_batch),
              outputs = sizeof(burin_outputs), plan = sizeof(burin_stroke_plan),
              params = sizeof(burin_params), text = sizeof(burin_text);
};

std::vector<Row> draw_as(const HostSizes& sizes, ProbeBrush& brush, const Subject& subject) {
  ProbeStroke stroke(brush);
  const Nodes nodes = random_nodes(300, subject.seed);
  std::vector<Row> rows(nodes.size());
  const auto context = resized(stroke.context, sizes.context);
  const auto params = resized(stroke.params(), sizes.params);
  const auto& as_params = *reinterpret_cast<const burin_params*>(params.data());
  const auto batch = resized(batch_of(nodes, 0, nodes.size(), as_params), sizes.batch);
  std::array<char, 200> line{};
  auto error = resized(burin_text{sizeof(burin_text), 200, line.data()}, sizes.text);
  auto* as_text = reinterpret_cast<burin_text*>(error.data());
  const auto outputs = resized(outputs_of(rows), sizes.outputs);
  const auto empty = resized(empty_stroke_context(), sizes.context);
  const auto* as_context = reinterpret_cast<const burin_stroke_context*>(context.data());
  const burin_status status = brush.abi().evaluate(
      &brush.abi(), stroke.self(), as_context, reinterpret_cast<const burin_batch*>(batch.data()),
      reinterpret_cast<const burin_outputs*>(outputs.data()), as_text);
  require(status == BURIN_OK, fmt::format("evaluate fails with structs of another size: {}", line.data()));
  std::vector<std::byte> plan = resized(burin_stroke_plan{sizeof(burin_stroke_plan), 1, 0}, sizes.plan);
  void* again = nullptr;
  const burin_status begun =
      brush.abi().begin(&brush.abi(), reinterpret_cast<const burin_stroke_context*>(empty.data()), &as_params,
                        reinterpret_cast<burin_stroke_plan*>(plan.data()), &again, as_text);
  require(begun == BURIN_OK, fmt::format("begin fails with structs of another size: {}", line.data()));
  brush.abi().end(&brush.abi(), again);
  require_unchanged_behind<burin_stroke_plan>(plan, "begin writes members of the plan that there are not");
  return rows;
}

void compare_as(const HostSizes& sizes, const Plugin& plugin, const Brush& descriptor,
                const Subject& subject) {
  ProbeBrush brush(plugin, descriptor, subject);
  const Nodes nodes = random_nodes(300, subject.seed);
  const std::string other =
      difference(ProbeStroke(brush).evaluate(nodes), draw_as(sizes, brush, subject), nodes);
  require(other.empty(), "another host gets another result: " + other);
}

void check_newer_host(const Subject& subject) {
  each_brush(subject, [&](const Plugin& plugin, const Brush& descriptor) {
    compare_as({sizeof(burin_stroke_context) + 40, sizeof(burin_batch) + 160, sizeof(burin_outputs) + 64,
                sizeof(burin_stroke_plan) + 24, sizeof(burin_params) + 32, sizeof(burin_text) + 16},
               plugin, descriptor, subject);
    create_by_larger_host(plugin, descriptor);
    ProbeBrush brush(plugin, descriptor, subject);
    const ProbeStroke stroke(brush);
    plan_larger_solid(brush, stroke);
    const auto* filter = brush.interface<burin_curve_filter>(BURIN_EXT_CURVE_FILTER);
    if (!filter) return;
    tell_larger_reach(brush, stroke, *filter);
    move_larger_curve(brush, stroke, *filter);
  });
}

void check_older_host(const Subject& subject) {
  // A context without dab_t, which is 0 here.
  each_brush(subject, [&](const Plugin& plugin, const Brush& descriptor) {
    compare_as({.context = offsetof(burin_stroke_context, dab_t)}, plugin, descriptor, subject);
  });
}

void check_older_batch(const Subject& subject) {
  each_brush(subject, [&](const Plugin& plugin, const Brush& descriptor) {
    // Hosts without the input do not create such a brush.
    if (descriptor.inputs_read & BURIN_INPUT_END_DISTANCE) throw Skipped("it reads end_distance");
    compare_as({.batch = offsetof(burin_batch, end_distance)}, plugin, descriptor, subject);
  });
}

constexpr Check host_list[] = {
    {"host.unknown-extension", 1, "brush.h: get_extension returns the interface with this id, or null",
     "Asks brushes for interfaces that there are not.", check_unknown_extension},
    {"host.unknown-brush", 1, "plugin.h: create fails for an id that is none of its brushes",
     "Asks for brushes that there are not.", check_unknown_brush},
    {"host.text-capacity", 2,
     "base.h: the callee writes at most `capacity` bytes including the terminating zero and cuts between "
     "characters; the text may be null",
     "Lets create, begin and load fail, without a text and with texts of 0, 1, 16 and 200 bytes.",
     check_text_capacity},
    {"host.missing-services", 3, "host.h: get_extension returns null when the host does not have a service",
     "Draws with hosts that lack some services, in each way.", check_services},
    {"host.newer", 2, "base.h: structs may grow at their end",
     "Draws with a host whose structs are larger, those of solids and moved curves, too.", check_newer_host},
    {"host.older", 2, "base.h: a reader reads a member only if struct_size covers it",
     "Draws with a host whose context ends before dab_t.", check_older_host},
    {"host.older-batch", 2, "base.h: a reader reads a member only if struct_size covers it",
     "Draws with a host whose batch ends before end_distance.", check_older_batch},
};

}  // namespace

std::span<const Check> host_checks() { return host_list; }

}  // namespace burin::validate
