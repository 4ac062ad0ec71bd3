// Checks what a plugin declares.
#include <burin/host/plugin/descriptor_check.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>
#include <set>
#include <string_view>

#include "validate/probe/nodes.h"
#include "validate/probe/plugin.h"
#include "validate/probe/repeat.h"
#include "validate/probe/values.h"

namespace burin::validate {
namespace {

using Brush = burin_brush_descriptor;

/// Letters, digits, - and _ in at least two words between dots.
bool is_reverse_dns(std::string_view id) {
  const auto allowed = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_' || c == '.';
  };
  return std::all_of(id.begin(), id.end(), allowed) && id.find('.') != id.npos && id.find("..") == id.npos &&
         id.front() != '.' && id.back() != '.';
}

void check_ids(const Subject& subject) {
  const Plugin plugin(subject);
  std::set<std::string_view> ids;
  for (const Brush* brush : plugin.brushes()) {
    require(brush && brush->id && *brush->id, "a brush has no id");
    require(is_reverse_dns(brush->id),
            fmt::format("'{}' is no reverse DNS name as org.example.brush", brush->id));
    require(ids.insert(brush->id).second, fmt::format("two brushes are '{}'", brush->id));
  }
  require(!ids.empty(), "the module has no brushes");
}

void require_text(const char* text, const char* of, std::size_t longest) {
  require(is_text(text), fmt::format("{} is no UTF-8 text", of));
  require(std::strlen(text) <= longest, fmt::format("{} is longer than {} bytes", of, longest));
}

void check_texts(const Subject& subject) {
  each_brush(subject, [](const Plugin&, const Brush& brush) {
    require_text(brush.name, "its name", 64);
    require_text(brush.vendor, "its vendor", 64);
    require_text(brush.version, "its version", 32);
    if (brush.help) require_text(brush.help, "its help", 1000);
    for (std::uint32_t i = 0; i < brush.param_count; ++i) {
      const burin_param_info& info = *brush.params[i];
      require_text(info.name, fmt::format("the name of parameter {}", i).c_str(), 64);
      if (info.help) require_text(info.help, fmt::format("the help of parameter {}", i).c_str(), 1000);
    }
  });
}

void check_version(const Subject& subject) {
  each_brush(subject, [](const Plugin&, const Brush& brush) {
    const std::string_view version = brush.version ? brush.version : "";
    const bool numbers = !version.empty() && std::isdigit(static_cast<unsigned char>(version[0]));
    require(numbers, fmt::format("its version '{}' does not begin with a number", version));
  });
}

void check_masks(const Subject& subject) {
  each_brush(subject, [](const Plugin&, const Brush& brush) {
    std::uint64_t inputs = 0;
    for (const InputColumns& input : input_columns()) inputs |= input.bit;
    constexpr std::uint64_t outputs = BURIN_OUTPUT_DISPLACEMENT | BURIN_OUTPUT_MASK | BURIN_OUTPUT_COLOUR;
    require((brush.inputs_read & ~inputs) == 0,
            fmt::format("reads unknown inputs, bits {:#x}", brush.inputs_read & ~inputs));
    require((brush.outputs_written & ~outputs) == 0,
            fmt::format("writes unknown outputs, bits {:#x}", brush.outputs_written & ~outputs));
  });
}

void check_features(const Subject& subject) {
  const std::set<std::string_view> known = {BURIN_FEATURE_FIXED_PLACE, BURIN_FEATURE_ONE_HANDED,
                                            BURIN_FEATURE_FIXED_SCALE};
  each_brush(subject, [&](const Plugin&, const Brush& brush) {
    require(brush.features, "its list of features is null");
    for (const char* feature : list_of(brush.features)) {
      require(is_text(feature), "a feature is no text");
      require(!std::string_view(feature).starts_with("burin.") || known.contains(feature),
              fmt::format("'{}' is no feature of the ABI", feature));
    }
  });
}

void check_overlap(const Subject& subject) {
  each_brush(subject, [](const Plugin&, const Brush& brush) {
    if (!BURIN_HAS(&brush, Brush, overlap)) throw Skipped("it is made for ABI 1.0");
    require(brush.overlap >= BURIN_OVERLAP_UNKNOWN && brush.overlap <= BURIN_OVERLAP_AVERAGE,
            fmt::format("its overlap is {}", brush.overlap));
  });
}

/// Calls `check` for each parameter of each brush; a failure's text names the parameter.
void each_param(const Subject& subject, void (*check)(const burin_param_info& info)) {
  each_brush(subject, [&](const Plugin&, const Brush& brush) {
    if (brush.param_count == 0) throw Skipped("it has no parameters");
    for (std::uint32_t i = 0; i < brush.param_count; ++i) {
      const burin_param_info& info = *brush.params[i];
      tell_where(fmt::format("parameter '{}': ", info.id ? info.id : ""), [&] { check(info); });
    }
  });
}

void check_param_ids(const Subject& subject) {
  each_brush(subject, [](const Plugin&, const Brush& brush) {
    std::set<std::string_view> ids;
    for (std::uint32_t i = 0; i < brush.param_count; ++i) {
      const char* id = brush.params && brush.params[i] ? brush.params[i]->id : nullptr;
      require(id && *id, fmt::format("parameter {} has no id", i));
      require(std::string_view(id).find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") ==
                  std::string_view::npos,
              fmt::format("the id '{}' has characters beside a-z, 0-9 and _", id));
      require(ids.insert(id).second, fmt::format("two parameters are '{}'", id));
    }
  });
}

bool is_number(const burin_param_info& info) {
  return info.type == BURIN_PARAM_FLOAT || info.type == BURIN_PARAM_INT;
}

void check_ranges(const burin_param_info& info) {
  if (!is_number(info)) return;
  require(info.hard_min <= info.hard_max, "its hard range is empty");
  require(std::isfinite(info.soft_min) && std::isfinite(info.soft_max), "its soft range is not finite");
  require(info.soft_min <= info.soft_max, "its soft range is empty");
  require(info.soft_min < info.soft_max || info.hard_min == info.hard_max,
          fmt::format("its soft range, which a slider spans, is {} .. {}", info.soft_min, info.soft_max));
  require(info.soft_min >= info.hard_min && info.soft_max <= info.hard_max,
          fmt::format("its soft range {} .. {} exceeds the hard one, {} .. {}", info.soft_min, info.soft_max,
                      info.hard_min, info.hard_max));
}

void check_defaults(const burin_param_info& info) {
  if (info.type == BURIN_PARAM_COLOUR)
    for (const float channel : info.default_colour)
      require(channel >= 0 && channel <= 1, fmt::format("its default has a channel of {}", channel));
  if (info.type < BURIN_PARAM_FLOAT || info.type > BURIN_PARAM_CHOICE) return;
  const float value = info.default_number;
  const float low = is_number(info) ? info.hard_min : least_of(info);
  const float high = is_number(info) ? info.hard_max : greatest_of(info);
  require(std::isfinite(value) && value >= low && value <= high,
          fmt::format("its default {} lies outside {} .. {}", value, low, high));
}

void check_whole(const burin_param_info& info) {
  if (info.type != BURIN_PARAM_INT && info.type != BURIN_PARAM_CHOICE && info.type != BURIN_PARAM_BOOL)
    return;
  const bool has_range = info.type == BURIN_PARAM_INT;
  for (const float number :
       {info.default_number, has_range ? info.soft_min : 0.0f, has_range ? info.soft_max : 0.0f})
    require(std::trunc(number) == number && std::abs(number) <= largest_whole_param,
            fmt::format("{} is no whole number within 2^24", number));
}

void check_choices(const burin_param_info& info) {
  if (info.type != BURIN_PARAM_CHOICE) return;
  std::set<std::string_view> ids;
  for (const char* choice : list_of(info.choices)) {
    require(is_text(choice), "a choice has no id");
    require(ids.insert(choice).second, fmt::format("two choices are '{}'", choice));
  }
  require(!ids.empty(), "it has no choices");
}

void check_units(const burin_param_info& info) {
  require(info.unit >= BURIN_UNIT_UNKNOWN && info.unit <= BURIN_UNIT_TIME,
          fmt::format("its unit is {}", info.unit));
  require(is_number(info) || info.unit <= BURIN_UNIT_NONE, "it has a unit though it is no number");
}

void check_types(const burin_param_info& info) {
  require(info.type >= BURIN_PARAM_FLOAT && info.type <= BURIN_PARAM_TEXT,
          fmt::format("its type is {}", info.type));
}

void check_dynamic(const burin_param_info& info) {
  const bool constant =
      info.type == BURIN_PARAM_FILE || info.type == BURIN_PARAM_CURVE || info.type == BURIN_PARAM_TEXT;
  require(info.dynamic <= 1, fmt::format("dynamic is {}", info.dynamic));
  require(!constant || info.dynamic == 0, "it is dynamic, though files, texts and curves cannot vary");
}

void check_knots(const burin_param_info& info) {
  if (info.type != BURIN_PARAM_CURVE) return;
  require(info.default_knots && info.default_knot_count > 0, "a curve without knots");
  for (std::size_t i = 0; i < info.default_knot_count; ++i) {
    const float* knot = info.default_knots + 2 * i;
    require(std::isfinite(knot[0]) && std::isfinite(knot[1]), "a knot is not finite");
    require(i == 0 || knot[0] > knot[-2], "knots whose x does not rise");
  }
}

/// All that a descriptor says, as text.
std::string told(const Brush& brush) {
  std::string text =
      fmt::format("{} {} {} {} {} {:#x} {:#x}", brush.id, brush.name, brush.vendor, brush.version,
                  brush.help ? brush.help : "", brush.inputs_read, brush.outputs_written);
  text += fmt::format(" {}", fmt::join(list_of(brush.features), " "));
  if (BURIN_HAS(&brush, Brush, rim_slope)) text += fmt::format(" {} {}", brush.overlap, brush.rim_slope);
  for (std::uint32_t i = 0; i < brush.param_count; ++i) {
    const burin_param_info& info = *brush.params[i];
    text += fmt::format(" {} {} {} {} {} {} {} {} {}", info.id, info.name, info.type, info.unit,
                        info.hard_min, info.hard_max, info.soft_min, info.soft_max, info.default_number);
    text += fmt::format(" {} {}", info.dynamic, fmt::join(list_of(info.choices), " "));
  }
  return text;
}

void check_same(const Subject& subject) {
  const auto all = [&subject] {
    std::string text;
    const Plugin plugin(subject);
    for (const Brush* brush : plugin.brushes()) text += told(*brush) + "\n";
    return text;
  };
  require(in_process(all) == in_process(all), "two processes are told different descriptors");
}

constexpr Check descriptor_list[] = {
    {"descriptor.ids", 1, "brush.h: id, reverse DNS, unique among all brushes",
     "Reads the ids of all brushes.", check_ids},
    {"descriptor.texts", 2, "brush.h, param.h: ids and texts are UTF-8",
     "Reads all texts, none of them too long to be shown.", check_texts},
    {"descriptor.version", 2, "brush.h: version, \"1.2.0\"", "Looks at the versions of the brushes.",
     check_version},
    {"descriptor.masks", 2, "brush.h: inputs_read, outputs_written: BURIN_INPUT_*, BURIN_OUTPUT_*",
     "Looks for bits that the ABI does not have.", check_masks},
    {"descriptor.features", 2,
     "brush.h: features, never null; those that begin with \"burin.\" are the ABI's", "Reads the features.",
     check_features},
    {"descriptor.overlap", 2, "brush.h: burin_overlap", "Looks at how visits are combined.", check_overlap},
    {"descriptor.param-ids", 1, "param.h: id, [a-z0-9_]+, unique within a brush",
     "Reads the ids of all parameters.", check_param_ids},
    {"descriptor.param-types", 1, "param.h: burin_param_type", "Looks at the types of parameters.",
     [](const Subject& s) { each_param(s, check_types); }},
    {"descriptor.param-ranges", 2, "param.h: the soft range is finite and within the hard range",
     "Compares the ranges of numbers.", [](const Subject& s) { each_param(s, check_ranges); }},
    {"descriptor.param-defaults", 2, "param.h: default_number, within the hard range",
     "Compares the defaults with the ranges.", [](const Subject& s) { each_param(s, check_defaults); }},
    {"descriptor.param-steps", 2, "param.h: INT, BOOL and CHOICE hold whole numbers, |value| <= 2^24",
     "Looks for fractions among defaults and soft ranges.",
     [](const Subject& s) { each_param(s, check_whole); }},
    {"descriptor.param-choices", 2, "param.h: ids of choices are unique within a parameter",
     "Reads the choices.", [](const Subject& s) { each_param(s, check_choices); }},
    {"descriptor.param-units", 2, "param.h: burin_param_unit", "Looks at the units.",
     [](const Subject& s) { each_param(s, check_units); }},
    {"descriptor.param-knots", 2, "param.h: CURVE, knots (x, y), x increasing", "Reads the default curves.",
     [](const Subject& s) { each_param(s, check_knots); }},
    {"descriptor.dynamic", 2, "param.h: FILE, TEXT and CURVE are constant",
     "Looks at which parameters may vary.", [](const Subject& s) { each_param(s, check_dynamic); }},
    {"descriptor.same-in-two-processes", 4,
     "brush.h: a descriptor lives from init to deinit and never changes",
     "Reads the descriptors in two processes.", check_same},
};

}  // namespace

std::span<const Check> descriptor_checks() { return descriptor_list; }

}  // namespace burin::validate
