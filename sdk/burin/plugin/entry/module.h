#pragma once
#include <burin/abi/ext/bench_budget.h>
#include <burin/abi/plugin.h>
#include <burin/plugin/brush.h>
#include <burin/plugin/c/param_ranges.h>
#include <burin/plugin/curve_filter.h>
#include <burin/plugin/detail/error.h>
#include <burin/plugin/entry/checks.h>
#include <burin/plugin/solid.h>

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>

/// The C side of a plugin module. Every template here has a tag type that is local to the module
/// (BURIN_PLUGIN defines it), because some systems share the static data of equally named types between
/// loaded modules.
namespace burin::plugin::detail {

template <class B>
constexpr auto params_of() {
  if constexpr (requires { B::params; })
    return B::params;
  else
    return std::array<burin_param_info, 0>{};
}

/// The descriptor of brush B, checked and built at compile time.
template <class Tag, class B>
struct Declaration {
  static_assert(std::derived_from<B, Brush>);
  static_assert(checks::reverse_dns(B::info.id), "BrushInfo::id must read like \"org.example.ripple\"");
  static_assert(checks::present(B::info.name) && checks::present(B::info.vendor) &&
                    checks::present(B::info.version),
                "BrushInfo needs name, vendor and version");

  static_assert(B::info.overlap >= BURIN_OVERLAP_STRONGEST && B::info.overlap <= BURIN_OVERLAP_AVERAGE,
                "BrushInfo::overlap must be one of BURIN_OVERLAP_STRONGEST .. BURIN_OVERLAP_AVERAGE");
  static_assert(checks::promises(B::info.budget), "BrushInfo::budget must be a finite number from 0 on");

  static constexpr auto params = params_of<B>();
  template <std::size_t... I>
  static constexpr bool check_params(std::index_sequence<I...>) {
    return (
        checks::parameter_keeps_rules<checks::Text(params[I].id), checks::Text(checks::broken_by(params, I))>(
            params[I].id, checks::broken_by(params, I)) &&
        ...);
  }
  static_assert(check_params(std::make_index_sequence<params.size()>()));

  template <std::size_t... I>
  static constexpr std::array<const burin_param_info*, sizeof...(I)> pointers(std::index_sequence<I...>) {
    return {&params[I]...};
  }
  static constexpr auto param_pointers = pointers(std::make_index_sequence<params.size()>());

  static constexpr burin_brush_descriptor descriptor{sizeof(burin_brush_descriptor),
                                                     static_cast<std::uint32_t>(params.size()),
                                                     B::info.id,
                                                     B::info.name,
                                                     B::info.vendor,
                                                     B::info.version,
                                                     B::info.help,
                                                     B::info.features.data(),
                                                     param_pointers.data(),
                                                     B::info.inputs,
                                                     B::info.outputs,
                                                     B::info.overlap,
                                                     0,
                                                     B::info.rim_slope,
                                                     0};
};

/// A burin_brush that creates a B for every stroke.
template <class Tag, class B>
class Instance {
 public:
  Instance(const burin_host* host, const std::string& module_path) : host_(host), module_path_(module_path) {}

  static const burin_brush* create(const burin_host* host, const std::string& module_path) {
    return &(new Instance(host, module_path))->abi_;
  }

 private:
  static constexpr const burin_brush_descriptor& descriptor = Declaration<Tag, B>::descriptor;

  static const Instance* from(const burin_brush* brush) { return static_cast<const Instance*>(brush->self); }

  static void BURIN_CALL destroy(const burin_brush* brush) { delete from(brush); }

  static const void* BURIN_CALL get_extension(const burin_brush*, const char* id) {
    if constexpr (std::derived_from<B, SolidBrush>)
      if (std::string_view(id) == BURIN_EXT_VOLUME) return &volume_;
    if constexpr (std::derived_from<B, CurveFilter>)
      if (std::string_view(id) == BURIN_EXT_CURVE_FILTER) return &curve_filter_;
    if constexpr (B::info.budget > 0)
      if (std::string_view(id) == BURIN_EXT_BENCH_BUDGET) return &budget_;
    return nullptr;
  }

  static burin_status BURIN_CALL begin(const burin_brush* brush, const burin_stroke_context* context,
                                       const burin_params* params, burin_stroke_plan* plan, void** stroke,
                                       burin_text* error) noexcept {
    return guarded(error, [&] {
      const Instance* self = from(brush);
      if (const burin_param_info* outside = burin_outside_range(&descriptor, params))
        throw Error(std::string("a value is outside of its range: ") + outside->id, BURIN_INVALID_ARGUMENT);
      StrokeStart start{Stroke(*context), Params(descriptor, params), self->host_, self->module_path_};
      auto made = make_stroke(start);
      if (BURIN_HAS(plan, burin_stroke_plan, passes)) plan->passes = start.passes;
      if (BURIN_HAS(plan, burin_stroke_plan, end_influence)) plan->end_influence = start.end_influence;
      *stroke = made.release();
    });
  }

  static std::unique_ptr<B> make_stroke(StrokeStart& start) {
    if constexpr (std::constructible_from<B, StrokeStart&>)
      return std::make_unique<B>(start);
    else
      return std::make_unique<B>();
  }

