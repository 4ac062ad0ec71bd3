// Records the motion of a hand as real devices do. What is random comes from the seed of the hand.
#include "recorder.h"

#include <burin/math/elementary.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace burin::samples {

namespace {

double share(std::mt19937_64& random) { return std::ldexp(static_cast<double>(random() >> 11), -53); }

/// The nearest multiple of a step; all values where it is 0. Of that only so many parts of a unit stay, so
/// that files are small.
double rounded(double value, double step, double per_unit) {
  const double stepped = step > 0 ? std::round(value / step) * step : value;
  return std::round(stepped * per_unit) / per_unit;
}

/// The report of the hand at a time, between those of `events`.
PenEvent at(const std::vector<PenEvent>& events, double time) {
  const auto after = std::ranges::lower_bound(events, time, {}, &PenEvent::time);
  if (after == events.begin()) return events.front();
  if (after == events.end()) return events.back();
  const PenEvent &a = *(after - 1), &b = *after;
  const double part = (time - a.time) / (b.time - a.time);
  const auto between = [&](float from, float to) { return from + static_cast<float>(part) * (to - from); };
  return {time,
          a.u + part * (b.u - a.u),
          a.tremor + part * (b.tremor - a.tremor),
          {.pressure = between(a.pen.pressure, b.pen.pressure),
           .tilt_x = between(a.pen.tilt_x, b.pen.tilt_x),
           .tilt_y = between(a.pen.tilt_y, b.pen.tilt_y)}};
}

/// When the device reports, seconds.
std::vector<double> report_times(const Recorder& recorder, double end, std::mt19937_64& random) {
  std::vector<double> times;
  for (double time = 0; time <= end;) {
    times.push_back(time);
    const auto drawn =
        static_cast<std::size_t>(share(random) * static_cast<double>(recorder.intervals.size()));
    time += recorder.intervals[drawn] / 1000;
    if (share(random) < recorder.late) time += recorder.gap / 1000;
  }
  return times;
}

/// Where the pen slips to as it lands and lifts: sideways, and back within 25 ms.
Vec3d hook_at(const Recorder& recorder, double time, double end) {
  constexpr double duration = 0.025;
  const double near = std::min(time, end - time) / duration;
  if (near >= 1) return Vec3d::Zero();
  const double way = recorder.hook * (1 - near) * (1 - near);
  return time < end / 2 ? Vec3d(0.6 * way, -0.8 * way, 0) : Vec3d(-0.8 * way, -0.6 * way, 0);
}

float pressure_of(const Recorder& recorder, float pressure) {
  const double pressed = std::clamp(double{pressure} * recorder.pressure_gain, 0., 1.);
  return static_cast<float>(rounded(pressed, 1. / recorder.pressure_levels, 1e6));
}

/// Some reports come under the time of the next one.
void pack(std::vector<Sample>& samples, double packed, std::mt19937_64& random) {
  for (std::size_t i = samples.size() - 1; i-- > 0;)
    if (share(random) < packed) samples[i].time = samples[i + 1].time;
}

}  // namespace

RecordedStroke record(const Recorder& recorder, const PenPath& path, const PenStyle& style) {
  const std::vector<PenEvent> events = draw(path, style);
  const double end = events.back().time;
  std::mt19937_64 random(style.seed + 1000);
  RecordedStroke stroke;
  stroke.fields = recorder.fields;
  for (const double time : report_times(recorder, end, random)) {
    const PenEvent event = at(events, time);
    Sample sample;
    if (recorder.fields.time) sample.time = rounded(time, recorder.time_step, 1e6);
    sample.position = path(event.u) + event.tremor + hook_at(recorder, time, end);
    for (double& x : sample.position) x = rounded(x, recorder.pixel_step, 1e4);
    if (!stroke.samples.empty() && share(random) < recorder.resting)
      sample.position = stroke.samples.back().position;
    if (recorder.fields.pressure) sample.pen.pressure = pressure_of(recorder, event.pen.pressure);
    if (recorder.fields.tilt) {
      constexpr double degree = 0.0174533;
      sample.pen.tilt_x = static_cast<float>(rounded(double{event.pen.tilt_x}, degree, 1e5));
      sample.pen.tilt_y = static_cast<float>(rounded(double{event.pen.tilt_y}, degree, 1e5));
    }
    stroke.samples.push_back(sample);
  }
  if (recorder.fields.time) pack(stroke.samples, recorder.packed, random);
  return stroke;
}

std::vector<Recorder> recorders() {
  constexpr PenFields pen{.time = true, .pressure = true, .tilt = true};
  constexpr PenFields flat{.time = true, .pressure = true};
  constexpr PenFields mouse{.time = true};
  return {
      {"intuos4",
       "Wacom Intuos4 6x9",
       pen,
       {4, 4, 4, 4, 4, 4, 8, 8},
       0,
       0,
       0,
       0.04,
       0.04,
       1e-6,
       2047,
       1.5,
       3},
      {"cintiq",
       "Wacom Cintiq 12WX",
       pen,
       {7.1, 7.1, 8, 7.9, 7.1, 6.9, 9.1, 6},
       0,
       0,
       0,
       0.01,
       0.05,
       1e-6,
       1023,
       0.9,
       2},
      {"intuos_pro",
       "Wacom Intuos Pro M",
       pen,
       {5.9, 5.9, 5.9, 3.9, 1.9, 5.9, 6.9, 3.6},
       0.004,
       26,
       0,
       0.02,
       0.05,
       1e-6,
       8191,
       1.3,
       4},
      {"uclogic",
       "UC-LOGIC WP5540U",
       flat,
       {8, 8, 8, 8, 8, 8, 8, 16},
       0.005,
       24,
       0,
       0.02,
       0.03,
       1e-6,
       1023,
       0.5,
       3},
      {"svc",
       "tablet of a handwriting study",
       pen,
       {8, 7, 8, 7, 8, 7, 8, 7},
       0,
       0,
       0,
       0.14,
       0.1,
       1e-3,
       1023,
       1.0,
       2},
      {"uim",
       "pen of a web page",
       pen,
       {9, 9, 9, 31, 9, 30, 33, 40},
       0.01,
       60,
       0.07,
       0.24,
       0.01,
       1e-3,
       100,
       1.0,
       1},
      {"mypaint",
       "painting program",
       flat,
       {8, 8, 8, 8, 8, 16, 8, 16},
       0.004,
       24,
       0,
       0.005,
       0.5,
       1e-3,
       480,
       0.7,
       2},
      {"pointer",
       "PointerEvents of a browser",
       pen,
       {16.1, 16.1, 16.1, 16.1, 16.1, 7.4, 25, 22},
       0.01,
       16,
       0,
       0.01,
       0.5,
       1e-4,
       1023,
       0.7,
       1},
      {"mouse",
       "mouse of a web page",
       mouse,
       {17, 17, 17, 17, 33, 17, 50, 34},
       0.02,
       130,
       0,
       0.02,
       1,
       1e-3,
       0,
       1,
       0},
      {"note",
       "notebook without a clock",
       PenFields{.pressure = true},
       {12, 12, 12, 12, 12, 12, 12, 12},
       0,
       0,
       0,
       0,
       0.01,
       0,
       1023,
       0.9,
       0},
  };
}

}  // namespace burin::samples
