// Draws strokes as lines whose colour shows pressure or speed, in a plane or over a rendered surface.
#include "recordings/strokes_picture.h"

#include <burin/ink/fit/fit_to_view.h>
#include <algorithm>
#include <cmath>

#include "pictures/pencil.h"
#include "pictures/render.h"

namespace burin::command {
namespace {

/// The value of the line that ends at sample `i`, from 1, if the stroke has it.
std::optional<double> value_at(const RecordedStroke& stroke, std::size_t i, LineColour colour) {
  const Sample &before = stroke.samples[i - 1], &sample = stroke.samples[i];
  if (colour == LineColour::pressure)
    return stroke.fields.pressure ? std::optional<double>(sample.pen.pressure) : std::nullopt;
  const double seconds = sample.time - before.time;
  if (!stroke.fields.time || !(seconds > 0)) return std::nullopt;
  const double speed = (sample.position - before.position).norm() / seconds;
  return std::isfinite(speed) ? std::optional(speed) : std::nullopt;
}

Ink ink_for(double share) {
  constexpr double stops[][3] = {{40, 60, 200}, {20, 160, 130}, {250, 200, 30}};
  const double at = 2 * std::clamp(share, 0., 1.);
  const auto first = static_cast<std::size_t>(std::min(at, 1.));
  Ink ink{};
  for (std::size_t channel = 0; channel < 3; ++channel)
    ink[channel] = static_cast<std::uint8_t>(
        std::lround(stops[first][channel] +
                    (at - static_cast<double>(first)) * (stops[first + 1][channel] - stops[first][channel])));
  return ink;
}

/// Calls `draw(a, b, ink)` with the positions of each line.
template <class Draw>
void for_each_line(const Recording& recording, LineColour colour, const Draw& draw) {
  constexpr Ink dark = {60, 60, 60};
  const std::optional<ValueRange> range = coloured_range(recording, colour);
  for (const RecordedStroke& stroke : recording.strokes) {
    if (stroke.samples.size() == 1) draw(stroke.samples[0].position, stroke.samples[0].position, dark);
    for (std::size_t i = 1; i < stroke.samples.size(); ++i) {
      const std::optional<double> value = value_at(stroke, i, colour);
      const double extent = range ? range->most - range->least : 0;
      const double share = value && extent > 0 ? (*value - range->least) / extent : 0;
      draw(stroke.samples[i - 1].position, stroke.samples[i].position, value ? ink_for(share) : dark);
    }
  }
}

void draw_flat(Picture& picture, const Recording& recording, LineColour colour) {
  LineLayer layer(picture.width, picture.height);
  for_each_line(recording, colour, [&](const Vec3d& a, const Vec3d& b, const Ink& ink) {
    layer.add_line(a.head<2>(), b.head<2>(), ink);
  });
  layer.blend(picture);
}

}  // namespace

std::optional<ValueRange> coloured_range(const Recording& recording, LineColour colour) {
  constexpr double top = 0.95;
  std::vector<double> values;
  for (const RecordedStroke& stroke : recording.strokes)
    for (std::size_t i = 1; i < stroke.samples.size(); ++i)
      if (const auto value = value_at(stroke, i, colour)) values.push_back(*value);
  if (values.empty()) return std::nullopt;
  std::ranges::sort(values);
  const auto high = static_cast<std::size_t>(top * static_cast<double>(values.size() - 1));
  return ValueRange{values.front(), colour == LineColour::speed ? values[high] : values.back()};
}

Picture picture_in_plane(Recording recording, LineColour colour, int width, int height) {
  constexpr std::uint8_t white = 255;
  if (recording.space == StrokeSpace::object)
    for (RecordedStroke& stroke : recording.strokes)
      for (Sample& sample : stroke.samples) sample.position.y() = -sample.position.y();
  Camera sheet;
  sheet.width = width;
  sheet.height = height;
  fit_to_view(recording.strokes, sheet);
  Picture picture{width, height, {}};
  picture.rgb.assign(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height), white);
  draw_flat(picture, recording, colour);
  return picture;
}

Picture picture_on_surface(const Recording& recording, LineColour colour, const Surface& surface) {
  const Picker picker(surface);
  const Camera& camera = *recording.camera;
  Picture picture = render(surface, picker, camera, clay, {});
  if (recording.space == StrokeSpace::screen) {
    draw_flat(picture, recording, colour);
    return picture;
  }
  LineLayer layer(picture.width, picture.height);
  Pencil pencil(layer, camera, picker, 1e-3 * surface.scale);
  for_each_line(recording, colour,
                [&](const Vec3d& a, const Vec3d& b, const Ink& ink) { pencil.draw(a, b, ink); });
  layer.blend(picture);
  return picture;
}

}  // namespace burin::command
