// Selects the strokes of a pen file, and converts them to a recording.
#include <burin/ink/pen_strokes.h>
#include <burin/stroke/recording.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace burin {
void keep_chosen(PenFile& file, const PenChoice& choice) {
  std::erase_if(file.strokes, [&](const PenStroke& stroke) {
    return choice.page.value_or(stroke.page) != stroke.page ||
           choice.layer.value_or(stroke.layer) != stroke.layer;
  });
}

void press_by_width(PenFile& file) {
  float widest = 0;
  for (const PenStroke& stroke : file.strokes)
    for (const float width : stroke.widths)
      if (std::isfinite(width)) widest = std::max(widest, width);
  if (widest == 0) return;
  for (PenStroke& stroke : file.strokes) {
    if (stroke.fields.pressure || stroke.widths.empty()) continue;
    stroke.fields.pressure = true;
    for (std::size_t i = 0; i < stroke.samples.size(); ++i) {
      const float width = std::isfinite(stroke.widths[i]) ? std::max(stroke.widths[i], 0.F) : 0.F;
      stroke.samples[i].pen.pressure = width / widest;
    }
  }
}

Recording recording_of(PenFile file) {
  Recording recording;
  const bool in_space = std::ranges::all_of(file.strokes, &PenStroke::has_z);
  recording.space = in_space ? StrokeSpace::object : StrokeSpace::screen;
  recording.device = std::move(file.device);
  for (PenStroke& stroke : file.strokes) {
    RecordedStroke& made = recording.strokes.emplace_back();
    made.fields = stroke.fields;
    made.drawn_by = std::move(stroke.drawn_by);
    made.samples = std::move(stroke.samples);
    if (in_space) continue;
    for (Sample& sample : made.samples) {
      // Strokes in space have y up.
      if (stroke.has_z) sample.position.y() = -sample.position.y();
      sample.position.z() = 0;
    }
  }
  return recording;
}

PenFile pen_file_of(const Recording& recording) {
  const bool in_space = recording.space == StrokeSpace::object;
  PenFile file;
  file.kind = "stroke";
  file.device = recording.device;
  file.unit = in_space ? "" : "px";
  for (const RecordedStroke& stroke : recording.strokes) {
    PenStroke& made = file.strokes.emplace_back();
    made.fields = stroke.fields;
    made.drawn_by = stroke.drawn_by;
    made.has_z = in_space;
    made.samples = stroke.samples;
  }
  return file;
}

}  // namespace burin
