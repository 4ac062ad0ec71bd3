// What the caller got wrong is found before a session is called, which would drop the open stroke.
#include <burin/base/error.h>
#include <burin/host/c/call.h>
#include <burin/host/c/pen_fields.h>
#include <burin/host/c/pen_input.h>
#include <burin/host/c/stroke_texts.h>
#include <fmt/format.h>

#include <cmath>

namespace burin::c {
namespace {

/// Throws plugin::Error if there is no such brush.
void find_brush(const ReplaySettings& settings, const BrushLibrary& brushes) {
  if (settings.along.given()) return;
  try {
    brushes.find(settings.brush);
  } catch (const Error& fault) {
    throw plugin::Error(fault.what(), BURIN_NOT_FOUND);
  }
}

bool all_finite(const Vec3d& v) { return v.cast<float>().allFinite(); }

}  // namespace

ReplaySettings stroke_settings(const burin_stroke* stroke, const BrushLibrary& brushes, bool may_refine) {
  const burin_stroke given = known_members(stroke, stroke && BURIN_HAS(stroke, burin_stroke, seed), "stroke");
  require(given.settings, "settings");
  const GivenSettings texts = read_texts(given.settings, brushes, may_refine);
  ReplaySettings settings = texts.complete();
  if (texts.find(&ReplaySettings::show_every))
    reject("show_every: is for recordings; how many samples a call has decides when they are shown");
  if (settings.brush.empty() && !settings.along.given()) reject("settings lack the brush");
  if (!texts.find(&StrokeSettings::radius)) reject("settings lack the radius");
  settings.fields = fields_of(given.fields);
  settings.seed = given.seed;
  if (settings.stabilising.kind == Stabilising::Kind::exponential && !settings.fields.time)
    reject("stabilise: the exponential filter wants BURIN_PEN_TIME");
  find_brush(settings, brushes);
  return settings;
}

void PenInput::check(const PenSample& given, std::uint64_t number, double last_time) const {
  const Pen& pen = given.sample.pen;
  const auto refuse = [&](const char* what) { reject(fmt::format("sample {}: {}", number, what)); };
  if (!all_finite(given.sample.position)) refuse("its position is not finite");
  if (!all_finite(given.direction)) refuse("its direction is not finite");
  if (!std::isfinite(given.sample.time) || given.sample.time < last_time) refuse("its time falls");
  if (!(pen.pressure >= 0 && pen.pressure <= 1)) refuse("its pressure is not from 0 to 1");
  if (!std::isfinite(pen.tilt_x) || !std::isfinite(pen.tilt_y) || !std::isfinite(pen.twist))
    refuse("its tilt or twist is not finite");
  if (given.is_ray() && smooths_) refuse("rays cannot be stabilised");
}

std::vector<PenSample> PenInput::read(const burin_sample* given, std::uint64_t count) const {
  require(given, "samples");
  std::vector<PenSample> samples(count);
  read_samples(given, count, [&](const burin_sample& known, std::uint64_t i) {
    samples[i].sample.position = Vec3d(known.position[0], known.position[1], known.position[2]);
    samples[i].direction = Vec3d(known.direction[0], known.direction[1], known.direction[2]);
    read_pen(known, fields_, samples[i].sample);
    const double time = samples[i].sample.time;
    check(samples[i], i, i > 0 ? samples[i - 1].sample.time : last_time_.value_or(time));
  });
  return samples;
}

PenSample PenInput::take(const PenSample& given) {
  last_time_ = given.sample.time;
  if (given.is_ray()) return given;
  return {stabiliser_.add(given.sample)};
}

std::optional<PenSample> PenInput::finish() const {
  const std::optional<Sample> last = smooths_ ? stabiliser_.finish() : std::nullopt;
  if (!last) return std::nullopt;
  return PenSample{*last};
}

std::vector<PenSample> path_of(const burin_stroke& given, const ReplaySettings& settings) {
  const burin_stroke known = plugin::complete(given);
  if (!known.path) return {};
  PenInput pen(settings);
  std::vector<PenSample> path = pen.read(known.path, known.path_count);
  if (settings.refining.kind == Refining::Kind::off) return {};
  for (PenSample& sample : path) sample = pen.take(sample);
  if (const auto last = pen.finish()) path.push_back(*last);
  return path;
}

}  // namespace burin::c
