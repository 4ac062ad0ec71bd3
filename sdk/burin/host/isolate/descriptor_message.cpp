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
  burin_param_info plain = param;
  // Messages of one module are the same wherever it is in memory.
  plain.id = plain.name = plain.help = plain.default_file = plain.default_text = nullptr;
  plain.choices = nullptr;
  plain.default_knots = nullptr;
  to.value(plain);
  for (const char* text : {param.id, param.name, param.help, param.default_file, param.default_text})
    write_text(to, text);
  write_texts(to, param.choices);
  to.block(std::as_bytes(std::span(param.default_knots, 2 * std::size_t{param.default_knot_count})));
}

void write_brush(MessageWriter& to, const burin_brush_descriptor& descriptor) {
  burin_brush_descriptor brush = plugin::complete(descriptor);
  brush.struct_size = sizeof brush;
  burin_brush_descriptor plain = brush;
  plain.id = plain.name = plain.vendor = plain.version = plain.help = nullptr;
  plain.features = nullptr;
  plain.params = nullptr;
  to.value(plain);
  for (const char* text : {brush.id, brush.name, brush.vendor, brush.version, brush.help})
    write_text(to, text);
  write_texts(to, brush.features);
  to.value(brush.param_count);
  for (std::uint32_t i = 0; i < brush.param_count; ++i) write_param(to, *brush.params[i]);
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
  auto param = from.value<burin_param_info>();
  param.struct_size = sizeof param;
  for (const char** text : {&param.id, &param.name, &param.help, &param.default_file, &param.default_text})
    *text = read_text(from);
  param.choices = read_texts(from);
  const std::span<const std::byte> knots = from.block();
  std::vector<float>& numbers = knots_.emplace_back(knots.size() / sizeof(float));
  if (!numbers.empty()) std::memcpy(numbers.data(), knots.data(), numbers.size() * sizeof(float));
  param.default_knots = numbers.data();
  param.default_knot_count = static_cast<std::uint32_t>(numbers.size() / 2);
  return param;
}

burin_brush_descriptor ReceivedDescriptors::read_brush(MessageReader& from) {
  auto brush = from.value<burin_brush_descriptor>();
  brush.struct_size = sizeof brush;
  for (const char** text : {&brush.id, &brush.name, &brush.vendor, &brush.version, &brush.help})
    *text = read_text(from);
  brush.features = read_texts(from);
  brush.param_count = from.count(sizeof(burin_param_info));
  std::vector<const burin_param_info*>& params = param_lists_.emplace_back();
  for (std::uint32_t i = 0; i < brush.param_count; ++i)
    params.push_back(&params_.emplace_back(read_param(from)));
  brush.params = params.data();
  return brush;
}

ReceivedDescriptors::ReceivedDescriptors(MessageReader& from) {
  const std::uint32_t count = from.count(sizeof(burin_brush_descriptor));
  for (std::uint32_t i = 0; i < count; ++i) pointers_.push_back(&brushes_.emplace_back(read_brush(from)));
}

}  // namespace burin::isolate
