// Computes strength and parameters at a point of the curve. Dynamics multiply the value, or are added to an
// angle; the result is clamped to the parameter's hard range.
#include <burin/base/error.h>
#include <burin/base/text/quoted_word.h>
#include <burin/deform/evaluate/param_dynamics.h>
#include <burin/stroke/files/recording_faults.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace burin {
namespace {

bool is_number(const burin_param_info& info) {
  return info.type == BURIN_PARAM_FLOAT || info.type == BURIN_PARAM_INT || info.type == BURIN_PARAM_BOOL;
}

bool may_vary(const burin_param_info& info) { return info.dynamic == 1 && is_number(info); }

std::string known_targets(const burin_brush_descriptor& brush) {
  std::string list = "radius, strength";
  for (std::uint32_t i = 0; i < brush.param_count; ++i)
    if (may_vary(*brush.params[i])) list += fmt::format(", {}", brush.params[i]->id);
  return list;
}

void check(const burin_brush_descriptor& brush, const Dynamic& dynamic) {
  if (const std::string_view fault = validation_error(dynamic); !fault.empty())
    throw Error(fmt::format("dynamics of {}: {}", quoted_word(dynamic.target), fault));
  if (dynamic.target == "radius" || dynamic.target == "strength") return;
  for (std::uint32_t i = 0; i < brush.param_count; ++i)
    if (brush.params[i]->id == dynamic.target && may_vary(*brush.params[i])) return;
  throw Error(fmt::format("dynamics of {}: {} has no such thing that varies along a stroke; there are: {}",
                          quoted_word(dynamic.target), brush.id, known_targets(brush)));
}

ParamDynamics::Param varying(const burin_param_info& info, std::uint32_t index, float before,
                             TargetDynamics dynamics) {
  constexpr float most = std::numeric_limits<float>::max();
  const bool is_truth = info.type == BURIN_PARAM_BOOL;
  return {.index = index,
          .before = before,
          .low = is_truth ? 0 : std::max(info.hard_min, -most),
          .high = is_truth ? 1 : std::min(info.hard_max, most),
          .adds = info.unit == BURIN_UNIT_ANGLE,
          .whole = info.type != BURIN_PARAM_FLOAT,
          .dynamics = std::move(dynamics)};
}

}  // namespace

ParamDynamics::ParamDynamics(const burin_brush_descriptor& brush, const burin_params& before,
                             std::span<const Dynamic> dynamics, const DrivenStroke& stroke)
    : strength_(dynamics, "strength", stroke) {
  for (const Dynamic& dynamic : dynamics) check(brush, dynamic);
  for (std::uint32_t i = 0; i < brush.param_count; ++i) {
    const burin_param_info& info = *brush.params[i];
    TargetDynamics of_this(dynamics, info.id, stroke);
    if (!of_this.empty() && may_vary(info))
      params_.push_back(varying(info, i, before.values[i].number.data[0], std::move(of_this)));
  }
}

float ParamDynamics::strength(const PenAt& at, double loop) const {
  return static_cast<float>(strength_.product(at, loop));
}

float ParamDynamics::value(const Param& param, const PenAt& at, double loop) {
  const double driven = param.adds ? param.before + param.dynamics.sum(at, loop)
                                   : param.before * param.dynamics.product(at, loop);
  return static_cast<float>(std::clamp(param.whole ? std::round(driven) : driven, param.low, param.high));
}

}  // namespace burin
