// Chooses the parameters, the surface and the stroke of a trial by its number.
#include "fuzz/fuzz_case.h"

#include <burin/math/elementary.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <string>
#include <string_view>

#include "fuzz/draws.h"
#include "validate/probe/plugin.h"
#include "validate/probe/values.h"

namespace burin {
namespace {

/// A number in the range of a parameter, often one of its ends.
double random_number(const burin_param_info& info, Draws& draws) {
  const double low = validate::least_of(info), high = validate::greatest_of(info);
  if (draws.once_in(4)) return draws.one_of({low, high});
  const double value = draws.between(low, high);
  return info.type == BURIN_PARAM_INT ? std::clamp(std::round(value), low, high) : value;
}

Json random_knots(Draws& draws) {
  Json knots = Json::array();
  double x = draws.between(-0.5, 0.5);
  for (std::size_t left = 1 + draws.below(4); left > 0; --left) {
    knots.insert(knots.end(), {x, draws.between(-1, 2)});
    x += draws.between(0.01, 0.6);
  }
  return knots;
}

/// One of the words that the brush takes, now and then one that it may refuse.
std::string random_word(burin_param_type type, const std::vector<std::string>* taken, Draws& draws) {
  const std::vector<std::string> all = fuzz_words(type);
  const auto& from = taken && !draws.once_in(10) ? *taken : all;
  return from[draws.below(from.size())];
}

Json random_value(const burin_param_info& info, const std::vector<std::string>* taken, Draws& draws) {
  switch (info.type) {
    case BURIN_PARAM_FLOAT:
    case BURIN_PARAM_INT:
      return random_number(info, draws);
    case BURIN_PARAM_BOOL:
      return draws.once_in(2);
    case BURIN_PARAM_CHOICE: {
      const auto choices = validate::list_of(info.choices);
      return choices[draws.below(choices.size())];
    }
    case BURIN_PARAM_COLOUR:
      return {draws.between(0, 1), draws.between(0, 1), draws.between(0, 1), draws.between(0, 1)};
    case BURIN_PARAM_CURVE:
      return random_knots(draws);
    default:
      return random_word(info.type, taken, draws);
  }
}

Json random_params(const burin_brush_descriptor& brush, const TakenWords& words, Draws& draws) {
  Json params = Json::object();
  for (const burin_param_info* info : std::span(brush.params, brush.param_count)) {
    const bool needed = info->type == BURIN_PARAM_FILE && !info->default_file;
    const auto taken = words.find({brush.id, info->id});
    const bool refused = info->type == BURIN_PARAM_TEXT && taken == words.end();
    if (!needed && !draws.once_in(refused ? 12 : 2)) continue;
    params[info->id] = random_value(*info, taken == words.end() ? nullptr : &taken->second, draws);
  }
  return params;
}

Json random_dynamics(const burin_brush_descriptor& brush, Draws& draws) {
  Json dynamics = Json::array();
  const auto vary = [&](std::string_view target) {
    const char* source = draws.one_of({"pressure", "tilt", "direction", "speed", "time", "t", "random"});
    dynamics.push_back({{"target", target},
                        {"source", source},
                        {"curve", {0, draws.between(0, 1), 1 + draws.between(0, 4), draws.between(0, 1)}}});
  };
  for (const char* target : {"radius", "strength"})
    if (draws.once_in(8)) vary(target);
  for (const burin_param_info* info : std::span(brush.params, brush.param_count))
    if (info->dynamic && draws.once_in(4)) vary(info->id);
  return dynamics;
}

/// Settings besides brush, radius and parameters; most cases have few.
void add_settings(Json& settings, Draws& draws) {
  if (draws.once_in(3)) settings["strength"] = draws.between(-1, 1.5);
  if (draws.once_in(4)) settings["follow"] = draws.one_of({0.5, 1.0});
  if (draws.once_in(4)) settings["pressure_width"] = draws.between(0, 1);
  if (draws.once_in(4)) settings["closed"] = draws.one_of({"yes", "auto"});
  if (draws.once_in(4)) settings["cap"] = "butt";
  if (draws.once_in(8)) settings["join"] = draws.one_of({"smooth", "miter", "overlap"});
  if (draws.once_in(8))
    settings["overlap"] = draws.one_of({"strongest", "latest", "max", "min", "add", "average"});
  if (draws.once_in(8)) settings["clamp"] = true;
  if (draws.once_in(8)) settings["dabs"] = draws.between(0.1, 2);
  if (draws.once_in(8)) settings["accumulate"] = "current";
  if (draws.once_in(8)) settings["mirror"] = draws.one_of({"x", "y", "xy"});
  if (draws.once_in(12)) settings["radial"] = 2 + draws.below(3);
  if (draws.once_in(12)) settings["stabilise"] = draws.one_of({"string:0.05", "exponential:0.02"});
  if (draws.once_in(2)) settings["show_every"] = 1 + draws.below(5);
}

FuzzSurface random_surface(Draws& draws) {
  using Shape = FuzzSurface::Shape;
  FuzzSurface surface{.shape = draws.one_of({Shape::sheet, Shape::sheet, Shape::tube, Shape::ball}),
                      .columns = static_cast<Index>(4 + draws.below(28)),
                      .rows = static_cast<Index>(4 + draws.below(28)),
                      .seed = draws.bits()};
  if (draws.once_in(2)) surface.relief = draws.between(0, 0.2);
  if (draws.once_in(6)) surface.holes = draws.between(0, 0.1);
  return surface;
}

/// The pen wanders over the surface and may leave it; some strokes rest, some are a single sample.
RecordedStroke random_stroke(const FuzzSurface& surface, Draws& draws) {
  RecordedStroke stroke;
  stroke.fields = {.time = true, .pressure = !draws.once_in(3), .tilt = draws.once_in(4)};
  const std::size_t samples = draws.once_in(6) ? 1 + draws.below(2) : 3 + draws.below(38);
  const double step = draws.between(0.01, 0.12), bend = draws.between(0, 1);
  double u = draws.between(-0.9, 0.9), v = draws.between(-0.9, 0.9), time = 0;
  double heading = draws.between(0, 2 * std::numbers::pi);
  for (std::size_t i = 0; i < samples; ++i) {
    Sample sample{time, surface_point(surface, u, v), {}};
    if (stroke.fields.pressure) sample.pen.pressure = static_cast<float>(draws.between(0, 1));
    if (stroke.fields.tilt) {
      sample.pen.tilt_x = static_cast<float>(draws.between(-1, 1));
      sample.pen.tilt_y = static_cast<float>(draws.between(-1, 1));
    }
    stroke.samples.push_back(sample);
    time += draws.between(0.002, 0.02);
    if (draws.once_in(12)) continue;
    heading += draws.between(-bend, bend);
    u += step * math::cos(heading);
    v += step * math::sin(heading);
  }
  return stroke;
}

}  // namespace

std::vector<std::string> fuzz_words(burin_param_type type) {
  if (type == BURIN_PARAM_FILE) return {fuzz_files.begin(), fuzz_files.end()};
  if (type == BURIN_PARAM_TEXT)
    return {"", "A", "two words", "\u00df \u6f22\u5b57 \u05d0", std::string(200, 'W')};
  return {};
}

FuzzCase random_case(const burin_brush_descriptor& brush, const TakenWords& words, std::uint64_t seed) {
  Draws draws(seed);
  FuzzCase made;
  made.surface = random_surface(draws);
  made.trial.mesh = surface_mesh(made.surface);
  made.trial.stroke = random_stroke(made.surface, draws);
  Json& settings = made.trial.settings;
  const double radius = draws.between(0.05, 0.5);
  // Coarse voxels, so that solids are made in no time.
  settings = {{"brush", brush.id}, {"radius", radius}, {"voxel", radius / draws.between(4, 8)}};
  if (Json params = random_params(brush, words, draws); !params.empty())
    settings["params"] = std::move(params);
  if (Json dynamics = random_dynamics(brush, draws); !dynamics.empty())
    settings["dynamics"] = std::move(dynamics);
  add_settings(settings, draws);
  return made;
}

}  // namespace burin
