#include <burin/base/error.h>
#include <burin/stroke/pen_events.h>
#include <burin/stroke/recording_faults.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <string>

namespace burin {
namespace {

using Box = Eigen::AlignedBox2d;

bool has_extent(const std::vector<Sample>& samples) {
  return std::any_of(samples.begin(), samples.end(),
                     [&](const Sample& sample) { return sample.position != samples.front().position; });
}

std::vector<RecordedStroke> runs_of_contact(const std::vector<PenEvent>& events, const PenFields& fields) {
  std::vector<RecordedStroke> strokes;
  bool down = false;
  for (const PenEvent& event : events) {
    if (event.contact && !down) strokes.emplace_back().fields = fields;
    down = event.contact;
    if (!down) continue;
    std::vector<Sample>& samples = strokes.back().samples;
    const double earliest = samples.empty() ? event.sample.time : samples.back().time;
    samples.push_back(event.sample);
    samples.back().time = std::max(event.sample.time, earliest);
  }
  return strokes;
}

Box box_of(const std::vector<RecordedStroke>& strokes) {
  Box box;
  for (const RecordedStroke& stroke : strokes)
    for (const Sample& sample : stroke.samples) box.extend(sample.position.head<2>());
  return box;
}

void fit_to_viewport(std::vector<RecordedStroke>& strokes, const Camera& camera) {
  constexpr double margin = 0.1;
  const Box box = box_of(strokes);
  const Eigen::Vector2d viewport(camera.width, camera.height);
  constexpr double least_extent = 1e-30;  // keeps the scale finite
  const double scale =
      ((1 - 2 * margin) * viewport.array() / box.sizes().array().max(least_extent)).minCoeff();
  for (RecordedStroke& stroke : strokes)
    for (Sample& sample : stroke.samples)
      sample.position.head<2>() = viewport / 2 + scale * (sample.position.head<2>() - box.center());
}

}  // namespace

Recording recording_of(const std::vector<PenEvent>& events, const PenFields& fields, const Camera& camera) {
  if (const std::string_view fault = fault_of(camera); !fault.empty())
    throw ContractError(std::string(fault));
  Recording recording;
  recording.space = StrokeSpace::screen;
  recording.camera = camera;
  recording.strokes = runs_of_contact(events, fields);
  std::erase_if(recording.strokes, [](const RecordedStroke& stroke) { return !has_extent(stroke.samples); });
  if (!recording.strokes.empty()) fit_to_viewport(recording.strokes, camera);
  return recording;
}

}  // namespace burin
