// Describes what a pen file holds: strokes, samples, fields and their ranges.
#include "recordings/facts_report.h"

#include <burin/ink/pen_file_facts.h>
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <numbers>

namespace burin::command {
namespace {

Json json_of(const std::optional<ValueRange>& range) {
  if (!range) return nullptr;
  return {range->least, range->most};
}

std::string position_text(const PenFileFacts& facts, const std::string& unit) {
  return fmt::format("  x {:.6g} to {:.6g}, y {:.6g} to {:.6g} {}{}\n", facts.x->least, facts.x->most,
                     facts.y->least, facts.y->most, unit.empty() ? "of an unknown unit" : unit,
                     facts.estimated_y > 0
                         ? fmt::format("; y of {} strokes beside typed text is estimated, since the file "
                                       "does not tell the heights of its lines",
                                       facts.estimated_y)
                         : "");
}

std::string time_text(const PenFileFacts& facts) {
  if (!facts.interval) return "  no time\n";
  constexpr double ms = 1000;
  return fmt::format(
      "  {:.3f} s of ink at {:.1f} Hz: every {:.1f} ms ({:.1f} to {:.1f}), jitter {:.1f} ms; {} gaps, {} "
      "equal stamps, {} that fall\n",
      facts.ink_seconds, facts.rate, ms * facts.median_interval, ms * facts.interval->least,
      ms * facts.interval->most, ms * facts.jitter, facts.gaps, facts.equal_stamps, facts.falling_times);
}

std::string pressure_text(const PenFileFacts& facts) {
  if (!facts.pressure) return "  no pressure\n";
  return fmt::format(
      "  pressure {:.3f} to {:.3f}, 0 in contact at {} samples{}\n", facts.pressure->least,
      facts.pressure->most, facts.without_pressure,
      facts.made_pressure > 0 ? fmt::format("; made by the program in {} strokes", facts.made_pressure) : "");
}

std::string tilt_text(const PenFileFacts& facts) {
  if (!facts.tilt_x || !facts.tilt_y) return "  no tilt\n";
  constexpr double degrees = 180 / std::numbers::pi;
  return fmt::format("  tilt {:.1f} to {:.1f} degrees in x, {:.1f} to {:.1f} in y\n",
                     degrees * facts.tilt_x->least, degrees * facts.tilt_x->most,
                     degrees * facts.tilt_y->least, degrees * facts.tilt_y->most);
}

}  // namespace

Json facts_json(const std::string& path, const PenFile& file) {
  const PenFileFacts facts = facts_of(file);
  Json json = {{"file", path},
               {"kind", file.kind},
               {"device", file.device},
               {"unit", file.unit},
               {"strokes", facts.strokes},
               {"samples", facts.samples},
               {"pages", facts.pages},
               {"layers", facts.layers},
               {"hovering", file.hovering},
               {"not_used", file.not_used},
               {"samples_per_stroke", {facts.shortest, facts.median_length, facts.longest}},
               {"duplicates", facts.duplicates},
               {"x", json_of(facts.x)},
               {"y", json_of(facts.y)},
               {"pressure", json_of(facts.pressure)},
               {"pressure_made_strokes", facts.made_pressure},
               {"y_estimated_strokes", facts.estimated_y},
               {"contact_without_pressure", facts.without_pressure},
               {"tilt_x_rad", json_of(facts.tilt_x)},
               {"tilt_y_rad", json_of(facts.tilt_y)},
               {"time", nullptr}};
  if (facts.interval)
    json["time"] = {{"ink_seconds", facts.ink_seconds},
                    {"rate_hz", facts.rate},
                    {"interval_s", json_of(facts.interval)},
                    {"median_interval_s", facts.median_interval},
                    {"jitter_s", facts.jitter},
                    {"gaps", facts.gaps},
                    {"equal_stamps", facts.equal_stamps},
                    {"falling_times", facts.falling_times}};
  return json;
}

std::string facts_text(const std::string& path, const PenFile& file) {
  const PenFileFacts facts = facts_of(file);
  std::string text = fmt::format(
      "{}: {}, {} strokes, {} samples ({} to {} each) on {} pages, {} layers; {} hovering left out, {} at "
      "the place of the one before\n",
      path, file.kind, facts.strokes, facts.samples, facts.shortest, facts.longest, facts.pages, facts.layers,
      file.hovering, facts.duplicates);
  if (facts.samples > 0)
    text += position_text(facts, file.unit) + time_text(facts) + pressure_text(facts) + tilt_text(facts);
  return file.not_used.empty()
             ? text
             : text + fmt::format("  not used: {}{}\n", file.kind == "csv" ? "the columns " : "",
                                  fmt::join(file.not_used, ", "));
}

}  // namespace burin::command
