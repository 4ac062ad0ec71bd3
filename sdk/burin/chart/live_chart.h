#pragma once
#include <burin/chart/chart.h>
#include <burin/chart/chart_frame.h>
#include <burin/chart/vertex_nodes.h>

#include <cstdint>
#include <span>
#include <vector>

namespace burin {

/// The chart of a stroke that is being drawn, and what the last event changed of it. Its nodes have slots,
/// which they keep from event to event; events cost in proportion to what they change.
class LiveChart {
 public:
  explicit LiveChart(Index vertex_count) : places_(vertex_count) {}

  /// The nodes, [slot], in no particular order. Vacant slots hold anything.
  const Chart& nodes() const { return nodes_; }
  bool vacant(Index slot) const { return states_[slot] == SlotState::vacant; }

  /// The slots of a vertex by rising t, linked; no_index at the end.
  Index first(Index vertex) const;
  Index next(Index slot) const { return next_[slot]; }
  std::uint32_t sheet_count(Index vertex) const;
  /// Whether a slot has the only node of its vertex.
  bool alone(Index slot) const { return states_[slot] == SlotState::alone; }

  /// Slots taken by nodes that the last event computed, and of these the ones that are new or other in any
  /// bit than before; each once.
  std::span<const Index> computed() const { return computed_; }
  bool changed(Index slot) const { return changed_in_[slot] == event_; }

  /// Whether a node's frame does not go on to its surroundings; see UpwindFrames::contested().
  bool contested(Index slot) const { return contested_[slot]; }

  /// Slots that the last event made vacant, though it may have taken them again.
  std::span<const Index> removed() const { return removed_; }

  /// Vertices that have a node that changed, or lost one, in the last event; each once.
  std::span<const Index> altered() const { return altered_; }
  bool is_altered(Index place) const { return altered_in_[place] == event_; }

  /// All nodes whose t is this or more were computed by the last event.
  double computed_from() const { return computed_from_; }

  /// The vertices of the chart are numbered in the order in which they came; this one's number.
  Index place(Index vertex) const { return places_.find(vertex); }
  Index place_of(Index slot) const { return place_of_[slot]; }  ///< the number of its vertex
  Index place_count() const { return places_.size(); }
  Index vertex_at(Index place) const { return places_.vertex(place); }

  /// As a chart: by vertex and t. In proportion to the chart.
  Chart sorted() const;

  /// Becomes empty, of no stroke.
  void clear();

  /// Begins an event: what follows counts as its changes.
  void begin_event(double length, bool closed, double computed_from);

  /// Puts a node into a slot, which is vacant or has a node of this vertex.
  void set(Index slot, Index vertex, const ChartFrame& frame, const Vec3f& normal, bool contested = false);
  void remove(Index slot);

  /// Makes room for so many slots.
  void reserve(Index slots);

  /// What rewrite() did.
  struct Rewritten {
    std::vector<Index> slots;     ///< all
    std::vector<Index> vertices;  ///< of those that changed
  };

  /// As set() with the vertex and normal that the node has, where it is its vertex's only one, so that
  /// nothing but its slot is touched; false where it is not, or there is none. Slots below those reserved,
  /// and different ones on several threads at once; note() has to follow.
  bool rewrite(Index slot, const ChartFrame& frame, Rewritten& rewritten);
  void note(const Rewritten& rewritten);

  /// An event that may change everything: becomes this chart.
  void assign(const Chart& chart);

 private:
  enum class SlotState : std::uint8_t { vacant, alone, beside_others };

  std::vector<Index> kept_slots(const Chart& chart) const;
  void link(Index slot);
  void unlink(Index slot);
  void alter(Index place);
  void mark_alone(Index place);

  Chart nodes_;
  std::vector<SlotState> states_;  ///< [slot]
  std::vector<Index> place_of_;    ///< [slot] of its vertex
  std::vector<Index> next_;
  std::vector<std::uint32_t> changed_in_;  ///< [slot] event
  std::vector<std::uint8_t> contested_;    ///< [slot]
  VertexNodes places_;
  std::vector<Index> first_;               ///< [place] slot
  std::vector<std::uint32_t> altered_in_;  ///< [place] event
  std::vector<Index> computed_, removed_, altered_;
  double computed_from_ = 0;
  std::uint32_t event_ = 0;
};

}  // namespace burin
