#pragma once
#include <burin/stroke/curve/surface_curve.h>
#include <burin/surface/picker.h>
#include <burin/surface/surface.h>

#include <functional>
#include <vector>

namespace burin::test {

/// `count` points of a curve over [0, 1], evenly spaced in the parameter.
inline std::vector<Vec3d> sampled(int count, const std::function<Vec3d(double)>& curve) {
  std::vector<Vec3d> samples;
  for (int i = 0; i < count; ++i) samples.push_back(curve(static_cast<double>(i) / (count - 1)));
  return samples;
}

/// The surface curve of samples near the surface that are 1/240 s apart.
inline SurfaceCurve traced(const CurveGround& ground, const Picker& picker, double radius,
                           const std::vector<Vec3d>& samples) {
  CurveTracer tracer(ground, radius);
  double time = 0;
  for (const Vec3d& sample : samples) {
    const auto at = picker.closest(sample.cast<float>(), static_cast<float>(radius));
    if (at) tracer.add(*at, time, {});
    time += 1. / 240;
  }
  return tracer.curve();
}

inline SurfaceCurve traced(const Surface& surface, const Picker& picker, double radius,
                           const std::vector<Vec3d>& samples) {
  return traced(CurveGround(surface, picker), picker, radius, samples);
}

}  // namespace burin::test
