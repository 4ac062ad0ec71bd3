// Reads the JSON of the Universal Ink Model 3.0, which says the same as its binary files (read_uim.cpp).
#include <burin/base/error.h>
#include <burin/base/text/json_value.h>
#include <burin/ink/decode/uim_sensors.h>
#include <burin/ink/kinds/kinds.h>
#include <burin/ink/parse/json_parts.h>
#include <burin/ink/parse/pen_json.h>
#include <burin/ink/parse/scan.h>
#include <burin/ink/pen_file.h>

#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>
#include <vector>

namespace burin {
namespace {

/// The items of a list that may be absent.
std::vector<JsonValue> items_of(const JsonValue& value, const char* name) {
  const auto list = value.find(name);
  return list ? list->items() : std::vector<JsonValue>();
}

std::int64_t whole_of(const JsonValue& value) {
  constexpr double most = 0x1p53;
  const double number = value.number();
  if (number != std::floor(number) || std::abs(number) > most) value.reject_type("a whole number");
  return static_cast<std::int64_t>(number);
}

UimChannels channels_of(const JsonValue& contexts) {
  constexpr std::uint64_t most_precision = 15;
  UimChannels channels;
  std::size_t groups = 0;
  for (const JsonValue& context : items_of(contexts, "sensorContexts"))
    for (const JsonValue& group : items_of(context, "sensorChannelsContext")) {
      ++groups;
      for (const JsonValue& one : items_of(group, "channels")) {
        UimChannel channel{.type = one.member("type").text(), .group = groups, .tool = {}};
        if (const auto precision = one.find("precision"))
          channel.precision = static_cast<std::int64_t>(precision->whole(0, most_precision));
        if (const auto resolution = one.find("resolution")) channel.resolution = resolution->number();
        channels[one.member("id").text()] = channel;
      }
    }
  return channels;
}

/// 64-bit numbers are texts in the JSON of Protocol Buffers.
double start_of(const JsonValue& data) {
  const auto stamp = data.find("timestamp");
  if (!stamp) return 0;
  std::int64_t milliseconds = 0;
  if (!stamp->is_text()) return stamp->number() / 1000;
  if (!read_whole(std::string_view(stamp->text()), milliseconds)) stamp->reject_type("whole milliseconds");
  return static_cast<double>(milliseconds) / 1000;
}

UimSensorData sensor_data(const JsonValue& value) {
  UimSensorData data;
  data.start = start_of(value);
  if (const auto state = value.find("state")) data.hovering = state->is_text() && state->text() == "HOVERING";
  for (const JsonValue& channel : items_of(value, "dataChannels")) {
    auto& [id, numbers] = data.numbers.emplace_back();
    id = channel.member("sensorChannelID").text();
    for (const JsonValue& number : items_of(channel, "values")) numbers.push_back(whole_of(number));
  }
  return data;
}

void add_data(const JsonValue& data, const UimChannels& channels, PenFile& content) {
  try {
    add_stroke(sensor_data(data), channels, content);
  } catch (const FileError&) {
    throw;
  } catch (const Error& error) {
    data.reject(error.what());
  }
}

/// The text of a member of an object, which is empty if it has none or more than one. Others must be JSON.
std::string_view only_member(std::string_view json, std::string_view name) {
  std::string_view found;
  const auto take = [&](std::string_view member, std::string_view part) {
    if (member != name) return nlohmann::json::accept(part);
    return std::exchange(found, part).empty();
  };
  return for_each_json_part(json, take) ? found : std::string_view();
}

/// Reads the data of one sensor after the other. Returns false for what must be read as a whole.
bool read_by_sensors(const PenFileText& file, PenFile& content) {
  const std::string_view input = only_member(file.text, "inputData");
  const std::string_view contexts = only_member(input, "inputContextData"),
                         all_data = only_member(input, "sensorData");
  if (contexts.empty() || all_data.empty()) return false;
  const UimChannels channels = channels_of(pen_json_part(file, contexts));
  return for_each_json_part(all_data, [&](std::string_view, std::string_view data) {
    add_data(pen_json_part(file, data), channels, content);
    return true;
  });
}

}  // namespace

bool is_uim_json(std::string_view text) {
  if (!take_character(text, '{')) return false;
  skip_blanks(text);
  return text.starts_with("\"inputData\"");
}

PenFile read_uim_json(const PenFileText& file) {
  auto content = pen_file_by_parts([&](PenFile& to) { return read_by_sensors(file, to); });
  if (!content) {
    const JsonValue input = pen_json(file).member("inputData");
    const UimChannels channels = channels_of(input.member("inputContextData"));
    content.emplace();
    for (const JsonValue& data : items_of(input, "sensorData")) add_data(data, channels, *content);
  }
  content->unit = "px";
  content->millimetres = millimetres_a_pixel;
  return std::move(*content);
}

}  // namespace burin
