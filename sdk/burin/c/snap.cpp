// Snapping for C: samples of a stroke become those of a stroke along a line of the surface.
#include <burin/feature/snap.h>
#include <burin/host/c/call.h>
#include <burin/host/c/handles.h>
#include <burin/host/c/pen_fields.h>
#include <burin/stroke/curve/stroke_trace.h>

#include <cmath>
#include <utility>

namespace burin::c {
namespace {

FeatureKind kind_of(const burin_snap& how) { return static_cast<FeatureKind>(how.line - BURIN_LINE_RIDGE); }

void check(const burin_snap& how) {
  if (how.line < BURIN_LINE_RIDGE || how.line > BURIN_LINE_SUGGESTIVE) reject("there is no such line");
  if (!(how.radius > 0) || !std::isfinite(how.radius)) reject("the radius is not above 0");
  if (!(how.scale >= 0) || !std::isfinite(how.scale)) reject("the scale is below 0");
  if (!(how.significance >= 0)) reject("the significance is below 0");
  const Vec3d view(how.view[0], how.view[1], how.view[2]);
  if (!view.allFinite()) reject("the view is not finite");
  if (is_seen(kind_of(how)) && !how.view_is_eye && view.isZero(0)) reject("the line wants a view");
  if (has_values(kind_of(how))) require(how.values, "values");
  if (!(how.least_angle >= 0 && how.least_angle < 180)) reject("the least angle is not below 180");
}

/// The values of the surface's vertices.
std::vector<float> values_of(const burin_session& session, const float* values) {
  std::vector<float> of_surface;
  const Index count = session.session.surface().vertex_count();
  of_surface.reserve(count);
  for (Index vertex = 0; vertex < count; ++vertex) {
    of_surface.push_back(values[session.order.of_surface(vertex)]);
    if (!std::isfinite(of_surface.back())) reject("a value is not finite");
  }
  return of_surface;
}

/// A stroke with these samples, which must lie on the surface or meet it.
RecordedStroke stroke_of(const burin_session& session, const burin_sample* samples, std::uint64_t count,
                         const PenFields& fields) {
  RecordedStroke stroke;
  stroke.fields = fields;
  read_samples(samples, count, [&](const burin_sample& from, std::uint64_t i) {
    Sample sample;
    read_pen(from, fields, sample);
    sample.position = Eigen::Map<const Vec3d>(from.position);
    const Vec3d direction = Eigen::Map<const Vec3d>(from.direction);
    if (!sample.position.allFinite() || !direction.allFinite()) reject("a sample is not finite");
    if (!direction.isZero(0)) {
      const auto hit =
          session.session.picker().pick({sample.position.cast<float>(), direction.cast<float>()});
      if (!hit) throw Error("sample " + std::to_string(i) + " misses the surface");
      sample.position = hit->position.cast<double>();
    }
    stroke.samples.push_back(sample);
  });
  return stroke;
}

SurfaceCurve curve_of(const burin_session& session, const RecordedStroke& stroke, double radius) {
  const CurveGround ground(session.session.surface(), session.session.picker());
  std::vector<SurfaceCurve> pieces =
      trace_stroke(ground, {}, stroke, {.radius = radius, .width = StrokeWidth()});
  if (pieces.size() != 1)
    throw Error(pieces.empty() ? "the stroke does not meet the surface"
                               : "the stroke leaves the surface on its way");
  return std::move(pieces.front());
}

std::vector<burin_sample> samples_of(const SurfaceCurve& curve) {
  std::vector<burin_sample> samples;
  for (const CurvePoint& point : curve.points) {
    burin_sample sample{};
    sample.struct_size = sizeof sample;
    write_pen({point.time, {}, point.pen}, sample);
    Eigen::Map<Vec3d>(sample.position) = point.at.position.cast<double>();
    samples.push_back(sample);
  }
  return samples;
}

SnapResult snap(const burin_session& session, const burin_snap& how, const RecordedStroke& stroke) {
  Feature feature{.kind = kind_of(how)};
  if (how.least_angle > 0) feature.least_angle = how.least_angle;
  feature.view = {how.view_is_eye != 0, Vec3d(how.view[0], how.view[1], how.view[2])};
  std::vector<float> values;
  if (has_values(feature.kind)) values = values_of(session, how.values);
  feature.values = values;
  SnapOptions options{.radius = how.radius, .scale = how.scale, .fixed_ends = how.fixed_ends != 0};
  if (how.significance > 0) options.significance = how.significance;
  StrokeSnapper snapper(session.session.surface(), session.session.picker());
  return snapper.snap(curve_of(session, stroke, how.radius), feature, options);
}

}  // namespace
}  // namespace burin::c

using namespace burin;

burin_status burin_session_snap(burin_session* session, const burin_snap* how, const burin_sample* samples,
                                uint64_t count, uint32_t fields, burin_snapped* snapped, burin_text* error) {
  return c::in_session(session, error, [&] {
    c::require(samples, "samples");
    if (session->stroke) c::reject("a stroke is open");
    const burin_snap known = c::known_members(how, how && BURIN_HAS(how, burin_snap, values), "how");
    c::check(known);
    const bool has_first = snapped && BURIN_HAS(snapped, burin_snapped, mean_move);
    if (!has_first) c::reject("snapped is missing or too small");
    const SnapResult result =
        c::snap(*session, known, c::stroke_of(*session, samples, count, c::fields_of(fields)));
    session->snapped = c::samples_of(result.curve);
    const burin_snapped given{.struct_size = 0,
                              .reserved = 0,
                              .samples = session->snapped.data(),
                              .sample_count = session->snapped.size(),
                              .share = result.snapped_share,
                              .significance = result.significance,
                              .mean_move = result.mean_move};
    c::give(given, snapped, has_first, "snapped");
  });
}
