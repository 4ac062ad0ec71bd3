// Reads the Universal Ink Model of Wacom, 3.0 and 3.1: RIFF around messages of Protocol Buffers. Strokes are
// what the sensors measured, never the splines that the program made of it. In 3.0 one chunk DATA holds the
// model, whose field 1 is the input data; in 3.1 that is the chunk INPT.
#include <burin/base/error.h>
#include <burin/base/text/quoted_word.h>
#include <burin/ink/decode/uim_sensors.h>
#include <burin/ink/kinds/kinds.h>
#include <burin/ink/parse/protobuf.h>
#include <burin/ink/parse/riff.h>
#include <burin/ink/pen_file.h>
#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>

namespace burin {
namespace {

template <class Take>
void for_each_field(ByteReader message, const Take& take) {
  while (!message.empty()) take(next_field(message));
}

/// What the file tells of its sensors.
struct Sensors {
  UimChannels channels;
  std::map<std::string, std::string_view, std::less<>> tool_of_provider;
  std::size_t groups = 0;
};

std::string text_of(const ProtobufField& field) { return std::string(field.content.bytes()); }

void read_provider(const ByteReader& message, Sensors& sensors) {
  constexpr std::array<std::string_view, 4> tools = {"pen", "touch", "mouse", "controller"};
  std::string id;
  std::uint64_t type = 0;
  for_each_field(message, [&](const ProtobufField& field) {
    if (field.number == 1) id = text_of(field);
    if (field.number == 2) type = field.value;
  });
  sensors.tool_of_provider[id] = type < tools.size() ? tools[type] : std::string_view();
}

void read_channel(const ByteReader& message, std::size_t group, Sensors& sensors) {
  std::string id;
  UimChannel channel;
  channel.group = group;
  for_each_field(message, [&](const ProtobufField& field) {
    if (field.number == 1) id = text_of(field);
    if (field.number == 2) channel.type = text_of(field);
    if (field.number == 4) channel.resolution = field.as_double();
    if (field.number == 6) channel.most = double{field.as_float()};
    if (field.number == 7) channel.precision = static_cast<std::int64_t>(field.value);
  });
  sensors.channels[id] = channel;
}

/// Channels that are measured together, by one device.
void read_group(const ByteReader& message, Sensors& sensors) {
  const std::size_t group = ++sensors.groups;
  std::string provider;
  for_each_field(message, [&](const ProtobufField& field) {
    if (field.number == 2) read_channel(field.content, group, sensors);
    if (field.number == 5) provider = text_of(field);
  });
  const auto tool = sensors.tool_of_provider.find(provider);
  if (tool == sensors.tool_of_provider.end()) return;
  for (auto& [id, channel] : sensors.channels)
    if (channel.group == group) channel.tool = tool->second;
}

void read_contexts(const ByteReader& message, Sensors& sensors) {
  for_each_field(message, [&](const ProtobufField& field) {
    if (field.number == 2) read_provider(field.content, sensors);
  });
  for_each_field(message, [&](const ProtobufField& field) {
    if (field.number != 5) return;
    for_each_field(field.content, [&](const ProtobufField& of_context) {
      if (of_context.number == 2) read_group(of_context.content, sensors);
    });
  });
}

void read_numbers(const ByteReader& message, UimSensorData& data) {
  auto& [id, numbers] = data.numbers.emplace_back();
  for_each_field(message, [&, &to_id = id, &to_numbers = numbers](const ProtobufField& field) {
    if (field.number == 1) to_id = text_of(field);
    if (field.number == 2) field.append_signed(to_numbers);
  });
}

UimSensorData sensor_data(const ByteReader& message) {
  UimSensorData data;
  for_each_field(message, [&](const ProtobufField& field) {
    if (field.number == 3) data.hovering = field.value == 1;
    if (field.number == 4) data.start = static_cast<double>(field.value) / 1000;
    if (field.number == 5) read_numbers(field.content, data);
  });
  return data;
}

void read_input(const ByteReader& message, PenFile& content) {
  Sensors sensors;
  for_each_field(message, [&](const ProtobufField& field) {
    if (field.number == 1) read_contexts(field.content, sensors);
  });
  for_each_field(message, [&](const ProtobufField& field) {
    if (field.number != 2) return;
    try {
      add_stroke(sensor_data(field.content), sensors.channels, content);
    } catch (const FileError&) {
      throw;
    } catch (const Error& error) {
      field.content.reject(error.what());
    }
  });
}

/// Whether ink data has strokes.
bool has_splines(const ByteReader& ink_data) {
  bool any = false;
  for_each_field(ink_data, [&](const ProtobufField& field) { any |= field.number == 1; });
  return any;
}

/// Refuses a chunk that the head of version 3.1 tells to be compressed. The head has 4 bytes, then 8 for each
/// chunk that follows: version, type of its content, compression.
void check_plain(std::string_view head, std::size_t number, const RiffChunk& chunk) {
  constexpr std::size_t version_bytes = 4, chunk_bytes = 8, compression_at = 4;
  const std::size_t at = version_bytes + number * chunk_bytes + compression_at;
  if (at < head.size() && head[at] != 0)
    chunk.content.reject(
        fmt::format("the chunk {} is compressed, which is not read", quoted_word(chunk.name)));
}

}  // namespace

bool is_uim(std::string_view text) { return is_riff(text, "UINK"); }

PenFile read_uim(const PenFileText& file) {
  PenFile content;
  content.unit = "px";
  content.millimetres = millimetres_a_pixel;
  std::string_view head;
  std::size_t number = 0;
  bool splines = false;
  for (RiffChunks chunks(file.text, file.path); !chunks.empty();) {
    const RiffChunk chunk = chunks.next();
    if (chunk.name == "HEAD")
      head = chunk.content.bytes();
    else
      check_plain(head, number++, chunk);
    if (chunk.name == "INPT") read_input(chunk.content, content);
    splines |= chunk.name == "INKD" && has_splines(chunk.content);
    if (chunk.name != "DATA") continue;
    for_each_field(chunk.content, [&](const ProtobufField& field) {
      if (field.number == 1) read_input(field.content, content);
      splines |= field.number == 2 && has_splines(field.content);
    });
  }
  if (splines && content.strokes.empty()) content.not_used.emplace_back("splines without sensor data");
  return content;
}

}  // namespace burin
