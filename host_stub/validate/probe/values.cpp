// Makes values for the parameters of a brush: its defaults, the ends of their ranges, or random ones.
#include "validate/probe/values.h"

#include <burin/host/plugin/brush_params.h>
#include <burin/host/plugin/param_snapshot.h>
#include <burin/stroke/files/setting_texts.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "validate/probe/plugin.h"

namespace burin::validate {

namespace {

/// The end of a range: the hard one, or the soft one where that is infinite, or the default where both are.
float end_of(const burin_param_info& info, float hard, float soft) {
  if (std::isfinite(hard)) return hard;
  return std::isfinite(soft) ? soft : info.default_number;
}

}  // namespace

float least_of(const burin_param_info& info) {
  if (info.type == BURIN_PARAM_BOOL || info.type == BURIN_PARAM_CHOICE) return 0;
  return end_of(info, info.hard_min, info.soft_min);
}

float greatest_of(const burin_param_info& info) {
  if (info.type == BURIN_PARAM_BOOL) return 1;
  if (info.type == BURIN_PARAM_CHOICE) return static_cast<float>(list_of(info.choices).size()) - 1;
  return end_of(info, info.hard_max, info.soft_max);
}

Values::Values(const burin_brush_descriptor& brush, const Subject& subject)
    : brush_(brush),
      subject_(subject),
      numbers_(brush.param_count),
      texts_(brush.param_count),
      knots_(brush.param_count),
      values_(brush.param_count) {
  for (std::uint32_t i = 0; i < brush.param_count; ++i) {
    const burin_param_info& info = *brush.params[i];
    numbers_[i] = {info.default_number};
    if (info.type == BURIN_PARAM_COLOUR) std::copy_n(info.default_colour, 4, numbers_[i].begin());
    if (info.type == BURIN_PARAM_TEXT && BURIN_HAS(&info, burin_param_info, default_text) &&
        info.default_text)
      texts_[i] = info.default_text;
    if (info.type == BURIN_PARAM_FILE)
      texts_[i] = info.default_file ? info.default_file : subject.stamp.string();
    needs_file_ |= is_to_choose(i);
    if (const std::string* text = given(i)) set_given(i, *text);
  }
}

const std::string* Values::given(std::uint32_t index) const {
  const char* id = brush_.params[index]->id;
  const auto found = id ? subject_.params.find(id) : subject_.params.end();
  return found == subject_.params.end() ? nullptr : &found->second;
}

void Values::set_given(std::uint32_t index, const std::string& text) {
  const burin_param_info& info = *brush_.params[index];
  const ParamSetting setting = takes_text(info.type) ? ParamSetting(text) : param_of_text(text);
  ParamValue value = resolve_param(brush_, info, &setting);
  numbers_[index] = value.numbers;
  texts_[index] = std::move(value.text);
  knots_[index] = std::move(value.knots);
}

bool Values::is_to_choose(std::uint32_t index) const {
  const burin_param_info& info = *brush_.params[index];
  return info.type == BURIN_PARAM_FILE && !info.default_file && !given(index);
}

void Values::set_numbers(const std::function<float(const burin_param_info&)>& number) {
  for (std::uint32_t i = 0; i < brush_.param_count; ++i) {
    const burin_param_info& info = *brush_.params[i];
    if (info.type >= BURIN_PARAM_FLOAT && info.type <= BURIN_PARAM_CHOICE) numbers_[i][0] = number(info);
    burin_param_info channel_info{};
    channel_info.hard_max = 1;
    if (info.type == BURIN_PARAM_COLOUR)
      for (float& channel : numbers_[i]) channel = number(channel_info);
  }
}

std::string Values::told() const {
  std::string text;
  for (std::uint32_t i = 0; i < brush_.param_count; ++i) {
    const burin_param_info& info = *brush_.params[i];
    if (info.type < BURIN_PARAM_FLOAT || info.type > BURIN_PARAM_CHOICE) continue;
    const float number = numbers_[i][0];
    const auto choice = static_cast<std::size_t>(number);
    text += fmt::format("{}{}={}", text.empty() ? "" : ", ", info.id,
                        info.type == BURIN_PARAM_CHOICE ? list_of(info.choices)[choice]
                        : info.type == BURIN_PARAM_BOOL ? std::string(number != 0 ? "true" : "false")
                                                        : fmt::format("{}", number));
  }
  return text;
}

void Values::set_least() { set_numbers(least_of); }
void Values::set_greatest() { set_numbers(greatest_of); }

void Values::set_random(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  set_numbers([&](const burin_param_info& info) {
    const double share = static_cast<double>(random() >> 11) * 0x1p-53;
    const float low = least_of(info), high = greatest_of(info);
    const auto value = static_cast<float>(low + share * (double{high} - low));
    const bool whole = info.type >= BURIN_PARAM_INT && info.type <= BURIN_PARAM_CHOICE;
    return std::clamp(whole ? std::round(value) : value, low, high);
  });
}

void Values::set_number(std::uint32_t index, float number) { numbers_[index].fill(number); }

bool Values::scale_lengths(float factor) {
  bool within = true;
  for (std::uint32_t i = 0; i < brush_.param_count; ++i) {
    const burin_param_info& info = *brush_.params[i];
    if (info.type != BURIN_PARAM_FLOAT || info.unit != BURIN_UNIT_LENGTH) continue;
    numbers_[i][0] *= factor;
    within &= numbers_[i][0] >= info.hard_min && numbers_[i][0] <= info.hard_max;
  }
  return within;
}

void Values::set_text(std::uint32_t index, std::string text) { texts_[index] = std::move(text); }

bool Values::choose_solids() {
  bool changes = false;
  const std::string solid = subject_.solid.string();
  for (std::uint32_t i = 0; i < brush_.param_count; ++i) {
    if (!is_to_choose(i) || texts_[i] == solid) continue;
    texts_[i] = solid;
    changes = true;
  }
  return changes;
}

const burin_params& Values::abi() {
  for (std::uint32_t i = 0; i < brush_.param_count; ++i) {
    const burin_param_info& info = *brush_.params[i];
    burin_param_value& value = values_[i] = {};
    const bool text = info.type == BURIN_PARAM_TEXT || info.type == BURIN_PARAM_FILE;
    if (text) value.text = texts_[i].c_str();
    if (info.type >= BURIN_PARAM_FLOAT && info.type <= BURIN_PARAM_CHOICE)
      value.number.data = numbers_[i].data();
    if (info.type == BURIN_PARAM_COLOUR)
      for (std::size_t c = 0; c < 4; ++c) value.colour[c].data = &numbers_[i][c];
    if (info.type == BURIN_PARAM_CURVE) {
      value.knots = knots_[i].empty() ? info.default_knots : knots_[i].data();
      value.knot_count =
          knots_[i].empty() ? info.default_knot_count : static_cast<std::uint32_t>(knots_[i].size() / 2);
    }
  }
  params_ = {sizeof(burin_params), brush_.param_count, values_.data()};
  return params_;
}

}  // namespace burin::validate
