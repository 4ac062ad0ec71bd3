// Finds the nodes whose outputs an event changes. Costs O(1) per node that the chart's last event computed,
// and per node near the stroke's end.
#include <burin/abi/stroke.h>
#include <burin/base/parallel.h>
#include <burin/deform/evaluate/stroke_nodes.h>

#include <limits>
#include <span>
#include <utility>

namespace burin {
namespace {

NodePen node_pen(const PenAt& at, std::uint64_t inputs) {
  NodePen pen;
  if (inputs & BURIN_INPUT_PRESSURE) pen.pressure = at.pen.pressure;
  if (inputs & BURIN_INPUT_TILT) {
    pen.tilt_x = at.pen.tilt_x;
    pen.tilt_y = at.pen.tilt_y;
  }
  if (inputs & BURIN_INPUT_TWIST) pen.twist = at.pen.twist;
  if (inputs & BURIN_INPUT_SPEED) pen.speed = static_cast<float>(at.speed);
  if (inputs & BURIN_INPUT_TIME) pen.time = static_cast<float>(at.time);
  return pen;
}

}  // namespace

StrokeChanges StrokeNodes::follow(const SurfaceCurve& curve, double end_zone, double same_pen_up_to,
                                  const StrokeEnds& ends) {
  ++event_;
  collect(same_pen_up_to, end_zone, ends);
  compare_pens(curve);
  if (ends.distances) compare_end_distances(*ends.distances);
  altered_listed_ = true;
  changes_.vertices.assign(chart_->altered().begin(), chart_->altered().end());
  stale_in_.resize(chart().size());
  for (std::size_t i = 0; i < asked_.size(); ++i)
    if (chart_->changed(asked_[i]) || differs_[i] || chart().t[asked_[i]] >= end_zone) add_stale(asked_[i]);
  // Otherwise the zone was collected.
  if (!ends.distances) add_zone(end_zone, chart_->computed_from());
  if (reads_.inputs & (BURIN_INPUT_SHEET | BURIN_INPUT_VISIT_COUNT)) add_other_sheets();
  return finished();
}

StrokeChanges StrokeNodes::in_zone(double end_zone) {
  ++event_;
  altered_listed_ = false;
  stale_in_.resize(chart().size());
  add_zone(end_zone, std::numeric_limits<double>::infinity());
  return finished();
}

/// Adds all nodes of altered vertices, since the number of sheets there may have changed.
void StrokeNodes::add_other_sheets() {
  for (const Index vertex : chart_->altered())
    for (Index slot = chart_->first(vertex); slot != no_index; slot = chart_->next(slot)) add_stale(slot);
}

/// Collects the nodes that the last event computed, and earlier nodes whose values may differ nevertheless:
/// coinciding samples change the pen but not the curve, and what is added to the curve changes the distances
/// from its ends.
void StrokeNodes::collect(double same_pen_up_to, double end_zone, const StrokeEnds& ends) {
  asked_.clear();
  asked_in_.resize(chart().size());
  for (const Index slot : chart_->computed()) ask(slot);
  if (ends.distances) collect_ends(end_zone, ends.others_up_to);
  const bool varies = reads_.varying != 0 || dynamics_.any();
  if (!varies || same_pen_up_to >= chart_->computed_from()) return;
  for (Index slot = 0; slot < chart().size(); ++slot)
    if (const double t = t_of(slot); t >= same_pen_up_to && t < chart_->computed_from()) ask(slot);
}

void StrokeNodes::ask(Index slot) {
  if (std::exchange(asked_in_[slot], event_) != event_) asked_.push_back(slot);
}

/// Adds the nodes near the ends that the last event did not compute.
void StrokeNodes::collect_ends(double end_zone, double others_up_to) {
  const double before_computed = chart_->computed_from();
  for_each_in_zone(end_zone, before_computed, [this](Index slot) { ask(slot); });
  // No slot is near the begin for long: only as long as the stroke is short.
  if (others_up_to == -std::numeric_limits<double>::infinity()) return;
  const double to = std::min(end_zone, before_computed);
  for (Index slot = 0; slot < chart().size(); ++slot)
    if (const double t = t_of(slot); t <= others_up_to && t < to) ask(slot);
}

/// Updates pens, half widths and dynamics of the collected nodes, and records which differ.
void StrokeNodes::compare_pens(const SurfaceCurve& curve) {
  differs_.assign(asked_.size(), 0);
  const bool widths = reads_.varying & BURIN_INPUT_RADIUS, pens = reads_.varying & ~BURIN_INPUT_RADIUS;
  if (widths) half_width_.resize(chart().size());
  if (pens) pen_.resize(chart().size());
  dynamics_.resize(chart().size());
  if (!widths && !pens && !dynamics_.any()) return;
  const double loop = curve.closed ? curve.length() : 0;
  parallel_blocks(asked_.size(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Index slot = asked_[i];
      const PenAt at = pen_at(curve, chart().t[slot]);
      const auto note = [&](auto& values, const auto& value) {
        differs_[i] |= !(values[slot] == value);
        values[slot] = value;
      };
      if (widths) note(half_width_, static_cast<float>(reads_.radius * at.width));
      if (pens) note(pen_, node_pen(at, reads_.varying));
      if (dynamics_.any()) differs_[i] |= dynamics_.update(slot, at, loop);
    }
  });
}

