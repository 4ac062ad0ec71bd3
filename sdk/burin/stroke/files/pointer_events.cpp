// Reads recordings of HTML PointerEvents from JSON.
#include <burin/base/text/json_value.h>
#include <burin/stroke/files/pen_events.h>
#include <burin/stroke/files/recording_faults.h>
#include <fmt/format.h>

#include <numbers>
#include <utility>

namespace burin {
namespace {

/// The arrays of one file.
class PointerEvents {
 public:
  explicit PointerEvents(JsonValue root) : root_(std::move(root)) {
    if (!root_.is_object()) root_.reject("expected an object of arrays x, y, time");
  }

  PenFields fields() const;
  std::vector<PenEvent> events() const;

 private:
  /// The array of this name, which must be as long as x, or an empty one if the file does not have it.
  std::vector<double> optional_column(const char* name) const;
  std::vector<double> column(const char* name) const;

  JsonValue root_;
};

PenFields PointerEvents::fields() const {
  const auto has = [&](const char* name) { return root_.find(name).has_value(); };
  return {
      .time = true, .pressure = has("pressure"), .tilt = has("tiltX") || has("tiltY"), .twist = has("twist")};
}

std::vector<double> PointerEvents::column(const char* name) const {
  const JsonValue column = root_.member(name), x = root_.member("x");
  std::vector<double> values = column.numbers();
  if (values.size() != x.size())
    column.reject(fmt::format("has {} values, x has {}", values.size(), x.size()));
  return values;
}

std::vector<double> PointerEvents::optional_column(const char* name) const {
  return root_.find(name) ? column(name) : std::vector<double>();
}

std::vector<PenEvent> PointerEvents::events() const {
  const std::vector<double> x = column("x"), y = column("y"), time = column("time");
  const std::vector<double> pressure = optional_column("pressure"), buttons = optional_column("buttons"),
                            tilt_x = optional_column("tiltX"), tilt_y = optional_column("tiltY"),
                            twist = optional_column("twist"), pointer = optional_column("pointerId");
  const auto radians = [](const std::vector<double>& degrees, std::size_t i) {
    return degrees.empty() ? 0 : static_cast<float>(degrees[i] * std::numbers::pi / 180);
  };
  std::vector<PenEvent> events(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    Sample& sample = events[i].sample;
    sample.time = time[i] / 1000;
    sample.position = {x[i], y[i], 0};
    if (!pressure.empty()) sample.pen.pressure = static_cast<float>(pressure[i]);
    sample.pen.tilt_x = radians(tilt_x, i);
    sample.pen.tilt_y = radians(tilt_y, i);
    sample.pen.twist = radians(twist, i);
    events[i].contact = buttons.empty() ? sample.pen.pressure > 0 : buttons[i] != 0;
    if (!pointer.empty()) events[i].pointer = pointer[i];
    if (const std::string_view fault = validation_error(sample); !fault.empty())
      root_.reject(fmt::format("event {}: {}", i, fault));
  }
  return events;
}

}  // namespace

PenEvents pointer_events(const std::string& text, const std::filesystem::path& path) {
  const PointerEvents file(JsonValue::parse(text, path.string()));
  return {file.events(), file.fields()};
}

}  // namespace burin
