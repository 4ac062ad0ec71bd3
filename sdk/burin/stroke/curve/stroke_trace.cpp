// Traces a recorded stroke on a surface, sample by sample and without a session. A curve ends where the pen
// leaves the surface or jumps over a gap.
#include <burin/stroke/curve/stroke_trace.h>

#include <burin/base/error.h>
#include <fmt/format.h>

#include <utility>

namespace burin {
namespace {

std::optional<CurveGround::Point> place(const CurveGround& ground, const Recording& recording,
                                        const Vec3d& position, double radius) {
  if (recording.space == StrokeSpace::object)
    return ground.closest(position.cast<float>(), static_cast<float>(radius));
  return ground.pick(pixel_ray(*recording.camera, position.x(), position.y()));
}

}  // namespace

ReplaySettings settings_to_trace(const std::string& path, const RecordedStroke& stroke, std::size_t number,
                                 const GivenSettings& given) {
  ReplaySettings settings = stroke.settings.complete();
  given.apply_to(settings);
  if (settings.radius > 0) return settings;
  throw FileError(path, fmt::format("stroke {} has no radius: give one with --radius", number + 1));
}

TraceOptions trace_options(const ReplaySettings& settings, const PenFields& fields, std::size_t number) {
  const DrivenStroke driven{fields, settings.radius, number};
  return {.radius = settings.radius,
          .closure = settings.closure,
          .width = StrokeWidth(settings.pressure_width, settings.dynamics, driven)};
}

std::vector<SurfaceCurve> trace_stroke(const CurveGround& ground, const Recording& recording,
                                       const RecordedStroke& stroke, const TraceOptions& options) {
  std::vector<SurfaceCurve> pieces;
  CurveTracer tracer(ground, options.radius, options.width);
  const auto end_piece = [&](Closure of_piece) {
    if (auto closed = tracer.closed_curve(of_piece))
      pieces.push_back(*std::move(closed));
    else if (!tracer.curve().points.empty())
      pieces.push_back(tracer.curve());
    tracer = CurveTracer(ground, options.radius, options.width);
  };
  // If a stroke has several pieces, a piece closes only if it returns to its start by itself.
  const Closure of_a_piece = options.closure == Closure::automatic ? options.closure : Closure::open;
  for (const Sample& sample : stroke.samples) {
    const auto at = place(ground, recording, sample.position, options.radius);
    if (!at || !tracer.connects(*at)) end_piece(of_a_piece);
    if (at) tracer.add(*at, sample.time, sample.pen);
  }
  end_piece(pieces.empty() ? options.closure : of_a_piece);
  return pieces;
}

}  // namespace burin
