// Traces the curve that a stroke through some places will have, on the surface as it is.
#include <burin/along/along_parts.h>
#include <burin/host/session/stroke_lines.h>
#include <burin/stroke/curve/surface_curve.h>

#include <optional>
#include <utility>

namespace burin {

double refined_edge(const StrokeSettings& settings) {
  const Refining& refining = settings.refining;
  return refining.kind == Refining::Kind::edge ? refining.edge : settings.radius / Refining::fine;
}

double reach_of(const StrokeSettings& settings) {
  const double wide = settings.along.given() ? AlongParts::chart_radii : 1;
  return wide * settings.radius + refined_edge(settings);
}

std::span<const Vec3f> judged_positions(const StrokeGround& ground, const StrokeSettings& settings) {
  const bool is_automatic = settings.refining.kind == Refining::Kind::automatic;
  return is_automatic ? ground.given.positions(ground.surface) : ground.surface.positions;
}

namespace {

void append(const SurfaceCurve& curve, const Picker& picker, const SymmetryInstance& image, double radius,
            StrokeLines& lines) {
  std::vector<Vec3d> line;
  for (const CurvePoint& point : curve.points) {
    const Vec3d there = image(point.at.position.cast<double>());
    const auto at = picker.closest(there.cast<float>(), static_cast<float>(radius));
    if (!at) continue;
    line.push_back(there);
    lines.triangles.push_back(at->triangle);
  }
  if (!line.empty()) lines.points.push_back(std::move(line));
}

}  // namespace

StrokeLines lines_through(const StrokeGround& ground, const StrokeSettings& settings,
                          std::span<const Vec3d> path) {
  const auto& [surface, picker, given] = ground;
  std::vector<SurfaceCurve> curves;
  std::optional<CurveTracer> tracer;
  double time = 0;
  for (const Vec3d& place : path) {
    const auto at = picker.closest(place.cast<float>(), static_cast<float>(settings.radius));
    if (tracer && !(at && tracer->connects(*at))) {
      curves.push_back(tracer->curve());
      tracer.reset();
    }
    if (!at) continue;
    if (!tracer) tracer.emplace(surface, picker, settings.radius);
    tracer->add(*at, time++, {});
  }
  if (tracer) curves.push_back(tracer->curve());
  StrokeLines lines;
  for (const SymmetryInstance& image : symmetry_instances(settings.symmetry))
    for (const SurfaceCurve& curve : curves) append(curve, picker, image, settings.radius, lines);
  return lines;
}

}  // namespace burin
