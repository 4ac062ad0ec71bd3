// Splits, joins and resamples strokes by their times.
#include <burin/base/error.h>
#include <burin/ink/mend.h>
#include <burin/stroke/recording.h>
#include <burin/stroke/sample_times.h>
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace burin {
namespace {

/// Linear from a to b; `share` from 0 to 1.
Sample between(const Sample& a, const Sample& b, double share) {
  const auto part = static_cast<float>(share);
  const auto turned = std::remainder(b.pen.twist - a.pen.twist, 2 * std::numbers::pi_v<float>);
  Sample made;
  made.time = a.time + share * (b.time - a.time);
  made.position = a.position + share * (b.position - a.position);
  made.pen.pressure = a.pen.pressure + part * (b.pen.pressure - a.pen.pressure);
  made.pen.tilt_x = a.pen.tilt_x + part * (b.pen.tilt_x - a.pen.tilt_x);
  made.pen.tilt_y = a.pen.tilt_y + part * (b.pen.tilt_y - a.pen.tilt_y);
  made.pen.twist = a.pen.twist + part * turned;
  made.barrel = a.barrel;
  return made;
}

/// The samples at even times. Times must not fall.
std::vector<Sample> at_even_times(const std::vector<Sample>& samples, double rate) {
  std::vector<Sample> made;
  const double start = samples.front().time, end = samples.back().time;
  std::size_t after = 0;
  for (std::size_t i = 0;; ++i) {
    const double time = start + static_cast<double>(i) / rate;
    if (time >= end) break;
    while (samples[after].time <= time) ++after;
    const Sample &a = samples[after - 1], &b = samples[after];
    made.push_back(between(a, b, (time - a.time) / (b.time - a.time)));
    made.back().time = time;
  }
  made.push_back(samples.back());
  return made;
}

/// Whether the samples of one stroke can go on with those of the other.
bool same_kind(const RecordedStroke& a, const RecordedStroke& b) {
  return a.fields == b.fields && a.drawn_by == b.drawn_by;
}

void check_times(const RecordedStroke& stroke, std::size_t number) {
  for (std::size_t i = 1; i < stroke.samples.size(); ++i)
    if (stroke.samples[i].time < stroke.samples[i - 1].time)
      throw Error(fmt::format("stroke {}, sample {}: time falls; --fix mends that", number, i + 1));
}

/// Refuses more samples than anybody can want.
void check_count(const RecordedStroke& stroke, double rate, double& samples) {
  constexpr double most_samples = 1e7;
  samples += rate * (stroke.samples.back().time - stroke.samples.front().time);
  if (!(samples <= most_samples)) throw Error("resampling gives more than ten million samples");
}

}  // namespace

std::vector<std::string> split(Recording& recording, double gap) {
  std::vector<std::string> lines;
  std::vector<RecordedStroke> strokes;
  for (std::size_t number = 1; number <= recording.strokes.size(); ++number) {
    RecordedStroke& stroke = recording.strokes[number - 1];
    const std::vector<Sample> samples = std::exchange(stroke.samples, {});
    strokes.push_back(stroke);
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const double pause = i == 0 || !stroke.fields.time ? 0 : samples[i].time - samples[i - 1].time;
      if (pause > gap) {
        lines.push_back(
            fmt::format("stroke {}, sample {}: after {} s; begins a new stroke", number, i + 1, pause));
        strokes.push_back(stroke);
      }
      strokes.back().samples.push_back(samples[i]);
    }
  }
  recording.strokes = std::move(strokes);
  return lines;
}

std::vector<std::string> join(Recording& recording, double gap) {
  std::vector<std::string> lines;
  std::vector<RecordedStroke> strokes;
  for (std::size_t number = 1; number <= recording.strokes.size(); ++number) {
    RecordedStroke& stroke = recording.strokes[number - 1];
    const bool follows = !strokes.empty() && stroke.fields.time && same_kind(stroke, strokes.back()) &&
                         !stroke.samples.empty() && !strokes.back().samples.empty();
    const double pause = follows ? stroke.samples.front().time - strokes.back().samples.back().time : -1;
    if (pause < 0 || pause > gap) {
      strokes.push_back(std::move(stroke));
      continue;
    }
    lines.push_back(fmt::format("stroke {}: begins {} s after the one before; joined to it", number, pause));
    std::vector<Sample>& joined = strokes.back().samples;
    joined.insert(joined.end(), stroke.samples.begin(), stroke.samples.end());
  }
  recording.strokes = std::move(strokes);
  return lines;
}

std::vector<std::string> resample(Recording& recording, double rate) {
  std::vector<std::string> lines;
  double samples = 0;
  for (std::size_t i = 0; i < recording.strokes.size(); ++i) {
    RecordedStroke& stroke = recording.strokes[i];
    if (stroke.samples.empty()) continue;
    if (!stroke.fields.time || has_constant_time(stroke.samples)) {
      lines.push_back(fmt::format("stroke {}: has no times that rise; left as it is", i + 1));
      continue;
    }
    check_times(stroke, i + 1);
    check_count(stroke, rate, samples);
    std::vector<Sample> made = at_even_times(stroke.samples, rate);
    lines.push_back(
        fmt::format("stroke {}: {} samples became {}", i + 1, stroke.samples.size(), made.size()));
    stroke.samples = std::move(made);
  }
  return lines;
}

}  // namespace burin
