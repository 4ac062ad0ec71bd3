#pragma once
#include <burin/chart/frames/foot.h>
#include <burin/chart/front/chart_nodes.h>
#include <burin/chart/front/near_neighbours.h>
#include <burin/chart/path/front_stroke.h>

#include <cstddef>
#include <span>
#include <vector>

namespace burin {

/// What a node beside the stroke has from its own foot point on a stroke segment.
struct Seed {
  float distance = unreached;  ///< to the foot, object units; unreached: the node has no seed any more
  ChartFrame frame;            ///< t at the foot, beyond the ends along the end's tangent; e1 transported

  bool operator==(const Seed&) const = default;
};

/// The seeds of one part of a front: for every visit of the corners of the curve's points, and of their
/// one-ring, the nearest foot on the segments nearby. The ground must outlive the object.
class Seeds {
 public:
  explicit Seeds(const ChartGround& ground) : ground_(&ground), neighbours_(ground) {}

  /// Forgets everything. Seeds vertices of `own` only.
  void restart(VertexRange own);

  struct Change {
    Index node;             ///< its `seed` names the new one
    float distance_before;  ///< of the one that it had; unreached: none
  };

  /// Follows a change of the curve, of its curvature or samples from this segment on. Returns the nodes whose
  /// seeds have changed. Valid until the next call.
  std::span<const Change> update(const FrontStroke& on, std::size_t first_changed, ChartNodes& nodes);

  const Seed& operator[](Index seed) const { return entries_[seed].seed; }

 private:
  /// A segment near a node, and its nearest point to it.
  struct Offer {
    Index entry = no_index;
    Index before = no_index;  ///< the offer that the entry had before this one
    Foot foot;
  };
  struct Ball {
    Vec3d middle;
    double radius;  ///< object units
  };
  struct Entry {
    Index node = no_index;
    Index last_offer = no_index;
    std::size_t last_segment = 0;                ///< the seed depends on segments up to this one
    Index next = no_index, previous = no_index;  ///< entries that depend on as many segments
    bool depends = false, stale = false;
    Seed seed;
  };

  void withdraw_from(std::size_t segment);
  void make_stale(Index entry);
  void depend(Index entry, std::size_t segment);
  void depend_no_more(Entry& entry);
  static Ball discs_along(const FrontStroke& on, std::size_t segment);
  void offer_segment(const FrontStroke& on, std::size_t segment, ChartNodes& nodes);
  void gather_around(const SurfacePoint& at, const Ball& discs);
  bool is_around(Index vertex) const;
  void offer(const FrontStroke& on, std::size_t segment, Index vertex, ChartNodes& nodes);
  void renew(const FrontStroke& on, Index entry, ChartNodes& nodes);

  const ChartGround* ground_;
  NearNeighbours neighbours_;
  VertexRange own_;
  std::vector<Entry> entries_;
  std::vector<Offer> offers_;       ///< by segment
  std::vector<Index> first_offer_;  ///< [segment] in offers_
  std::vector<Index> depending_;    ///< [segment] first entry whose last_segment it is
  std::vector<Index> stale_;        ///< entries
  std::vector<Change> changes_;
  std::vector<Index> around_;    ///< vertices that the running segment is offered to
  std::vector<Index> gathered_;  ///< corners whose neighbours those are
};

}  // namespace burin
