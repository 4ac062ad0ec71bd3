// Chooses between the nodes of the legs that meet at corners.
#include <burin/chart/joins/leg_choice.h>
#include <burin/math/elementary.h>

#include <cmath>

namespace burin {
namespace {

/// Whether a node is kept where another leg has a node, too.
bool wins(const LegEnd& end, const LegNode& node, double beyond, const LegNode& other, double other_beyond) {
  const bool less_far = end.first_leg ? beyond <= other_beyond : beyond < other_beyond;
  if (beyond > 0 || other_beyond > 0) return less_far;
  if (!end.continued) return true;
  return node.distance < other.distance || (node.distance == other.distance && less_far);
}

/// Whether two nodes tell of the vertex the same distance from the corner, so that their legs meet there.
/// Otherwise a leg has come back to the vertex by a bend farther on.
bool meet_there(const LegNode& a, double a_beyond, const LegNode& b, double b_beyond, double radius) {
  constexpr double alike = 0.5;  // radii
  const double from_a = math::hypot(a_beyond, static_cast<double>(a.frame.d));
  const double from_b = math::hypot(b_beyond, static_cast<double>(b.frame.d));
  return std::abs(from_a - from_b) <= alike * radius;
}

bool is_kept(const std::optional<LegEnd>& end, const LegNode& node, std::span<const LegNode> of_vertex,
             double radius) {
  if (!end) return true;
  const double near = corner_nearness * radius;
  const double beyond = way_beyond(end->corner, end->first_leg, node.frame.t);
  if (beyond < -near) return true;
  for (const LegNode& other : of_vertex) {
    if (&other == &node || other.part != part_of_leg(end->other_leg)) continue;
    const double other_beyond = way_beyond(end->corner, !end->first_leg, other.frame.t);
    if (other_beyond >= -near && meet_there(node, beyond, other, other_beyond, radius))
      return wins(*end, node, beyond, other, other_beyond);
  }
  return beyond <= 0 || on_own_side(end->corner, end->first_leg, node.frame);
}

}  // namespace

void choose_at_corners(std::span<LegNode> of_vertex, std::span<const LegEnds> ends, double radius) {
  for (LegNode& node : of_vertex) {
    const auto& [before, after] = ends[node.leg()];
    node.dropped = !is_kept(after, node, of_vertex, radius) || !is_kept(before, node, of_vertex, radius);
  }
}

}  // namespace burin
