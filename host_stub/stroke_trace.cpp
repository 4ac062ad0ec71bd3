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

std::vector<SurfaceCurve> trace_stroke(const Surface& surface, const Picker& picker,
                                       const Recording& recording, const RecordedStroke& stroke,
                                       double radius) {
  std::vector<SurfaceCurve> pieces;
  CurveTracer tracer(surface, picker, radius);
  const auto end_piece = [&] {
    if (!tracer.curve().points.empty()) pieces.push_back(tracer.curve());
    tracer = CurveTracer(surface, picker, radius);
  };
  for (const Sample& sample : stroke.samples) {
    const auto point = place(picker, recording, sample.position, radius);
    if (!point || !tracer.connects(*point)) end_piece();
    if (point) tracer.add(*point, sample.time, sample.pen);
  }
  end_piece();
  return pieces;
}

}  // namespace burin
