// Makes a recording of a pen file.
#include <burin/ink/pen_strokes.h>
#include <burin/stroke/files/pen_events.h>

#include <algorithm>
#include <limits>

namespace burin {
namespace {

/// The earliest time of all strokes, so that times stay small.
double first_time(const PenFile& file) {
  double first = std::numeric_limits<double>::infinity();
  for (const PenStroke& stroke : file.strokes)
    if (stroke.fields.time)
      for (const Sample& sample : stroke.samples) first = std::min(first, sample.time);
  return first;
}

RecordedStroke recorded(PenStroke& stroke, double start, ImportCounts& counts) {
  RecordedStroke made{.settings = {}, .fields = stroke.fields, .samples = std::move(stroke.samples)};
  double last = 0;
  for (Sample& sample : made.samples) {
    sample.position.z() = 0;
    if (!made.fields.time) continue;
    sample.time -= start;
    if (sample.time < last) ++counts.times_raised;
    last = sample.time = std::max(sample.time, last);
  }
  return made;
}

}  // namespace

Import import_pen_file(const PenFileText& text, const Camera& camera, const PenChoice& choice) {
  PenFile file = read_pen_file(text);
  std::erase_if(file.strokes, [&](const PenStroke& stroke) {
    return choice.page.value_or(stroke.page) != stroke.page ||
           choice.layer.value_or(stroke.layer) != stroke.layer;
  });
  ImportCounts counts;
  const double start = first_time(file);
  std::vector<RecordedStroke> strokes;
  for (PenStroke& stroke : file.strokes) {
    counts.events += stroke.samples.size();
    strokes.push_back(recorded(stroke, start, counts));
  }
  counts.events += file.hovering;
  counts.lifted = file.hovering;
  Import import = import_of(text.path, std::move(strokes), counts, camera);
  import.recording.device = file.device;
  return import;
}

}  // namespace burin
