// Writes descriptors member by member, and makes them again from what was written.
#include <burin/host/isolate/descriptor_message.h>
#include <burin/plugin/detail/complete.h>

#include <cstdint>

namespace burin::isolate {
namespace {

/// A text that may be null.
void write_text(MessageWriter& to, const char* text) {
  to.value(std::uint32_t{text != nullptr});
  if (text) to.text(text);
}

/// A list that ends with a null pointer, and may be null itself.
void write_texts(MessageWriter& to, const char* const* list) {
  std::uint32_t count = 0;
  while (list && list[count]) ++count;
  to.value(std::uint32_t{list != nullptr}).value(count);
  for (std::uint32_t i = 0; i < count; ++i) to.text(list[i]);
}

void write_param(MessageWriter& to, const burin_param_info& info) {
  burin_param_info param = plugin::complete(info);
  param.struct_size = sizeof param;
  // Only what the type of the parameter has is checked.
  if (param.type != BURIN_PARAM_CHOICE) param.choices = nullptr;
  if (param.type != BURIN_PARAM_FILE) param.default_file = nullptr;
  if (param.type != BURIN_PARAM_TEXT) param.default_text = nullptr;
  if (param.type != BURIN_PARAM_CURVE) param.default_knot_count = 0;
  for (const char* text : {param.id, param.name, param.help, param.default_file, param.default_text})
    write_text(to, text);
  write_texts(to, param.choices);
  to.block(std::as_bytes(std::span(param.default_knots, 2 * std::size_t{param.default_knot_count})));
  // Messages of one module are the same wherever it is in memory.
  param.id = param.name = param.help = param.default_file = param.default_text = nullptr;
  param.choices = nullptr;
  param.default_knots = nullptr;
  to.value(param);
}

void write_brush(MessageWriter& to, const burin_brush_descriptor& descriptor) {
  burin_brush_descriptor brush = plugin::complete(descriptor);
  brush.struct_size = sizeof brush;
  to.value(brush.param_count);
  for (std::uint32_t i = 0; i < brush.param_count; ++i) write_param(to, *brush.params[i]);
  for (const char* text : {brush.id, brush.name, brush.vendor, brush.version, brush.help})
    write_text(to, text);
  write_texts(to, brush.features);
  brush.id = brush.name = brush.vendor = brush.version = brush.help = nullptr;
  brush.features = nullptr;
  brush.params = nullptr;
  to.value(brush);
}

}  // namespace

void write_descriptors(MessageWriter& to, std::span<const burin_brush_descriptor* const> brushes) {
  to.value(static_cast<std::uint32_t>(brushes.size()));
  for (const burin_brush_descriptor* brush : brushes) write_brush(to, *brush);
}

const char* ReceivedDescriptors::read_text(MessageReader& from) {
  if (from.value<std::uint32_t>() == 0) return nullptr;
  return texts_.emplace_back(from.text()).c_str();
}

const char* const* ReceivedDescriptors::read_texts(MessageReader& from) {
  const bool there = from.value<std::uint32_t>() != 0;
  const std::uint32_t count = from.count(sizeof(std::uint64_t));
  std::vector<const char*>& list = lists_.emplace_back();
  for (std::uint32_t i = 0; i < count; ++i) list.push_back(texts_.emplace_back(from.text()).c_str());
  list.push_back(nullptr);
  return there ? list.data() : nullptr;
}

burin_param_info ReceivedDescriptors::read_param(MessageReader& from) {
  const char *id = read_text(from), *name = read_text(from), *help = read_text(from),
             *default_file = read_text(from), *default_text = read_text(from);
  const char* const* choices = read_texts(from);
  const std::span<const std::byte> knots = from.block();
  std::vector<float>& numbers = knots_.emplace_back(knots.size() / sizeof(float));
  if (!numbers.empty()) std::memcpy(numbers.data(), knots.data(), numbers.size() * sizeof(float));
  auto param = from.value<burin_param_info>();
  param.struct_size = sizeof param;
  param.id = id;
  param.name = name;
  param.help = help;
  param.default_file = default_file;
  param.default_text = default_text;
  param.choices = choices;
  param.default_knots = numbers.data();
  param.default_knot_count = static_cast<std::uint32_t>(numbers.size() / 2);
  return param;
}

burin_brush_descriptor ReceivedDescriptors::read_brush(MessageReader& from) {
  const std::uint32_t count = from.count(sizeof(burin_param_info));
  std::vector<const burin_param_info*>& params = param_lists_.emplace_back();
  for (std::uint32_t i = 0; i < count; ++i) params.push_back(&params_.emplace_back(read_param(from)));
  const char *id = read_text(from), *name = read_text(from), *vendor = read_text(from),
             *version = read_text(from), *help = read_text(from);
  const char* const* features = read_texts(from);
  auto brush = from.value<burin_brush_descriptor>();
  brush.struct_size = sizeof brush;
  brush.param_count = count;
  brush.id = id;
  brush.name = name;
  brush.vendor = vendor;
  brush.version = version;
  brush.help = help;
  brush.features = features;
  brush.params = params.data();
  return brush;
}

ReceivedDescriptors::ReceivedDescriptors(MessageReader& from) {
  const std::uint32_t count = from.count(sizeof(burin_brush_descriptor));
  for (std::uint32_t i = 0; i < count; ++i) pointers_.push_back(&brushes_.emplace_back(read_brush(from)));
}

}  // namespace burin::isolate
