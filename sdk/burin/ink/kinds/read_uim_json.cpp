// Reads the JSON of the Universal Ink Model 3.0, which says the same as its binary files (read_uim.cpp).
#include <burin/base/error.h>
#include <burin/base/text/json_value.h>
#include <burin/ink/decode/uim_sensors.h>
#include <burin/ink/kinds/kinds.h>
#include <burin/ink/parse/pen_json.h>
#include <burin/ink/parse/scan.h>
#include <burin/ink/pen_file.h>

#include <cmath>
#include <cstdint>
#include <string_view>
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

}  // namespace

bool is_uim_json(std::string_view text) {
  if (!take_character(text, '{')) return false;
  skip_blanks(text);
  return text.starts_with("\"inputData\"");
}

PenFile read_uim_json(const PenFileText& file) {
  const JsonValue input = pen_json(file).member("inputData");
  const UimChannels channels = channels_of(input.member("inputContextData"));
  PenFile content;
  content.unit = "px";
  content.millimetres = millimetres_a_pixel;
  for (const JsonValue& data : items_of(input, "sensorData")) {
    try {
      add_stroke(sensor_data(data), channels, content);
    } catch (const FileError&) {
      throw;
    } catch (const Error& error) {
      data.reject(error.what());
    }
  }
  return content;
}

}  // namespace burin