/// Updates the distances of the collected nodes from the ends, and records which differ.
void StrokeNodes::compare_end_distances(const EndDistances& ends) {
  end_distance_.resize(chart().size());
  parallel_blocks(asked_.size(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Index slot = asked_[i];
      const float distance =
          ends.at(chart().t[slot], chart().d[slot], chart().e1[slot], chart().normal[slot]);
      differs_[i] |= distance != end_distance_[slot];
      end_distance_[slot] = distance;
    }
  });
}

void StrokeNodes::add_stale(Index slot) {
  if (stale_in_[slot] == event_) return;
  stale_in_[slot] = event_;
  changes_.stale.push_back(slot);
  add_vertex(slot);
}

void StrokeNodes::add_vertex(Index slot) {
  if (altered_listed_ && chart_->changed(slot)) return;
  const Index local = chart_->local_index_of(slot);
  if (altered_listed_ && chart_->is_altered(local)) return;
  if (local >= vertex_in_.size()) vertex_in_.resize(chart_->local_count());
  if (vertex_in_[local] == event_) return;
  vertex_in_[local] = event_;
  changes_.vertices.push_back(chart().vertex[slot]);
}

/// Adds the nodes of the end zone with t below `up_to`.
void StrokeNodes::add_zone(double end_zone, double up_to) {
  for_each_in_zone(end_zone, up_to, [this](Index slot) { add_stale(slot); });
}

template <class Use>
void StrokeNodes::for_each_in_zone(double end_zone, double up_to, const Use& use) {
  const auto count = static_cast<Index>(chart().size());
  for (const Index slot :
       zone_.find(end_zone, chart_->computed(), count, [this](Index s) { return t_of(s); })) {
    const double t = t_of(slot);
    if (t >= end_zone && t < up_to) use(slot);
  }
}

/// The t of a node; NaN if the slot is vacant, so that no comparison is true.
double StrokeNodes::t_of(Index slot) const {
  return chart_->vacant(slot) ? std::numeric_limits<double>::quiet_NaN() : chart().t[slot];
}

StrokeChanges StrokeNodes::finished() { return std::exchange(changes_, {}); }

std::uint64_t pen_inputs_present(const PenFields& fields) {
  std::uint64_t inputs = 0;
  if (fields.pressure) inputs |= BURIN_INPUT_PRESSURE;
  if (fields.tilt) inputs |= BURIN_INPUT_TILT;
  if (fields.twist) inputs |= BURIN_INPUT_TWIST;
  if (fields.time) inputs |= BURIN_INPUT_SPEED | BURIN_INPUT_TIME;
  return inputs;
}

}  // namespace burin
