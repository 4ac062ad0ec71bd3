// Reads recordings of HTML PointerEvents from JSON.
#include <burin/base/error.h>
#include <burin/base/file.h>
#include <burin/stroke/files/import.h>
#include <burin/stroke/files/pen_events.h>
#include <burin/stroke/files/recording_faults.h>
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numbers>

namespace burin {
namespace {

using Json = nlohmann::json;

/// A limit below that of other files, since the JSON library needs about twenty times the memory of the text.
constexpr std::uintmax_t most_json_bytes = std::uintmax_t{1} << 26;

/// The arrays of one file.
class PointerEvents {
 public:
  explicit PointerEvents(const std::filesystem::path& path);

  PenFields fields() const;
  std::vector<PenEvent> events() const;

 private:
  /// The array of this name, which must be as long as x, or an empty one if the file does not have it.
  std::vector<double> optional_column(const char* name) const;
  std::vector<double> column(const char* name) const;
  [[noreturn]] void reject(std::string_view place, std::string_view what) const {
    throw FileError(path_, place, what);
  }

  std::string path_;
  Json root_;
};

PointerEvents::PointerEvents(const std::filesystem::path& path) : path_(path.string()) {
  const std::string text = read_file(path, most_json_bytes);
  try {
    root_ = Json::parse(text);
  } catch (const Json::parse_error& error) {
    const auto stop = text.begin() + static_cast<std::ptrdiff_t>(std::min(error.byte, text.size()));
    reject(std::to_string(1 + std::count(text.begin(), stop, '\n')), "malformed JSON");
  } catch (const Json::out_of_range&) {
    throw FileError(path_, "a number is too large");
  }
  if (!root_.is_object()) throw FileError(path_, "expected an object of arrays x, y, time");
}

PenFields PointerEvents::fields() const {
  return {.time = true,
          .pressure = root_.contains("pressure"),
          .tilt = root_.contains("tiltX") || root_.contains("tiltY"),
          .twist = root_.contains("twist")};
}

std::vector<double> PointerEvents::column(const char* name) const {
  const auto found = root_.find(name);
  if (found == root_.end() || !found->is_array()) reject(name, "expected an array of numbers");
  if (found->size() != root_.at("x").size())
    reject(name, fmt::format("has {} values, x has {}", found->size(), root_.at("x").size()));
  std::vector<double> values;
  for (const Json& value : *found) {
    if (!value.is_number()) reject(fmt::format("{}[{}]", name, values.size()), "expected a number");
    values.push_back(value.get<double>());
  }
  return values;
}

std::vector<double> PointerEvents::optional_column(const char* name) const {
  return root_.contains(name) ? column(name) : std::vector<double>();
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
    if (const std::string_view fault = fault_of(sample); !fault.empty())
      reject(fmt::format("event {}", i), fault);
  }
  return events;
}

}  // namespace

Import import_pointer_events(const std::filesystem::path& path, const Camera& camera) {
  const PointerEvents file(path);
  return import_of(path, file.events(), file.fields(), camera);
}

}  // namespace burin
