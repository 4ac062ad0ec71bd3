// Collects the colours and masks among the vertex properties of a PLY file, scaled to bytes and to 0..1.
#include <burin/surface/files/colour_byte.h>
#include <burin/surface/files/over_clay.h>
#include <burin/surface/formats/ply_paint.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace burin {
namespace {

/// The property names in the order of Slot.
constexpr const char* paint_names[] = {"red",       "green",    "blue",      "alpha", "ink_red",
                                       "ink_green", "ink_blue", "ink_alpha", "mask"};

/// Older programs write colour channels as "diffuse_red", or "r".
std::string_view channel_name(std::string_view name) {
  constexpr std::string_view initials = "rgba";
  if (name.size() == 1 && initials.find(name) != initials.npos) return paint_names[initials.find(name)];
  constexpr std::string_view older_prefix = "diffuse_";
  if (!name.starts_with(older_prefix)) return name;
  const std::string_view channel = name.substr(older_prefix.size());
  const auto channels = std::span(paint_names).first(4);
  return std::ranges::find(channels, channel) == channels.end() ? name : channel;
}

bool has(const PlyElement& element, std::string_view name) {
  return std::ranges::any_of(element.properties, [&](const PlyProperty& property) {
    return channel_name(property.name) == name && !property.count_type;
  });
}

bool is_floating(PlyType type) { return type == PlyType::float32 || type == PlyType::float64; }

double greatest_channel(PlyType type) {
  if (is_floating(type)) return 1;
  return type == PlyType::uint16 ? 65535 : 255;
}

constexpr double full_byte = 255;

/// Channels above this are no light of high dynamic range but count to 255.
constexpr double far_above_1 = 16;

/// Whether floating-point channels, those from `first` up to `end`, count to 255: if not all are up to 1, and
/// all are whole numbers or one is too large for anything else.
bool count_to_255(const std::vector<std::array<float, 4>>& reals, std::size_t first, std::size_t end) {
  float greatest = 0;
  bool whole = true;
  for (const auto& colour : reals)
    for (std::size_t channel = first; channel < end; ++channel) {
      greatest = std::max(greatest, colour[channel]);
      whole = whole && colour[channel] == std::floor(colour[channel]);
    }
  return greatest > 1 + colour_rounding && (whole || greatest > far_above_1);
}

std::string out_of_range(std::string_view property, double value, double greatest) {
  return fmt::format("its {} is {}, not from 0 to {}", property, value, greatest);
}

}  // namespace

PlyPaint::PlyPaint(const PlyElement& vertices)
    : vertices_(vertices), slots_(vertices.properties.size(), Slot::none) {
  const bool coloured = has(vertices, "red") && has(vertices, "green") && has(vertices, "blue");
  const bool inked = coloured && has(vertices, "ink_red") && has(vertices, "ink_green") &&
                     has(vertices, "ink_blue") && has(vertices, "ink_alpha");
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    const PlyProperty& property = vertices.properties[i];
    const auto name = std::ranges::find(paint_names, channel_name(property.name)) - paint_names;
    const auto slot = static_cast<Slot>(name);
    if (name == std::ssize(paint_names) || property.count_type) continue;
    if (slot != Slot::mask && !(slot < Slot::ink_red ? coloured : inked)) continue;
    slots_[i] = slot;
  }
  if (coloured) paint_.colours.assign(vertices.count, {0, 0, 0, 255});
  for (std::size_t i = 0; i < slots_.size(); ++i)
    if (is_real(i)) reals_.resize(vertices.count);
  if (inked) ink_.resize(vertices.count);
  if (has(vertices, "mask")) paint_.masks.resize(vertices.count);
}

bool PlyPaint::is_real(std::size_t property) const {
  return slots_[property] != Slot::none && slots_[property] < Slot::ink_red &&
         is_floating(vertices_.properties[property].type);
}

std::string PlyPaint::take(std::size_t index, std::uint64_t vertex, double value) {
  const Slot slot = slots_[index];
  if (slot == Slot::none) return {};
  const PlyProperty& property = vertices_.properties[index];
  const bool real = is_real(index);
  const double greatest = slot == Slot::mask ? 1 : greatest_channel(property.type);
  const double rounding = greatest == 1 ? colour_rounding : 0;
  if (!(value >= -rounding && value <= (real ? full_byte : greatest) + rounding))
    return out_of_range(property.name, value, greatest);
  if (slot == Slot::mask) {
    paint_.masks[vertex] = static_cast<float>(std::clamp(value, 0.0, 1.0));
    return {};
  }
  const auto channel = static_cast<std::size_t>(slot);
  if (real)
    reals_[vertex][channel] = static_cast<float>(value);
  else
    (slot < Slot::ink_red ? paint_.colours : ink_)[vertex][channel % 4] = colour_byte(value / greatest);
  return {};
}

std::optional<PlyPaint::Fault> PlyPaint::settle_reals() {
  if (reals_.empty()) return std::nullopt;
  constexpr std::size_t alpha = 3;
  const double full = count_to_255(reals_, 0, alpha) ? full_byte : 1;
  const std::array<double, 4> greatest = {full, full, full,
                                          count_to_255(reals_, alpha, alpha + 1) ? full_byte : 1};
  for (std::size_t vertex = 0; vertex < reals_.size(); ++vertex)
    for (std::size_t i = 0; i < slots_.size(); ++i) {
      if (!is_real(i)) continue;
      const auto channel = static_cast<std::size_t>(slots_[i]);
      const double value = reals_[vertex][channel];
      if (value > greatest[channel] + colour_rounding)
        return Fault{vertex, out_of_range(vertices_.properties[i].name, value, 1)};
      paint_.colours[vertex][channel] = colour_byte(value / greatest[channel]);
    }
  return std::nullopt;
}

VertexPaint PlyPaint::finish() {
  if (!ink_.empty()) paint_.colours = ink_unless_painted_over(paint_.colours, std::move(ink_));
  return std::move(paint_);
}

}  // namespace burin
