// Reads recordings of HTML PointerEvents from JSON.
#include <burin/base/text/json_value.h>
#include <burin/stroke/files/pen_events.h>
#include <burin/stroke/files/recording_faults.h>
#include <fmt/format.h>

#include <array>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

namespace burin {
namespace {

constexpr std::array<std::string_view, 18> names = {
    "x",       "y",       "time",  "pressure", "buttons", "tiltX",   "tiltY", "twist",     "pointerId",
    "clientX", "clientY", "pageX", "pageY",    "offsetX", "offsetY", "t",     "timeStamp", "timestamp"};

/// The name that another one of `names` stands for.
std::string_view first_name(std::string_view name) {
  if (name.ends_with("X") && !name.starts_with("tilt")) return "x";
  if (name.ends_with("Y") && !name.starts_with("tilt")) return "y";
  return name == "t" || name == "timeStamp" || name == "timestamp" ? "time" : name;
}

/// The member of an object by the first of its names that it has. Throws FileError that names the first one
/// if it is `needed` and not there.
std::optional<JsonValue> column_of(const JsonValue& root, std::string_view name, bool needed) {
  for (const std::string_view one : names)
    if (first_name(one) == name)
      if (auto found = root.find(std::string(one))) return found;
  return needed ? std::optional(root.member(std::string(name))) : std::nullopt;
}

/// Makes events of arrays of the same length, of which x, y and time are there. Calls `reject` with the fault
/// of one, and leaves the loop.
template <class Reject>
PenEvents events_of(const PointerColumns& columns, const Reject& reject) {
  const auto find = [&](std::string_view name) {
    const auto found = columns.find(name);
    return found == columns.end() ? nullptr : &found->second;
  };
  const std::vector<double>&x = *find("x"), &y = *find("y"), &time = *find("time");
  const std::vector<double>*pressure = find("pressure"), *buttons = find("buttons"), *tilt_x = find("tiltX"),
        *tilt_y = find("tiltY"), *twist = find("twist"), *pointer = find("pointerId");
  const auto radians = [](const std::vector<double>* degrees, std::size_t i) {
    return degrees ? static_cast<float>((*degrees)[i] * std::numbers::pi / 180) : 0;
  };
  PenEvents made;
  made.fields = {.time = true,
                 .pressure = pressure != nullptr,
                 .tilt = tilt_x || tilt_y,
                 .twist = twist != nullptr,
                 .barrel = buttons != nullptr};
  made.events.resize(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    PenEvent& event = made.events[i];
    Sample& sample = event.sample;
    sample.time = time[i] / 1000;
    sample.position = {x[i], y[i], 0};
    if (pressure) sample.pen.pressure = static_cast<float>((*pressure)[i]);
    sample.pen.tilt_x = radians(tilt_x, i);
    sample.pen.tilt_y = radians(tilt_y, i);
    sample.pen.twist = radians(twist, i);
    event.contact = sample.pen.pressure > 0;
    if (buttons) set_buttons(event, (*buttons)[i]);
    if (pointer) event.pointer = (*pointer)[i];
    if (const std::string_view fault = validation_error(sample); !fault.empty()) {
      reject(fmt::format("event {}: {}", i, fault));
      break;
    }
  }
  return made;
}

}  // namespace

PenEvents pointer_events(const std::string& text, const std::filesystem::path& path) {
  const JsonValue root = JsonValue::parse(text, path.string());
  if (!root.is_object()) root.reject("expected an object of arrays x, y, time");
  PointerColumns columns;
  const std::size_t count = column_of(root, "x", true)->numbers().size();
  for (const std::string_view name : names) {
    if (first_name(name) != name) continue;
    const bool needed = name == "x" || name == "y" || name == "time";
    const std::optional<JsonValue> column = column_of(root, name, needed);
    if (!column) continue;
    std::vector<double> values = column->numbers();
    if (values.size() != count) column->reject(fmt::format("has {} values, x has {}", values.size(), count));
    columns.emplace(name, std::move(values));
  }
  return events_of(columns, [&](std::string_view fault) { root.reject(fault); });
}

std::optional<PenEvents> pointer_events(const PointerColumns& columns) {
  if (!columns.contains("x") || !columns.contains("y") || !columns.contains("time")) return std::nullopt;
  const std::size_t count = columns.find("x")->second.size();
  for (const auto& [name, values] : columns)
    if (values.size() != count) return std::nullopt;
  bool good = true;
  PenEvents made = events_of(columns, [&](std::string_view) { good = false; });
  return good ? std::optional(std::move(made)) : std::nullopt;
}

std::span<const std::string_view> pointer_column_names() { return names; }

void use_first_names(PointerColumns& columns) {
  for (const std::string_view name : names) {
    const std::string_view first = first_name(name);
    const auto at = columns.find(name);
    if (first == name || at == columns.end()) continue;
    auto column = columns.extract(at);
    column.key() = first;
    if (!columns.contains(first)) columns.insert(std::move(column));
  }
}

}  // namespace burin
