// Draws the sample strokes and writes them as files.
#include "sample_strokes.h"

#include <burin/base/error.h>
#include <burin/math/elementary.h>
#include <burin/stroke/stroke_file.h>
#include <burin/surface/picker.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "pen_motion.h"
#include "smoothstep.h"

namespace burin::samples {

namespace {

using std::numbers::pi;
namespace fs = std::filesystem;

constexpr PenFields tablet{.time = true, .pressure = true, .tilt = true};

/// A value rounded to a multiple of 1 / per_unit, so that files stay small.
double rounded(double value, double per_unit) { return std::round(value * per_unit) / per_unit; }
float rounded(float value) { return static_cast<float>(rounded(static_cast<double>(value), 1e4)); }

/// The point of the ewer's body at an angle around its axis and a height.
Vec3d on_body(const Picker& picker, double angle, double height) {
  const Vec3f outwards(static_cast<float>(math::cos(angle)), 0, static_cast<float>(-math::sin(angle)));
  const auto hit = picker.pick({Vec3f(0, static_cast<float>(height), 0), outwards});
  if (!hit) throw Error("the sample surface has a hole");
  return hit->position.cast<double>();
}

// The functions below return an angle and a height. Angles run counter-clockwise seen from above; 0 is under
// the lip, pi under the handle.

/// A line around the shoulder from one side of the handle to the other, down there, and once around the foot.
std::pair<double, double> meander_at(double u) {
  const double angle = pi + .55 + u * (4 * pi - 1.55);
  const double down = smoothstep((angle - (3 * pi - .95)) / .95);
  const double upper = .27 + .045 * math::cos(5 * angle), lower = -.50 + .045 * math::cos(5 * angle);
  return {angle, upper + down * (lower - upper)};
}

std::pair<double, double> scale_band_at(double u) {
  const double angle = pi + .40 + u * (2 * pi - 1.50);
  return {angle, -.12 + .03 * math::cos(2 * angle)};
}

/// An S lying on its side, on the belly between lip and handle.
std::pair<double, double> wave_at(double u) {
  return {1.5 * pi + 1.4 * (u - .5), -.1 + .12 * math::sin(2 * pi * (u - .5))};
}

/// The Cornu spiral, which curls one way at its start and the other way at its end, in units of its own,
/// about -1..1.
Vec3d scroll_at(double u) {
  constexpr int slices = 400;
  const double end = 1.75 * (2 * u - 1), slice = end / slices;
  Vec3d sum = Vec3d::Zero();
  for (int i = 0; i < slices; ++i) {
    const double s = (i + .5) * slice;
    sum += Vec3d(math::cos(pi / 2 * s * s), math::sin(pi / 2 * s * s), 0) * slice;
  }
  return sum;
}

void write_stroke(const fs::path& path, StrokeSpace space, const std::optional<Camera>& camera,
                  const RecordedStroke& stroke, double per_unit) {
  StrokeWriter writer(path, space, camera);
  writer.begin(stroke);
  for (Sample sample : stroke.samples) {
    sample.time = rounded(sample.time, 1e5);
    for (double& x : sample.position) x = rounded(x, per_unit);
    sample.pen = {.pressure = rounded(sample.pen.pressure),
                  .tilt_x = rounded(sample.pen.tilt_x),
                  .tilt_y = rounded(sample.pen.tilt_y)};
    writer.add(sample);
  }
  writer.end();
}

struct BrushUse {
  const char* brush;
  double radius;
  ParamSettings params;
};

RecordedStroke drawn(const BrushUse& use, const PenPath& path, const PenStyle& style) {
  RecordedStroke stroke;
  stroke.settings[&StrokeSettings::brush] = use.brush;
  stroke.settings[&StrokeSettings::radius] = use.radius;
  stroke.settings[&StrokeSettings::params] = use.params;
  stroke.fields = tablet;
  for (const PenEvent& event : draw(path, style))
    stroke.samples.push_back({event.time, path(event.u) + event.tremor, event.pen});
  return stroke;
}

void write_on_body(const fs::path& path, const Picker& picker, std::pair<double, double> (*place)(double),
                   const BrushUse& use, const PenStyle& style) {
  const PenPath on_path = [&](double u) {
    const auto [angle, height] = place(u);
    return on_body(picker, angle, height);
  };
  RecordedStroke stroke = drawn(use, on_path, style);
  for (Sample& sample : stroke.samples)
    sample.position = picker.closest(sample.position.cast<float>(), 1)->position.cast<double>();
  write_stroke(path, StrokeSpace::object, {}, stroke, 1e5);
}

void write_scroll(const fs::path& path, const Surface& ewer, const BrushUse& use, const PenStyle& style) {
  const PenPath on_screen = [](double u) -> Vec3d {
    return Vec3d(673, 528, 0) + 170 * scroll_at(u).cwiseProduct(Vec3d(1, -1, 0));
  };
  write_stroke(path, StrokeSpace::screen, side_camera(ewer), drawn(use, on_screen, style), 1e2);
}

}  // namespace

Camera side_camera(const Surface& ewer) {
  Vec3f low = ewer.positions.front(), high = low;
  for (const Vec3f& p : ewer.positions) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const Vec3d direction(-.35, -.25, -.9);
  Camera camera =
      framing_camera(low.cast<double>(), high.cast<double>(), direction, Vec3d::UnitY(), 1280, 960, pi / 6);
  // Rounding makes the file the same on all machines even where the last bits of sines differ.
  for (Mat4d* matrix : {&camera.view, &camera.projection})
    *matrix = matrix->unaryExpr([](double x) { return rounded(x, 1e9); });
  return camera;
}

void write_sample_strokes(const fs::path& folder, const Surface& ewer) {
  const Picker picker(ewer);
  write_on_body(folder / "meander.stroke", picker, meander_at,
                {"org.burin.groove", .18, {{"depth", .18}, {"width", .3}}},
                {.speed = 1.9, .acceleration = 8, .bend_radius = .6, .tremor = .0004, .seed = 1});
  write_on_body(folder / "scale_band.stroke", picker, scale_band_at,
                {"org.burin.scales", .2, {{"depth", .2}, {"stamp", "samples/stamps/scales.exr"}}},
                {.speed = 1.4, .acceleration = 6, .bend_radius = .6, .tremor = .0004, .seed = 2});
  write_on_body(folder / "wave.stroke", picker, wave_at,
                {"org.burin.groove", .19, {{"depth", .2}, {"width", .4}}},
                {.speed = .5, .acceleration = 2, .bend_radius = .4, .tremor = .0002, .seed = 4});
  write_scroll(folder / "scroll.stroke", ewer, {"org.burin.groove", .1, {{"depth", .25}, {"width", .6}}},
               {.speed = 420, .acceleration = 1600, .bend_radius = 260, .tremor = .15, .seed = 3});
}

}  // namespace burin::samples
