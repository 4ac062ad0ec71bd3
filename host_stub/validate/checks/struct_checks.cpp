// Checks that what a plugin hands to hosts is as large as it says, and whole: hosts refuse it otherwise.
#include <burin/abi/ext/bench_budget.h>
#include <burin/abi/ext/curve_filter.h>
#include <burin/abi/ext/state.h>
#include <burin/abi/ext/volume.h>
#include <burin/host/plugin/brush_module.h>
#include <fmt/format.h>

#include "validate/probe/stroke.h"

namespace burin::validate {
namespace {

void require_size(bool large_enough, const char* of, std::uint32_t size, std::size_t usual) {
  require(large_enough,
          fmt::format("the struct_size of {} is {}, which is too small; its sizeof is {}", of, size, usual));
}

void check_param_sizes(const burin_brush_descriptor& brush) {
  for (std::uint32_t i = 0; i < brush.param_count && brush.params; ++i)
    if (const burin_param_info* info = brush.params[i])
      require_size(BURIN_HAS(info, burin_param_info, default_knot_count),
                   fmt::format("parameter '{}'", info->id ? info->id : "").c_str(), info->struct_size,
                   sizeof *info);
}

/// Of a brush that is made, which is whole then.
void check_brush_size(const burin_brush& brush) {
  require_size(BURIN_HAS(&brush, burin_brush, end), "its burin_brush", brush.struct_size, sizeof brush);
  require(is_whole(brush), "its burin_brush lacks a function");
}

template <class Interface, class Member>
void check_interface(const ProbeBrush& brush, const char* id, Member Interface::*last) {
  const auto* offered = brush.interface<Interface>(id);
  if (!offered) return;
  const auto end = reinterpret_cast<const char*>(&(offered->*last)) + sizeof(Member) -
                   reinterpret_cast<const char*>(offered);
  require_size(offered->struct_size >= static_cast<std::size_t>(end), id, offered->struct_size,
               sizeof *offered);
  require(offered->*last, fmt::format("its {} lacks a function", id));
}

void check_struct_sizes(const Subject& subject) {
  each_brush(subject, [&](const Plugin& plugin, const burin_brush_descriptor& descriptor) {
    require_size(BURIN_HAS(&descriptor, burin_brush_descriptor, outputs_written), "its descriptor",
                 descriptor.struct_size, sizeof descriptor);
    check_param_sizes(descriptor);
    const ProbeBrush brush(plugin, descriptor, subject);
    check_brush_size(brush.abi());
    check_interface(brush, BURIN_EXT_STATE, &burin_state::load);
    check_interface(brush, BURIN_EXT_VOLUME, &burin_volume::distance);
    check_interface(brush, BURIN_EXT_CURVE_FILTER, &burin_curve_filter::filter);
    check_interface(brush, BURIN_EXT_BENCH_BUDGET, &burin_bench_budget::evaluate_cost);
  });
}

constexpr Check struct_list[] = {
    {"descriptor.struct-sizes", 1,
     "base.h: every struct that may grow starts with struct_size, at least that of version 1.0",
     "Reads the sizes of descriptors, parameters, brushes and interfaces.", check_struct_sizes},
};

}  // namespace

std::span<const Check> struct_checks() { return struct_list; }

}  // namespace burin::validate