  static burin_status BURIN_CALL evaluate(const burin_brush*, void* stroke,
                                          const burin_stroke_context* context, const burin_batch* batch,
                                          const burin_outputs* outputs, burin_text* error) noexcept {
    return guarded(error, [&] {
      static_cast<const B*>(stroke)->evaluate(Batch(descriptor, *context, *batch), Outputs(*outputs));
    });
  }

  static burin_status BURIN_CALL plan_solid(const burin_brush*, void* stroke,
                                            const burin_stroke_context* context, const burin_params* params,
                                            burin_solid_plan* plan, burin_text* error) noexcept {
    return guarded(error, [&] {
      const SolidPlan made =
          static_cast<const B*>(stroke)->solid(Stroke(*context), Params(descriptor, params));
      plan->h_min = made.h_min;
      plan->h_max = made.h_max;
      plan->detail = made.detail;
      plan->operation = static_cast<std::uint32_t>(made.use);
    });
  }

  static burin_status BURIN_CALL distance(const burin_brush*, void* stroke,
                                          const burin_stroke_context* context, const burin_batch* batch,
                                          burin_floats h, burin_floats_out distance,
                                          burin_text* error) noexcept {
    return guarded(error, [&] {
      static_cast<const B*>(stroke)->distance(Batch(descriptor, *context, *batch), {h.data, h.stride},
                                              {distance.data, distance.stride});
    });
  }

  static constexpr burin_volume volume() {
    if constexpr (std::derived_from<B, SolidBrush>)
      return {sizeof(burin_volume), 0, plan_solid, distance};
    else
      return {};
  }
  static constexpr burin_volume volume_ = volume();

  static void BURIN_CALL reach(const burin_brush*, void* stroke, burin_curve_reach* reach) noexcept {
    const CurveReach told = static_cast<const B*>(stroke)->reach();
    reach->behind = told.behind;
    reach->ahead = told.ahead;
  }

  static burin_status BURIN_CALL move_curve(const burin_brush*, void* stroke,
                                            const burin_stroke_context* context, const burin_params* params,
                                            const burin_curve_points* points, burin_floats_out along,
                                            burin_floats_out across, burin_text* error) noexcept {
    return guarded(error, [&] {
      static_cast<const B*>(stroke)->move(CurvePoints(descriptor, *context, params, *points),
                                          {along.data, along.stride}, {across.data, across.stride});
    });
  }

  static constexpr burin_curve_filter curve_filter() {
    if constexpr (std::derived_from<B, CurveFilter>)
      return {sizeof(burin_curve_filter), 0, reach, move_curve};
    else
      return {};
  }
  static constexpr burin_curve_filter curve_filter_ = curve_filter();

  static double BURIN_CALL evaluate_cost(const burin_brush*, const burin_params*) noexcept {
    return B::info.budget;
  }
  static constexpr burin_bench_budget budget_{sizeof(burin_bench_budget), 0, evaluate_cost};

  static void BURIN_CALL end(const burin_brush*, void* stroke) { delete static_cast<B*>(stroke); }

  const Host host_;
  const std::string module_path_;
  const burin_brush abi_{sizeof(burin_brush), 0, this, destroy, get_extension, begin, evaluate, end};
};

/// The functions behind the exported symbol of a module with these brushes.
template <class Tag, class... Brushes>
class Module {
 public:
  static constexpr burin_plugin_entry entry() {
    return {sizeof(burin_plugin_entry), BURIN_ABI_MAJOR, BURIN_ABI_MINOR, 0, init, deinit, get_factory};
  }

 private:
  static_assert(checks::all_differ({Brushes::info.id...}), "two brushes of the module have the same id");

  /// The state that init and deinit count. It has a lock since a host may have several loaders.
  struct State {
    std::mutex lock;
    int users = 0;
    std::string path;
  };
  static inline State state_;

  static burin_status BURIN_CALL init(const char* plugin_path, burin_text* error) noexcept {
    return guarded(error, [&] {
      const std::lock_guard guard(state_.lock);
      if (state_.users == 0) state_.path = plugin_path ? plugin_path : "";
      ++state_.users;
    });
  }

  static void BURIN_CALL deinit() noexcept {
    const std::lock_guard guard(state_.lock);
    if (state_.users > 0) --state_.users;
  }

  static const void* BURIN_CALL get_factory(const char* factory_id) noexcept {
    const std::lock_guard guard(state_.lock);
    return state_.users > 0 && std::string_view(factory_id) == BURIN_BRUSH_FACTORY ? &factory_ : nullptr;
  }

  static const burin_brush* BURIN_CALL create(const burin_brush_factory*, const burin_host* host,
                                              const char* brush_id, burin_text* error) noexcept {
    const burin_brush* brush = nullptr;
    guarded(error, [&] {
      const std::string_view id = brush_id;
      const bool found = ((id == Declaration<Tag, Brushes>::descriptor.id &&
                           (brush = Instance<Tag, Brushes>::create(host, state_.path))) ||
                          ...);
      if (!found) throw Error("this plugin has no brush '" + std::string(id) + "'", BURIN_NOT_FOUND);
    });
    return brush;
  }

  static constexpr const burin_brush_descriptor* descriptors_[] = {&Declaration<Tag, Brushes>::descriptor...};
  static constexpr burin_brush_factory factory_{sizeof(burin_brush_factory), sizeof...(Brushes), descriptors_,
                                                create};
};

}  // namespace burin::plugin::detail
