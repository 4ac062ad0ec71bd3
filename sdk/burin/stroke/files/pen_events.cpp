// Groups a recorder's events into strokes and fits these into a viewport.
#include <burin/base/error.h>
#include <burin/stroke/files/pen_events.h>
#include <burin/stroke/files/recording_faults.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <string>
#include <utility>

namespace burin {
namespace {

using Box = Eigen::AlignedBox2d;

/// Makes one stroke of each run of events in which a pointer touches the tablet.
class ContactRuns {
 public:
  ContactRuns(const PenFields& fields, ImportCounts& counts) : fields_(fields), counts_(counts) {}

  void take(const PenEvent& event);
  std::vector<RecordedStroke> strokes() && { return std::move(strokes_); }

 private:
  std::size_t begin() {
    strokes_.emplace_back().fields = fields_;
    return strokes_.size() - 1;
  }

  PenFields fields_;
  ImportCounts& counts_;
  std::vector<RecordedStroke> strokes_;
  std::map<double, std::size_t> open_;  ///< the stroke of each pointer that is down
};

void ContactRuns::take(const PenEvent& event) {
  const auto open = open_.find(event.pointer);
  if (!event.contact) {
    ++counts_.lifted;
    if (open != open_.end()) open_.erase(open);
    return;
  }
  const std::size_t stroke = open != open_.end() ? open->second : begin();
  open_[event.pointer] = stroke;
  std::vector<Sample>& samples = strokes_[stroke].samples;
  const double earliest = samples.empty() ? event.sample.time : samples.back().time;
  if (event.sample.time < earliest) ++counts_.times_raised;
  samples.push_back(event.sample);
  samples.back().time = std::max(event.sample.time, earliest);
}

/// Removes the pressure of all strokes if it is 0 in all events in contact, since such a recorder has none.
void drop_void_pressure(std::vector<RecordedStroke>& strokes, ImportCounts& counts) {
  const auto pressed = [](const RecordedStroke& stroke) {
    return !stroke.fields.pressure ||
           std::ranges::any_of(stroke.samples, [](const Sample& sample) { return sample.pen.pressure > 0; });
  };
  if (std::ranges::any_of(strokes, pressed)) return;
  counts.pressures_dropped = strokes.size();
  for (RecordedStroke& stroke : strokes) {
    stroke.fields.pressure = false;
    for (Sample& sample : stroke.samples) sample.pen.pressure = Pen{}.pressure;
  }
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

std::vector<RecordedStroke> contact_strokes(const PenEvents& recorded, ImportCounts& counts) {
  counts.events = recorded.events.size();
  ContactRuns runs(recorded.fields, counts);
  for (const PenEvent& event : recorded.events) runs.take(event);
  return std::move(runs).strokes();
}

Import import_of(const std::filesystem::path& path, const PenEvents& recorded, const Camera& camera) {
  ImportCounts counts;
  std::vector<RecordedStroke> strokes = contact_strokes(recorded, counts);
  return import_of(path, std::move(strokes), counts, camera);
}

Import import_of(const std::filesystem::path& path, std::vector<RecordedStroke> strokes,
                 const ImportCounts& counts, const Camera& camera) {
  if (const std::string_view fault = validation_error(camera); !fault.empty())
    throw ContractError(std::string(fault));
  Import import;
  import.counts = counts;
  Recording& recording = import.recording;
  recording.space = StrokeSpace::screen;
  recording.camera = camera;
  recording.strokes = std::move(strokes);
  if (recording.strokes.empty()) throw FileError(path.string(), "holds no stroke");
  drop_void_pressure(recording.strokes, import.counts);
  fit_to_viewport(recording.strokes, camera);
  return import;
}

}  // namespace burin
