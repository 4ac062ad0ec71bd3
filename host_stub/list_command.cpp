// The command `burin list`: prints the brushes and their parameters as text or as JSON.
#include <burin/abi/plugin.h>
#include <burin/deform/overlap.h>
#include <burin/host/brush_library.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "command.h"
#include "input/brush_folder.h"
#include "options/options.h"
#include "system/console.h"
#include "validate/badge.h"

namespace burin::command {
namespace {

const char* type_name(burin_param_type type) {
  switch (type) {
    case BURIN_PARAM_FLOAT:
      return "float";
    case BURIN_PARAM_INT:
      return "int";
    case BURIN_PARAM_BOOL:
      return "bool";
    case BURIN_PARAM_CHOICE:
      return "choice";
    case BURIN_PARAM_COLOUR:
      return "colour";
    case BURIN_PARAM_FILE:
      return "file";
    case BURIN_PARAM_TEXT:
      return "text";
    case BURIN_PARAM_CURVE:
      return "curve";
    default:
      return "unknown";
  }
}

const char* unit_name(burin_param_unit unit) {
  switch (unit) {
    case BURIN_UNIT_RADIUS:
      return "radius";
    case BURIN_UNIT_LENGTH:
      return "length";
    case BURIN_UNIT_ANGLE:
      return "radians";
    case BURIN_UNIT_TIME:
      return "seconds";
    default:
      return "";
  }
}

std::string text_or_empty(const char* text) { return text ? text : ""; }

/// The shortest decimal number that is this float: 0.3, where a conversion to double has 0.30000001192092896.
double shortest(float value) { return parse_number(fmt::format("{}", value)).value_or(double{value}); }

Json shortest_json(std::span<const float> values) {
  Json json = Json::array();
  for (const float value : values) json.push_back(shortest(value));
  return json;
}

/// A bound of a range; null if it is infinite, which JSON cannot express.
Json bound(float value) { return std::isfinite(value) ? Json(shortest(value)) : Json(); }

Json choices_json(const burin_param_info& param) {
  Json choices = Json::array();
  for (const char* const* choice = param.choices; choice && *choice; ++choice) choices.push_back(*choice);
  return choices;
}

Json default_json(const burin_param_info& param) {
  switch (param.type) {
    case BURIN_PARAM_BOOL:
      return param.default_number != 0;
    case BURIN_PARAM_CHOICE:
      return param.choices[static_cast<int>(param.default_number)];
    case BURIN_PARAM_COLOUR:
      return shortest_json(param.default_colour);
    case BURIN_PARAM_FILE:
      return param.default_file ? Json(param.default_file) : Json();
    case BURIN_PARAM_TEXT:
      return BURIN_HAS(&param, burin_param_info, default_text) ? text_or_empty(param.default_text) : "";
    case BURIN_PARAM_CURVE:
      return shortest_json({param.default_knots, 2 * std::size_t{param.default_knot_count}});
    default:
      return shortest(param.default_number);
  }
}

Json param_json(const burin_param_info& param) {
  Json json = {{"id", param.id},
               {"name", param.name},
               {"type", type_name(param.type)},
               {"unit", unit_name(param.unit)},
               {"default", default_json(param)},
               {"dynamic", param.dynamic != 0},
               {"help", text_or_empty(param.help)}};
  if (param.type == BURIN_PARAM_FLOAT || param.type == BURIN_PARAM_INT) {
    json["range"] = {bound(param.hard_min), bound(param.hard_max)};
    json["soft_range"] = {bound(param.soft_min), bound(param.soft_max)};
  }
  if (param.type == BURIN_PARAM_CHOICE) json["choices"] = choices_json(param);
  return json;
}

Json brush_json(const BrushEntry& entry) {
  const burin_brush_descriptor& brush = *entry.descriptor;
  Json params = Json::array();
  for (std::uint32_t i = 0; i < brush.param_count; ++i) params.push_back(param_json(*brush.params[i]));
  const auto validated = validate::badge_level(entry.module);
  return {{"id", brush.id},
          {"name", brush.name},
          {"vendor", text_or_empty(brush.vendor)},
          {"version", text_or_empty(brush.version)},
          {"help", text_or_empty(brush.help)},
          {"overlap", name_of(named_overlaps, overlap_of(brush))},
          {"module", entry.module.string()},
          {"validated", validated ? Json(*validated) : Json()},
          {"params", params}};
}

/// The range of a parameter, "0 .. 1 radius", or its choices; empty for other types.
std::string range_text(const burin_param_info& param) {
  if (param.type == BURIN_PARAM_CHOICE) return choices_json(param).dump();
  if (param.type != BURIN_PARAM_FLOAT && param.type != BURIN_PARAM_INT) return "";
  const std::string unit = unit_name(param.unit);
  return fmt::format("{:g} .. {:g}{}{}", param.hard_min, param.hard_max, unit.empty() ? "" : " ", unit);
}

void print_brush(const BrushEntry& entry) {
  const burin_brush_descriptor& brush = *entry.descriptor;
  write_result(fmt::format("{}  {} {}\n  {}\n", brush.id, brush.name, text_or_empty(brush.version),
                           entry.module.string()));
  if (brush.help) write_result(fmt::format("  {}\n", brush.help));
  if (const auto level = validate::badge_level(entry.module))
    write_result(fmt::format("  validated: level {}\n", *level));
  write_result(fmt::format("  overlap: {}\n", name_of(named_overlaps, overlap_of(brush))));
  for (std::uint32_t i = 0; i < brush.param_count; ++i) {
    const burin_param_info& param = *brush.params[i];
    write_result(fmt::format("    {:<16} {:<7} {:<24} default {:<10} {:<8}{}\n", param.id,
                             type_name(param.type), range_text(param), default_json(param).dump(),
                             param.dynamic ? "dynamic" : "", text_or_empty(param.help)));
  }
}

struct ListOptions {
  std::string brush;  ///< empty: all
  bool isolate = false, json = false;
};

std::span<const BrushEntry> load_listed(BrushLibrary& library, const std::string& brush) {
  if (!brush.empty()) return load_named_brushes(library, brush);
  load_brushes(library);
  return library.brushes();
}

void run(const ListOptions& options) {
  BrushLibrary library = brush_library(options.isolate);
  const std::span<const BrushEntry> listed = load_listed(library, options.brush);
  if (!options.json) {
    for (const BrushEntry& entry : listed) print_brush(entry);
    return;
  }
  Json brushes = Json::array();
  for (const BrushEntry& entry : listed) brushes.push_back(brush_json(entry));
  write_result(json_text({{"brushes", brushes}}));
}

}  // namespace

void add_list(CLI::App& app) {
  const auto options = std::make_shared<ListOptions>();
  CLI::App& command = *app.add_subcommand("list", "list the brushes and their parameters");
  command.add_option("brush", options->brush, std::string(named_brushes_help) + "; all unless given")
      ->type_name("BRUSH");
  command.add_flag("--isolate", options->isolate,
                   "load modules in a process of their own: one that crashes or hangs is passed over");
  command.add_flag("--json", options->json, "write JSON to the standard output");
  command.callback([options] { run(*options); });
}

}  // namespace burin::command
