// Resolves the settings of all parameters of a brush, and lays the values out as the ABI's structs.
#include <burin/base/error.h>
#include <burin/base/text/quoted_word.h>
#include <burin/host/plugin/param_snapshot.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace burin {
namespace {

const burin_param_info* find_param(const burin_brush_descriptor& brush, const std::string& id) {
  const auto* end = brush.params + brush.param_count;
  const auto* found =
      std::find_if(brush.params, end, [&](const burin_param_info* info) { return info->id == id; });
  return found == end ? nullptr : *found;
}

std::string known_params(const burin_brush_descriptor& brush) {
  std::string list;
  for (std::uint32_t i = 0; i < brush.param_count; ++i)
    list += (i == 0 ? "" : ", ") + std::string(brush.params[i]->id);
  return list.empty() ? "none" : list;
}

burin_param_value abi_value(const burin_param_info& info, const ParamValue& value) {
  burin_param_value abi{};
  switch (info.type) {
    case BURIN_PARAM_COLOUR:
      for (std::size_t k = 0; k < 4; ++k) abi.colour[k] = {&value.numbers[k], 0, 0};
      break;
    case BURIN_PARAM_FILE:
    case BURIN_PARAM_TEXT:
      abi.text = value.text.c_str();
      break;
    case BURIN_PARAM_CURVE:
      abi.knots = value.knots.data();
      abi.knot_count = static_cast<std::uint32_t>(value.knots.size() / 2);
      break;
    default:
      abi.number = {value.numbers.data(), 0, 0};
  }
  return abi;
}

}  // namespace

ParamSnapshot::ParamSnapshot(const burin_brush_descriptor& brush, const ParamSettings& settings) {
  for (const auto& [id, setting] : settings)
    if (!find_param(brush, id))
      throw Error(fmt::format("{} has no parameter {}; there are: {}", brush.id, quoted_word(id),
                              known_params(brush)));
  values_.reserve(brush.param_count);
  for (std::uint32_t i = 0; i < brush.param_count; ++i) {
    const burin_param_info& info = *brush.params[i];
    const auto setting = settings.find(info.id);
    values_.push_back(resolve_param(brush, info, setting == settings.end() ? nullptr : &setting->second));
    abi_values_.push_back(abi_value(info, values_.back()));
  }
  params_ = {sizeof(burin_params), brush.param_count, abi_values_.data()};
}

}  // namespace burin
