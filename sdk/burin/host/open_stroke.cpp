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

OpenStroke::OpenStroke(const Surface& surface, const Picker& picker, const burin_brush& brush,
                       const burin_brush_descriptor& descriptor, const StrokeSettings& settings)
    : surface_(&surface),
      settings_(checked(settings)),
      params_(descriptor, settings.params),
      tracer_(surface, picker, settings.radius, settings.fields.pressure ? settings.pressure_width : 0),
      brush_stroke_(brush, descriptor, context(0), params_.abi()),
      last_time_(-std::numeric_limits<double>::infinity()) {}

VertexMoves OpenStroke::add(const SurfacePoint& at, double time, const Pen& pen, StrokeCharter& charter,
                            Evaluator& evaluator, StageClock& clock) {
  if (!std::isfinite(time) || time < last_time_)
    throw ContractError(fmt::format("time goes from {} to {}", last_time_, time));
  last_time_ = time;
  const bool first = empty();
  const double length_before = curve().length();
  tracer_.add(at, time, pen);
  clock.lap(Stage::curve);
  Chart chart = first ? charter.chart(curve(), chart_options()) : charter.extend(curve());
  clock.lap(Stage::chart);
  const double end_zone = std::min(length_before, curve().length()) - brush_stroke_.plan().end_influence;
  return go_on_to(make_nodes(std::move(chart)), end_zone, 0, evaluator, clock);
}

VertexMoves OpenStroke::finish(Closure closure, StrokeCharter& charter, Evaluator& evaluator,
                               StageClock& clock) {
  closed_curve_ = tracer_.closed_curve(closure);
  clock.lap(Stage::curve);
  if (closed_curve_) {
    constexpr double everywhere = -std::numeric_limits<double>::infinity();
    Chart chart = charter.chart(curve(), chart_options());
    clock.lap(Stage::chart);
    return go_on_to(make_nodes(std::move(chart)), everywhere, BURIN_STROKE_CLOSED | BURIN_STROKE_FINAL,
                    evaluator, clock);
  }
  const double end_zone = curve().length() - brush_stroke_.plan().end_influence;
  return go_on_to(nodes_, end_zone, BURIN_STROKE_FINAL, evaluator, clock);
}

burin_stroke_context OpenStroke::context(std::uint64_t flags) const {
  burin_stroke_context context{};
  context.struct_size = sizeof(burin_stroke_context);
  context.flags = flags;
  context.pen_present = pen_inputs_present(settings_.fields);
  context.seed = settings_.seed;
  context.length = curve().length();
  context.radius_min = settings_.radius * (width_varies() ? narrowest_width(settings_.pressure_width) : 1);
  context.radius_max = settings_.radius;
  context.object_scale = surface_->scale;
  return context;
}

StrokeNodes OpenStroke::make_nodes(Chart chart) const {
  std::uint64_t varying = pen_inputs_present(settings_.fields);
  if (width_varies()) varying |= BURIN_INPUT_RADIUS;
  return make_stroke_nodes(std::move(chart), curve(), settings_.radius,
                           varying & brush_stroke_.descriptor().inputs_read);
}

/// Makes these the stroke's nodes. Only those that changed are evaluated.
VertexMoves OpenStroke::go_on_to(StrokeNodes nodes, double end_zone, std::uint64_t flags,
                                 Evaluator& evaluator, StageClock& clock) {
  const StrokeChanges changes = find_changes(nodes_, nodes, end_zone, brush_stroke_.descriptor().inputs_read);
  evaluate(nodes, changes, flags, evaluator);
  nodes_ = std::move(nodes);
  clock.lap(Stage::evaluate);
  VertexMoves moved = moves(changes);
  clock.lap(Stage::blend);
  return moved;
}

void OpenStroke::evaluate(const StrokeNodes& nodes, const StrokeChanges& changes, std::uint64_t flags,
                          Evaluator& evaluator) {
  const NodeSource source{*surface_, nodes, static_cast<float>(settings_.radius)};
  const std::span<const Vec3f> evaluated = evaluator.evaluate(
      brush_stroke_, context(flags), source, changes.stale, static_cast<float>(settings_.strength));
  std::vector<Vec3f> displacement(nodes.chart.size());
  for (std::size_t node = 0; node < displacement.size(); ++node)
    if (changes.before[node] != no_index) displacement[node] = displacement_[changes.before[node]];
  for (std::size_t i = 0; i < evaluated.size(); ++i) displacement[changes.stale[i]] = evaluated[i];
  displacement_ = std::move(displacement);
}

VertexMoves OpenStroke::moves(const StrokeChanges& changes) const {
  VertexMoves moves;
  moves.places.resize(changes.altered.size());
  blend_sheets(*surface_, chart(), displacement_, changes.altered, settings_.overlap,
               brush_stroke_.descriptor().id, moves.places);
  for (const Index node : changes.altered) moves.vertices.push_back(chart().vertex[node]);
  for (const Index vertex : changes.left) {
    moves.vertices.push_back(vertex);
    moves.places.push_back(surface_->positions[vertex]);
  }
  return moves;
}

}  // namespace burin
