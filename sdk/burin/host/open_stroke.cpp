#include <burin/base/error.h>
#include <burin/deform/stroke_changes.h>
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
  if (!std::isfinite(strength)) throw ContractError("a stroke's strength is not finite");
  return settings;
}

}  // namespace

OpenStroke::OpenStroke(const Surface& surface, const Picker& picker, const burin_brush& brush,
                       const burin_brush_descriptor& descriptor, const StrokeSettings& settings)
    : surface_(&surface),
      settings_(checked(settings)),
      params_(descriptor, settings.params),
      tracer_(surface, picker, settings.radius),
      brush_stroke_(brush, descriptor, context(0), params_.abi()),
      last_time_(-std::numeric_limits<double>::infinity()) {}

VertexMoves OpenStroke::add(const SurfacePoint& at, double time, const Pen& pen, StrokeCharter& charter,
                            Evaluator& evaluator) {
  if (!std::isfinite(time) || time < last_time_)
    throw ContractError(fmt::format("time goes from {} to {}", last_time_, time));
  last_time_ = time;
  const bool first = empty();
  const double length_before = curve().length();
  tracer_.add(at, time, pen);
  const std::uint64_t pen_inputs =
      brush_stroke_.descriptor().inputs_read & pen_inputs_present(settings_.fields);
  Chart chart = first ? charter.chart(curve(), {settings_.radius, settings_.cap}) : charter.extend(curve());
  StrokeNodes nodes = make_stroke_nodes(std::move(chart), curve(), pen_inputs);
  const double end_zone = std::min(length_before, curve().length()) - brush_stroke_.plan().end_influence;
  const StrokeChanges changes = find_changes(nodes_, nodes, end_zone);
  VertexMoves moves = evaluate(evaluator, nodes, changes.stale, 0);
  for (const Index vertex : changes.left) {
    moves.vertices.push_back(vertex);
    moves.places.push_back(surface_->positions[vertex]);
  }
  nodes_ = std::move(nodes);
  return moves;
}

VertexMoves OpenStroke::finish(Evaluator& evaluator) {
  const double end_zone = curve().length() - brush_stroke_.plan().end_influence;
  return evaluate(evaluator, nodes_, nodes_from(nodes_.chart, end_zone), BURIN_STROKE_FINAL);
}

burin_stroke_context OpenStroke::context(std::uint64_t flags) const {
  burin_stroke_context context{};
  context.struct_size = sizeof(burin_stroke_context);
  context.flags = flags;
  context.pen_present = pen_inputs_present(settings_.fields);
  context.seed = settings_.seed;
  context.length = curve().length();
  context.radius_min = context.radius_max = settings_.radius;
  context.object_scale = surface_->scale;
  return context;
}

VertexMoves OpenStroke::evaluate(Evaluator& evaluator, const StrokeNodes& nodes,
                                 const std::vector<Index>& stale, std::uint64_t flags) const {
  const NodeSource source{*surface_, nodes, static_cast<float>(settings_.radius)};
  const std::span<const Vec3f> places = evaluator.evaluate(brush_stroke_, context(flags), source, stale,
                                                           static_cast<float>(settings_.strength));
  VertexMoves moves;
  moves.places.assign(places.begin(), places.end());
  moves.vertices.reserve(stale.size());
  for (const Index node : stale) moves.vertices.push_back(nodes.chart.vertex[node]);
  return moves;
}

}  // namespace burin
