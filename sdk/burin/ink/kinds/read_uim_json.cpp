// Reads the JSON of the Universal Ink Model 3.0, which says the same as its binary files (read_uim.cpp).
#include <burin/base/error.h>
#include <burin/base/text/json_value.h>
#include <burin/base/text/lower_case.h>
#include <burin/ink/decode/uim_sensors.h>
#include <burin/ink/kinds/kinds.h>
#include <burin/ink/parse/json_parts.h>
#include <burin/ink/parse/pen_json.h>
#include <burin/ink/parse/scan.h>
#include <burin/ink/pen_file.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
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

/// Up to here doubles have all whole numbers.
constexpr double most_whole = 0x1p53;

std::int64_t whole_of(const JsonValue& value) {
  const double number = value.number();
  if (number != std::floor(number) || std::abs(number) > most_whole) value.reject_type("a whole number");
  return static_cast<std::int64_t>(number);
}

using Tools = std::map<std::string, std::string_view>;

/// The tools of providers of input by their ids. A type that is left out is the first one.
Tools tools_of(const JsonValue& contexts) {
  constexpr std::array<std::string_view, 4> types = {"pen", "touch", "mouse", "controller"};
  Tools tools;
  for (const JsonValue& provider : items_of(contexts, "inkInputProviders")) {
    const auto id = provider.find("id"), type = provider.find("type");
    if (!id || !id->is_text()) continue;
    const std::string told = type && type->is_text() ? in_lower_case(type->text()) : std::string(types[0]);
    const auto found = std::ranges::find(types, told);
    if (found != types.end()) tools[id->text()] = *found;
  }
  return tools;
}

/// The tool of channels that are measured together; empty if the file does not tell.
std::string_view tool_of(const JsonValue& group, const Tools& tools) {
  const auto provider = group.find("inkInputProviderID");
  const auto found = provider && provider->is_text() ? tools.find(provider->text()) : tools.end();
  return found == tools.end() ? std::string_view() : found->second;
}

UimChannels channels_of(const JsonValue& contexts) {
  constexpr std::uint64_t most_precision = 15;
  const Tools tools = tools_of(contexts);
  UimChannels channels;
  std::size_t groups = 0;
  for (const JsonValue& context : items_of(contexts, "sensorContexts"))
    for (const JsonValue& group : items_of(context, "sensorChannelsContext")) {
      ++groups;
      for (const JsonValue& one : items_of(group, "channels")) {
        UimChannel channel{.type = one.member("type").text(), .group = groups, .tool = tool_of(group, tools)};
        if (const auto precision = one.find("precision"))
          channel.precision = static_cast<std::int64_t>(precision->whole(0, most_precision));
        if (const auto resolution = one.find("resolution")) channel.resolution = resolution->number();
        if (const auto most = one.find("max")) channel.most = most->number();
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

/// The channel that a text is, read without a tree of JSON values. Returns false if it is anything else.
bool append_channel(std::string_view json, UimSensorData& data) {
  std::vector<double> values;
  std::string id;
  const bool whole = for_each_json_part(json, [&](std::string_view name, std::string_view part) {
    if (name == "values") return values.empty() && append_numbers(part, values);
    if (name == "sensorChannelID" && part.size() > 2 && part.find('\\') == part.npos)
      id = part.substr(1, part.size() - 2);
    return nlohmann::json::accept(part);
  });
  auto& numbers = data.numbers.emplace_back(id, std::vector<std::int64_t>()).second;
  for (const double value : values) {
    if (value != std::floor(value) || std::abs(value) > most_whole) return false;
    numbers.push_back(static_cast<std::int64_t>(value));
  }
  return whole && !id.empty();
}

/// The same as sensor_data() in a fraction of the time; nothing of a fault.
std::optional<UimSensorData> plain_sensor_data(std::string_view json) {
  UimSensorData data;
  const bool whole = for_each_json_part(json, [&](std::string_view name, std::string_view part) {
    if (name == "dataChannels")
      return for_each_json_part(
          part, [&](std::string_view, std::string_view channel) { return append_channel(channel, data); });
    if (name == "state") data.hovering = part == R"("HOVERING")";
    std::string_view digits = part;
    std::int64_t milliseconds = 0;
    if (name == "timestamp" && take_character(digits, '"')) {
      if (!take_whole(digits, milliseconds) || digits != "\"") return false;
      data.start = static_cast<double>(milliseconds) / 1000;
    } else if (name == "timestamp") {
      return false;
    }
    return nlohmann::json::accept(part);
  });
  return whole ? std::optional(std::move(data)) : std::nullopt;
}

/// Returns false for data with a fault.
bool add_plain(const UimSensorData& data, const UimChannels& channels, PenFile& content) {
  try {
    add_stroke(data, channels, content);
  } catch (const Error&) {
    return false;
  }
  return true;
}

/// Reads the data of one sensor after the other, which stands behind that of the channels. Returns false for
/// what must be read as a whole.
bool read_by_sensors(const PenFileText& file, TextWindow& text, PenFile& content) {
  std::optional<UimChannels> channels;
  bool has_data = false;
  const auto take_data = [&](std::string_view, TextWindow& json) {
    const std::string_view part = take_json_value(json);
    if (const auto plain = plain_sensor_data(part)) return add_plain(*plain, *channels, content);
    add_data(pen_json_part(file, part), *channels, content);
    return true;
  };
  const auto take_input = [&](std::string_view name, TextWindow& json) {
    if (name == "sensorData")
      return channels && !std::exchange(has_data, true) && for_each_json_part(json, take_data);
    const std::string_view part = take_json_value(json);
    if (name != "inputContextData") return nlohmann::json::accept(part);
    if (channels) return false;
    channels = channels_of(pen_json_part(file, part));
    return true;
  };
  int inputs = 0;
  const bool whole = for_each_json_part(text, [&](std::string_view name, TextWindow& json) {
    if (name != "inputData") return nlohmann::json::accept(take_json_value(json));
    return ++inputs == 1 && for_each_json_part(json, take_input);
  });
  return whole && has_data;
}

}  // namespace

bool is_uim_json(std::string_view text) {
  if (!take_character(text, '{')) return false;
  skip_blanks(text);
  return text.starts_with("\"inputData\"");
}

PenFile read_uim_json(const PenFileText& file) {
  auto content =
      pen_file_by_parts(file, [&](TextWindow& text, PenFile& to) { return read_by_sensors(file, text, to); });
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
