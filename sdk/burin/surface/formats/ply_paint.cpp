// Collects the colours and masks among the vertex properties of a PLY file, scaled to bytes and to 0..1.
#include <burin/surface/files/colour_byte.h>
#include <burin/surface/files/over_clay.h>
#include <burin/surface/formats/ply_paint.h>
#include <fmt/format.h>

#include <algorithm>
#include <span>

namespace burin {
namespace {

/// The property names in the order of Slot.
constexpr const char* names[] = {"red",       "green",    "blue",      "alpha", "ink_red",
                                 "ink_green", "ink_blue", "ink_alpha", "mask"};

/// Older programs write colour channels as "diffuse_red", or "r".
std::string_view channel_name(std::string_view name) {
  constexpr std::string_view initials = "rgba";
  if (name.size() == 1 && initials.find(name) != initials.npos) return names[initials.find(name)];
  constexpr std::string_view older_prefix = "diffuse_";
  if (!name.starts_with(older_prefix)) return name;
  const std::string_view channel = name.substr(older_prefix.size());
  const auto channels = std::span(names).first(4);
  return std::ranges::find(channels, channel) == channels.end() ? name : channel;
}

bool has(const PlyElement& element, std::string_view name) {
  return std::ranges::any_of(element.properties, [&](const PlyProperty& property) {
    return channel_name(property.name) == name && !property.count_type;
  });
}

double greatest_channel(PlyType type) {
  if (type == PlyType::float32 || type == PlyType::float64) return 1;
  return type == PlyType::uint16 ? 65535 : 255;
}

}  // namespace

PlyPaint::PlyPaint(const PlyElement& vertices)
    : vertices_(vertices), slots_(vertices.properties.size(), Slot::none) {
  const bool coloured = has(vertices, "red") && has(vertices, "green") && has(vertices, "blue");
  const bool inked = coloured && has(vertices, "ink_red") && has(vertices, "ink_green") &&
                     has(vertices, "ink_blue") && has(vertices, "ink_alpha");
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    const PlyProperty& property = vertices.properties[i];
    const auto name = std::ranges::find(names, channel_name(property.name)) - names;
    const auto slot = static_cast<Slot>(name);
    if (name == std::ssize(names) || property.count_type) continue;
    if (slot != Slot::mask && !(slot < Slot::ink_red ? coloured : inked)) continue;
    slots_[i] = slot;
  }
  if (coloured) paint_.colours.assign(vertices.count, {0, 0, 0, 255});
  if (inked) ink_.resize(vertices.count);
  if (has(vertices, "mask")) paint_.masks.resize(vertices.count);
}

std::string PlyPaint::take(std::size_t index, std::uint64_t vertex, double value) {
  const Slot slot = slots_[index];
  if (slot == Slot::none) return {};
  const PlyProperty& property = vertices_.properties[index];
  const double greatest = slot == Slot::mask ? 1 : greatest_channel(property.type);
  const double rounding = greatest == 1 ? colour_rounding : 0;
  if (!(value >= -rounding && value <= greatest + rounding))
    return fmt::format("its {} is {}, not from 0 to {}", property.name, value, greatest);
  if (slot == Slot::mask) {
    paint_.masks[vertex] = static_cast<float>(std::clamp(value, 0.0, 1.0));
    return {};
  }
  const auto channel = static_cast<std::size_t>(slot);
  (slot < Slot::ink_red ? paint_.colours : ink_)[vertex][channel % 4] = colour_byte(value / greatest);
  return {};
}

VertexPaint PlyPaint::finish() {
  if (!ink_.empty()) paint_.colours = ink_unless_painted_over(paint_.colours, std::move(ink_));
  return std::move(paint_);
}

}  // namespace burin
