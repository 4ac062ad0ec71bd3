// Makes a recording of a pen file that replays on a surface.
#include <burin/base/error.h>
#include <burin/ink/fit/fit_in_space.h>
#include <burin/ink/fit/fit_to_mesh.h>
#include <burin/ink/fit/fit_to_view.h>
#include <burin/ink/import_pen_file.h>
#include <burin/ink/no_pressure.h>
#include <burin/ink/pen_file.h>
#include <burin/stroke/files/recording_faults.h>
#include <burin/stroke/recording.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace burin {
namespace {

/// Removes the pressure of all strokes if it is 0 in all samples, since such a recorder has none.
void drop_void_pressure(std::vector<RecordedStroke>& strokes, ImportCounts& counts) {
  const auto pressed = [](const RecordedStroke& stroke) {
    return !stroke.fields.pressure ||
           std::ranges::any_of(stroke.samples, [](const Sample& sample) { return sample.pen.pressure > 0; });
  };
  if (std::ranges::any_of(strokes, pressed)) return;
  counts.pressures_dropped = strokes.size();
  for (RecordedStroke& stroke : strokes) leave_out_pressure(stroke);
}

/// The earliest time of all strokes; infinite if none has times.
double first_time(const std::vector<RecordedStroke>& strokes) {
  double first = std::numeric_limits<double>::infinity();
  for (const RecordedStroke& stroke : strokes)
    if (stroke.fields.time)
      for (const Sample& sample : stroke.samples) first = std::min(first, sample.time);
  return first;
}

/// Lets times count from the first one, and raises those that fall within a stroke.
void settle_times(std::vector<RecordedStroke>& strokes, ImportCounts& counts) {
  const double start = first_time(strokes);
  for (RecordedStroke& stroke : strokes) {
    if (!stroke.fields.time) continue;
    double last = 0;
    for (Sample& sample : stroke.samples) {
      sample.time -= start;
      if (sample.time < last) ++counts.times_raised;
      last = sample.time = std::max(sample.time, last);
    }
  }
}

/// Gives strokes without times those of a pen of this speed. Each begins where the stroke before ends.
void make_times(std::vector<RecordedStroke>& strokes, double speed) {
  double clock = 0;
  for (RecordedStroke& stroke : strokes) {
    if (stroke.samples.empty()) continue;
    if (!stroke.fields.time) {
      stroke.fields.time = true;
      const Sample* before = &stroke.samples.front();
      for (Sample& sample : stroke.samples) {
        sample.time = clock += (sample.position - before->position).norm() / speed;
        before = &sample;
      }
    }
    clock = std::max(clock, stroke.samples.back().time);
  }
}

void fit(const std::filesystem::path& path, Recording& recording, const PenImport& options, bool object_units,
         const Surface& surface) {
  if (recording.space == StrokeSpace::object) {
    if (!object_units) fit_into_box_of(recording.strokes, surface);
    put_on_surface(recording.strokes, surface);
  } else if (options.fit == PenFit::view) {
    fit_to_view(recording.strokes, *recording.camera);
  } else if (!fit_to_mesh(recording.strokes, *recording.camera, surface)) {
    throw FileError(path.string(), "the camera sees no place of the mesh where the strokes could lie");
  }
}

}  // namespace

Import import_pen_file(const std::filesystem::path& path, PenFile file, const PenImport& options,
                       const Camera& camera, const Surface& surface) {
  if (const std::string_view fault = validation_error(camera); !fault.empty())
    throw ContractError(std::string(fault));
  keep_chosen(file, options.choice);
  if (file.strokes.empty()) throw FileError(path.string(), "holds no stroke");
  if (options.pressure_from_width) press_by_width(file);
  const bool object_units = file.unit.empty();
  Import import;
  import.counts.lifted = import.counts.events = file.hovering;
  import.counts.estimated_y =
      static_cast<std::size_t>(std::ranges::count(file.strokes, true, &PenStroke::estimated_y));
  Recording& recording = import.recording = recording_of(std::move(file));
  recording.camera = camera;
  for (const RecordedStroke& stroke : recording.strokes) import.counts.events += stroke.samples.size();
  drop_void_pressure(recording.strokes, import.counts);
  settle_times(recording.strokes, import.counts);
  fit(path, recording, options, object_units, surface);
  if (options.speed) make_times(recording.strokes, *options.speed);
  for (const RecordedStroke& stroke : recording.strokes)
    if (!stroke.samples.empty() && !std::isfinite(stroke.samples.back().time))
      throw FileError(path.string(), "its times get too long");
  return import;
}

}  // namespace burin
