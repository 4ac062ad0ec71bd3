#include <burin/surface/ply_paint.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

constexpr const char* names[] = {"red", "green", "blue", "alpha", "mask"};

bool has(const PlyElement& element, std::string_view name) {
  return std::ranges::any_of(element.properties, [&](const PlyProperty& property) {
    return property.name == name && !property.count_type;
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
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    const PlyProperty& property = vertices.properties[i];
    const auto name = std::ranges::find(names, property.name) - names;
    const auto slot = static_cast<Slot>(name);
    if (name == std::ssize(names) || property.count_type || (slot != Slot::mask && !coloured)) continue;
    slots_[i] = slot;
  }
  if (coloured) paint.colours.assign(vertices.count, {0, 0, 0, 255});
  if (has(vertices, "mask")) paint.masks.resize(vertices.count);
}

std::string PlyPaint::take(const PlyProperty& property, std::uint64_t vertex, double value) {
  const Slot slot = slots_[static_cast<std::size_t>(&property - vertices_.properties.data())];
  if (slot == Slot::none) return {};
  const double greatest = slot == Slot::mask ? 1 : greatest_channel(property.type);
  if (!(value >= 0 && value <= greatest))
    return fmt::format("its {} is {}, not from 0 to {}", property.name, value, greatest);
  if (slot == Slot::mask) {
    paint.masks[vertex] = static_cast<float>(value);
  } else {
    paint.colours[vertex][static_cast<std::size_t>(slot)] =
        static_cast<std::uint8_t>(std::lround(255 / greatest * value));
  }
  return {};
}

}  // namespace burin
