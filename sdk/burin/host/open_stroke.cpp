#include <burin/base/error.h>
#include <burin/deform/blend.h>
#include <burin/host/open_stroke.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace burin {
namespace {

/// A t that all nodes reach.
constexpr double everywhere = -std::numeric_limits<double>::infinity();

const StrokeSettings& checked(const StrokeSettings& settings) {
  // Brushes compute in floats.
  const auto radius = static_cast<float>(settings.radius), strength = static_cast<float>(settings.strength);
  if (!(std::isfinite(radius) && radius > 0))
    throw ContractError(fmt::format("a stroke's radius must be above 0, not {}", settings.radius));
  if (!(settings.pressure_width >= 0 && settings.pressure_width <= 1))
    throw ContractError(
        fmt::format("a stroke's pressure width must be from 0 to 1, not {}", settings.pressure_width));
  if (!std::isfinite(strength)) throw ContractError("a stroke's strength is not finite");
  return settings;
}

}  // namespace

OpenStroke::OpenStroke(const Surface& surface, const Picker& picker, StrokeCharter& charter,
                       const burin_brush& brush, const burin_brush_descriptor& descriptor,
                       const StrokeSettings& settings)
    : surface_(&surface),
      settings_(checked(settings)),
      params_(descriptor, settings.params),
      width_(settings.pressure_width, settings.dynamics, driven_stroke()),
      dynamics_(descriptor, params_.abi(), settings.dynamics, driven_stroke()),
      tracer_(surface, picker, settings.radius, width_),
      brush_stroke_(brush, descriptor, context(0), params_.abi()),
      last_time_(-std::numeric_limits<double>::infinity()),
      nodes_(charter.live(), read_inputs()) {
  charter.begin({.radius = settings_.radius, .cap = settings_.cap, .join = settings_.join});
}

ReadInputs OpenStroke::read_inputs() const {
  std::uint64_t varying = pen_inputs_present(settings_.fields);
  if (width_.varies()) varying |= BURIN_INPUT_RADIUS;
  const std::uint64_t inputs = brush_stroke_.descriptor().inputs_read;
  return {settings_.radius, inputs, varying & inputs, &dynamics_};
}

void OpenStroke::trace(const SurfacePoint& at, double time, const Pen& pen) {
  if (!std::isfinite(time) || time < last_time_)
    throw ContractError(fmt::format("time goes from {} to {}", last_time_, time));
  last_time_ = time;
  tracer_.add(at, time, pen);
  traced_ = true;
}

VertexMoves OpenStroke::draw(const StrokeTools& tools) { return draw_traced(0, tools); }

VertexMoves OpenStroke::draw_traced(std::uint64_t flags, const StrokeTools& tools) {
  const std::size_t unchanged = drawn_points_;
  const double length_before = drawn_length_;
  drawn_points_ = tracer_.final_points();
  drawn_length_ = curve().length();
  traced_ = false;
  chart(tools, unchanged);
  const double end_zone = std::min(length_before, drawn_length_) - brush_stroke_.plan().end_influence;
  const double same_pen_up_to = unchanged > 0 ? curve().points[unchanged - 1].t : everywhere;
  return go_on(nodes_.follow(curve(), end_zone, same_pen_up_to), flags, tools);
}

VertexMoves OpenStroke::finish(Closure closure, const StrokeTools& tools) {
  closed_curve_ = tracer_.closed_curve(closure);
  tools.clock.lap(Stage::curve);
  if (closed_curve_) {
    chart(tools, 0);
    return go_on(nodes_.follow(curve(), everywhere), BURIN_STROKE_CLOSED | BURIN_STROKE_FINAL, tools);
  }
  if (traced_) return draw_traced(BURIN_STROKE_FINAL, tools);
  const double end_zone = curve().length() - brush_stroke_.plan().end_influence;
  return go_on(nodes_.in_zone(end_zone), BURIN_STROKE_FINAL, tools);
}

void OpenStroke::chart(const StrokeTools& tools, std::size_t unchanged) {
  tools.charter.draw(curve(), unchanged);
  tools.cost.settled = tools.charter.settled();
  tools.cost.pushes = tools.charter.pushes();
  tools.clock.lap(Stage::chart);
}

burin_stroke_context OpenStroke::context(std::uint64_t flags) const {
  burin_stroke_context context{};
  context.struct_size = sizeof(burin_stroke_context);
  context.flags = flags;
  context.pen_present = pen_inputs_present(settings_.fields);
  context.seed = settings_.seed;
  context.length = curve().length();
  context.radius_min = settings_.radius * width_.narrowest();
  context.radius_max = settings_.radius;
  context.object_scale = surface_->scale;
  return context;
}

/// Evaluates what is stale, and tells where the vertices concerned go.
VertexMoves OpenStroke::go_on(const StrokeChanges& changes, std::uint64_t flags, const StrokeTools& tools) {
  const NodeSource source{*surface_, nodes_, static_cast<float>(settings_.radius)};
  const std::span<const Vec3f> evaluated = tools.evaluator.evaluate(
      brush_stroke_, context(flags), source, changes.stale, static_cast<float>(settings_.strength));
  displacement_.resize(nodes_.chart().size());
  for (std::size_t i = 0; i < evaluated.size(); ++i) displacement_[changes.stale[i]] = evaluated[i];
  tools.cost.evaluated = evaluated.size();
  tools.clock.lap(Stage::evaluate);

  VertexMoves moves;
  moves.places.resize(changes.vertices.size());
  blend_sheets(*surface_, nodes_.live(), displacement_, changes.vertices, settings_.overlap,
               brush_stroke_.descriptor().id, moves.places);
  moves.vertices = changes.vertices;
  tools.clock.lap(Stage::blend);
  return moves;
}

}  // namespace burin
