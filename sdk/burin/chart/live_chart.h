#pragma once
#include <burin/chart/chart.h>
#include <burin/chart/chart_frame.h>
#include <burin/chart/vertex_nodes.h>

#include <cstdint>
#include <span>
#include <vector>

namespace burin {

/// The chart of a stroke that is being drawn, with the changes of the last event. A node keeps its slot from
/// event to event, and an event costs in proportion to what it changes. Uses four bytes per vertex of the
/// surface. Const functions, and rewrite() for different slots, may be called from several threads at once.
class LiveChart {
 public:
  explicit LiveChart(Index vertex_count) : local_indices_(vertex_count) {}

  /// The nodes, indexed by slot, in no particular order. The values of vacant slots are unspecified.
  const Chart& nodes() const { return nodes_; }
  bool vacant(Index slot) const { return states_[slot] == SlotState::vacant; }

  /// The slots of a vertex as a linked list in the order of t; no_index ends it.
  Index first(Index vertex) const;
  Index next(Index slot) const { return next_[slot]; }
  std::uint32_t sheet_count(Index vertex) const;
  /// Whether the slot holds the only node of its vertex.
  bool alone(Index slot) const { return states_[slot] == SlotState::alone; }

  /// computed(): the slots of the nodes that the last event computed, each once. changed(): whether the last
  /// event made the slot's node new, or different in any bit.
  std::span<const Index> computed() const { return computed_; }
  bool changed(Index slot) const { return changed_in_[slot] == event_; }

  /// Whether a node's frame must not be extrapolated to its surroundings; see UpwindFrames::contested().
  bool contested(Index slot) const { return contested_[slot]; }

  /// The slots that the last event made vacant; it may have filled some of them again.
  std::span<const Index> removed() const { return removed_; }

  /// The vertices of which a node changed or was removed in the last event, each once.
  std::span<const Index> altered() const { return altered_; }
  bool is_altered(Index local) const { return altered_in_[local] == event_; }

  /// The last event computed all nodes with at least this t.
  double computed_from() const { return computed_from_; }

  /// The local index of a vertex, or no_index. Vertices of the chart are numbered in order of appearance,
  /// from 0 to local_count() - 1.
  Index local_index(Index vertex) const { return local_indices_.find(vertex); }
  Index local_index_of(Index slot) const {
    return local_index_of_[slot];
  }  ///< local index of the slot's vertex
  Index local_count() const { return local_indices_.size(); }
  Index vertex_at(Index local) const { return local_indices_.vertex(local); }

  /// The slots that have nodes, by vertex and t. In proportion to the chart.
  std::vector<Index> sorted_slots() const;

  /// Copies the nodes of these slots to a chart, in their order. Costs O(n) for n slots.
  Chart chart_of(std::span<const Index> slots) const;

  /// Copies all nodes to a chart, ordered by vertex and t. Costs O(n) for a chart of n nodes.
  Chart sorted() const { return chart_of(sorted_slots()); }

  /// Removes all nodes.
  void clear();

  /// Starts an event; all changes until the next call belong to it.
  void begin_event(double length, bool closed, double computed_from);

  /// Writes a node to a slot, which must be vacant or hold a node of the same vertex.
  void set(Index slot, Index vertex, const ChartFrame& frame, const Vec3f& normal, bool contested = false);
  void remove(Index slot);

  /// Makes sure that there are at least this many slots.
  void reserve(Index slots);

  /// The slots that calls of rewrite() wrote.
  struct Rewritten {
    std::vector<Index> slots;     ///< all of them
    std::vector<Index> vertices;  ///< the vertices of those that changed
  };

  /// Sets the frame of a slot and keeps its vertex and normal. This is possible only when the slot holds the
  /// only node of its vertex; otherwise nothing happens and the result is false. The slot must be below the
  /// number reserved. Several threads may call this at once for different slots; note() must be called after.
  bool rewrite(Index slot, const ChartFrame& frame, Rewritten& rewritten);
  void note(const Rewritten& rewritten);

  /// Starts an event that replaces the whole chart by this one.
  void assign(const Chart& chart);

 private:
  enum class SlotState : std::uint8_t { vacant, alone, beside_others };

  std::vector<Index> kept_slots(const Chart& chart) const;
  void link(Index slot);
  void unlink(Index slot);
  void alter(Index local);
  void mark_alone(Index local);

  Chart nodes_;
  std::vector<SlotState> states_;          ///< [slot]
  std::vector<Index> local_index_of_;      ///< [slot] local index of its vertex
  std::vector<Index> next_;                ///< [slot] next slot of the same vertex
  std::vector<std::uint32_t> changed_in_;  ///< [slot] event that changed it last
  std::vector<std::uint8_t> contested_;    ///< [slot]
  VertexNodes local_indices_;
  std::vector<Index> first_;               ///< [local index] first slot
  std::vector<std::uint32_t> altered_in_;  ///< [local index] event that altered the vertex last
  std::vector<Index> computed_, removed_, altered_;
  double computed_from_ = 0;
  std::uint32_t event_ = 0;
};

}  // namespace burin
