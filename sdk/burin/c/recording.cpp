// Recordings for C: their strokes as the settings and samples that sessions take.
#include <burin/host/c/call.h>
#include <burin/host/c/handles.h>
#include <burin/host/c/pen_fields.h>
#include <burin/host/c/whole_recording.h>
#include <burin/stroke/files/setting_texts.h>
#include <burin/stroke/sample_times.h>

#include <memory>
#include <utility>

namespace burin::c {
namespace {

/// What a burin_recording_stroke points to.
struct Stroke {
  std::vector<std::string> texts;
  std::vector<const char*> settings;  ///< ended by a null pointer
  std::uint32_t fields;
  std::vector<burin_sample> samples;
  DrawnBy drawn_by;
};

burin_sample sample_of(const Sample& from, const Recording& recording) {
  burin_sample sample{};
  sample.struct_size = sizeof sample;
  write_pen(from, sample);
  Vec3d position = from.position, direction = Vec3d::Zero();
  if (recording.space == StrokeSpace::screen) {
    const Ray ray = pixel_ray(*recording.camera, position.x(), position.y());
    position = ray.origin.cast<double>();
    direction = ray.direction.cast<double>();
  }
  Eigen::Map<Vec3d>(sample.position) = position;
  Eigen::Map<Vec3d>(sample.direction) = direction;
  return sample;
}

Stroke stroke_of(const RecordedStroke& from, const Recording& recording) {
  Stroke stroke{setting_texts(from.settings), {}, bits_of(from.fields), {}, from.drawn_by};
  for (const std::string& text : stroke.texts) stroke.settings.push_back(text.c_str());
  stroke.settings.push_back(nullptr);
  for (const Sample& sample : from.samples) stroke.samples.push_back(sample_of(sample, recording));
  return stroke;
}

}  // namespace
}  // namespace burin::c

struct burin_recording {
  std::string device;
  std::vector<burin::c::Stroke> strokes;
};

using namespace burin;

burin_status burin_recording_read(const char* path, burin_recording** recording, burin_text* error) {
  return plugin::guarded(error, [&] {
    c::require(path, "path");
    c::require(recording, "recording");
    Recording read = c::read_whole_recording(path);
    repair_times(read);
    auto made = std::make_unique<burin_recording>();
    made->device = read.device;
    for (const RecordedStroke& stroke : read.strokes) made->strokes.push_back(c::stroke_of(stroke, read));
    *recording = made.release();
  });
}

void burin_recording_destroy(burin_recording* recording) { delete recording; }

uint64_t burin_recording_stroke_count(const burin_recording* recording) {
  return recording ? recording->strokes.size() : 0;
}

const char* burin_recording_device(const burin_recording* recording) {
  return recording ? recording->device.c_str() : nullptr;
}

burin_status burin_recording_get_stroke(const burin_recording* recording, uint64_t index,
                                        burin_recording_stroke* stroke, burin_text* error) {
  return plugin::guarded(error, [&] {
    c::require(recording, "recording");
    if (index >= recording->strokes.size())
      throw plugin::Error("the recording has no stroke " + std::to_string(index), BURIN_NOT_FOUND);
    const c::Stroke& from = recording->strokes[index];
    const burin_recording_stroke known{.struct_size = 0,
                                       .fields = from.fields,
                                       .settings = from.settings.data(),
                                       .seed = index,
                                       .samples = from.samples.data(),
                                       .sample_count = from.samples.size(),
                                       .tool = from.drawn_by.tool.c_str(),
                                       .eraser = from.drawn_by.eraser ? 1U : 0U,
                                       .reserved = 0};
    c::give(known, stroke, stroke && BURIN_HAS(stroke, burin_recording_stroke, sample_count), "stroke");
  });
}
