// Draws the sample recordings: gestures as people make them, recorded as devices do.
#include "sample_recordings.h"

#include <burin/math/elementary.h>
#include <burin/stroke/stroke_file.h>
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

#include "recorder.h"
#include "sample_strokes.h"

namespace burin::samples {

namespace {

using std::numbers::pi;

/// A gesture: its path, within about -1..1.
struct Gesture {
  std::string_view name;
  Vec3d (*at)(double u);
};

/// The place on a line through corners.
template <std::size_t count>
Vec3d on_corners(const std::array<Vec3d, count>& corners, double u) {
  const double along = u * (count - 1);
  const auto leg = std::min<std::size_t>(static_cast<std::size_t>(along), count - 2);
  return corners[leg] + (along - static_cast<double>(leg)) * (corners[leg + 1] - corners[leg]);
}

Vec3d circle(double angle, double radius) {
  return {radius * math::cos(angle), radius * math::sin(angle), 0};
}

const std::array gestures = {
    Gesture{"line", [](double u) -> Vec3d { return Vec3d(2 * u - 1, 0.3 * u, 0); }},
    Gesture{"arc", [](double u) -> Vec3d { return circle(pi * (1.1 + 0.8 * u), 0.9); }},
    Gesture{"wave", [](double u) -> Vec3d { return Vec3d(2 * u - 1, 0.35 * math::sin(4 * pi * u), 0); }},
    Gesture{"loops",
            [](double u) -> Vec3d { return Vec3d(1.6 * u - 0.8, 0, 0) + circle(-10 * pi * u, 0.22); }},
    Gesture{"zigzag",
            [](double u) -> Vec3d {
              const std::array<Vec3d, 6> corners = {Vec3d(-1, 0.3, 0),   Vec3d(-0.6, -0.3, 0),
                                                    Vec3d(-0.2, 0.3, 0), Vec3d(0.2, -0.3, 0),
                                                    Vec3d(0.6, 0.3, 0),  Vec3d(1, -0.3, 0)};
              return on_corners(corners, u);
            }},
    Gesture{"spiral", [](double u) -> Vec3d { return circle(5 * pi * u, 0.15 + 0.7 * u); }},
    Gesture{
        "eight",
        [](double u) -> Vec3d { return Vec3d(0.8 * math::sin(2 * pi * u), 0.4 * math::sin(4 * pi * u), 0); }},
    Gesture{"scrub",
            [](double u) -> Vec3d {
              const std::array<Vec3d, 6> corners = {Vec3d(-0.7, 0, 0),     Vec3d(0.7, 0.02, 0),
                                                    Vec3d(-0.68, 0.05, 0), Vec3d(0.7, 0.1, 0),
                                                    Vec3d(-0.7, 0.12, 0),  Vec3d(0.7, 0.2, 0)};
              return on_corners(corners, u);
            }},
    Gesture{"circle", [](double u) -> Vec3d { return circle(2 * pi * u, 0.6); }},
    Gesture{"tick", [](double u) -> Vec3d {
              const std::array<Vec3d, 3> corners = {Vec3d(-0.3, -0.1, 0), Vec3d(-0.1, 0.3, 0),
                                                    Vec3d(0.5, -0.5, 0)};
              return on_corners(corners, u);
            }}};

void write_recording(const std::filesystem::path& folder, const Camera& camera, const Recorder& recorder,
                     const Gesture& gesture, std::uint64_t seed) {
  const PenPath on_screen = [&](double u) -> Vec3d { return Vec3d(673, 528, 0) + 150 * gesture.at(u); };
  RecordedStroke stroke =
      record(recorder, on_screen,
             {.speed = 420, .acceleration = 2400, .bend_radius = 200, .tremor = .2, .seed = seed});
  stroke.settings[&StrokeSettings::brush] = "org.burin.groove";
  stroke.settings[&StrokeSettings::radius] = .05;
  StrokeWriter writer(folder / fmt::format("{}_{}.stroke", recorder.name, gesture.name), StrokeSpace::screen,
                      camera, recorder.device);
  writer.begin(stroke);
  for (const Sample& sample : stroke.samples) writer.add(sample);
  writer.end();
}

}  // namespace

void write_recordings(const std::filesystem::path& folder, const Surface& ewer) {
  const Camera camera = side_camera(ewer);
  const std::vector<Recorder> all = recorders();
  for (std::size_t i = 0; i < all.size(); ++i) {
    write_recording(folder, camera, all[i], gestures[i], 100 + i);
    write_recording(folder, camera, all[i], gestures[(i + 3) % gestures.size()], 200 + i);
  }
}

}  // namespace burin::samples
