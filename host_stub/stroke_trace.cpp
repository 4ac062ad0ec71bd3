#include "stroke_trace.h"

namespace burin {
namespace {

std::optional<SurfacePoint> place(const Picker& picker, const Recording& recording, const Vec3d& position,
                                  double radius) {
  if (recording.space == StrokeSpace::object) {
    return picker.closest(position.cast<float>(), static_cast<float>(radius));
  }
  return picker.pick(pixel_ray(*recording.camera, position.x(), position.y()));
}

}  // namespace

SurfaceCurve trace_stroke(const Surface& surface, const Picker& picker, const Recording& recording,
                          const RecordedStroke& stroke, double radius) {
  CurveTracer tracer(surface, picker, radius);
  for (const Sample& sample : stroke.samples) {
    const auto point = place(picker, recording, sample.position, radius);
    if (point && tracer.connects(*point)) tracer.add(*point, sample.time, sample.pen);
  }
  return tracer.curve();
}

}  // namespace burin
