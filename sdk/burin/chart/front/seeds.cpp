// Seeds from stroke segments. Instead of inserting the stroke's points into the neighbour graph (section 4
// of the paper), vertices near the stroke take their coordinates from the nearest point of its segments.
// Segments leave in the reverse order in which they came, so that a stroke that grows costs what is new.
#include <burin/chart/front/seeds.h>

#include <algorithm>

namespace burin {

void Seeds::restart(VertexRange own) {
  own_ = own;
  neighbours_.restart();
  entries_.clear();
  offers_.clear();
  first_offer_.clear();
  depending_.clear();
}

std::span<const Seeds::Change> Seeds::update(const FrontStroke& on, std::size_t first_changed,
                                             ChartNodes& nodes) {
  stale_.clear();
  changes_.clear();
  withdraw_from(first_changed);
  for (std::size_t segment = first_offer_.size(); segment < on.curve.segment_count(); ++segment)
    offer_segment(on, segment, nodes);
  depending_.resize(first_offer_.size(), no_index);
  for (const Index entry : stale_) renew(on, entry, nodes);
  return changes_;
}

void Seeds::withdraw_from(std::size_t segment) {
  for (std::size_t i = segment; i < depending_.size(); ++i)
    while (depending_[i] != no_index) make_stale(depending_[i]);
  if (segment < depending_.size()) depending_.resize(segment);
  if (segment >= first_offer_.size()) return;
  for (std::size_t i = offers_.size(); i > first_offer_[segment]; --i) {
    const Offer& offer = offers_[i - 1];
    entries_[offer.entry].last_offer = offer.before;
    make_stale(offer.entry);
  }
  offers_.resize(first_offer_[segment]);
  first_offer_.resize(segment);
}

void Seeds::make_stale(Index entry) {
  if (entries_[entry].stale) return;
  entries_[entry].stale = true;
  stale_.push_back(entry);
  depend_no_more(entries_[entry]);
}

void Seeds::depend(Index index, std::size_t segment) {
  Entry& entry = entries_[index];
  entry.depends = true;
  entry.last_segment = segment;
  entry.previous = no_index;
  entry.next = depending_[segment];
  if (entry.next != no_index) entries_[entry.next].previous = index;
  depending_[segment] = index;
}

void Seeds::depend_no_more(Entry& entry) {
  if (!entry.depends) return;
  entry.depends = false;
  (entry.previous == no_index ? depending_[entry.last_segment] : entries_[entry.previous].next) = entry.next;
  if (entry.next != no_index) entries_[entry.next].previous = entry.previous;
}

void Seeds::offer_segment(const FrontStroke& on, std::size_t segment, ChartNodes& nodes) {
  first_offer_.push_back(static_cast<Index>(offers_.size()));
  around_.clear();
  gathered_.clear();
  const SurfacePoint &from = on.curve.points[segment].at, &to = on.curve.points[on.curve.next(segment)].at;
  const Ball discs = discs_along(on, segment);
  gather_around(from, discs);
  if (to.corners != from.corners) gather_around(to, discs);
  for (const Index vertex : around_) offer(on, segment, vertex, nodes);
}

/// A ball around the discs of all samples that feet on the segment may have.
Seeds::Ball Seeds::discs_along(const FrontStroke& on, std::size_t segment) {
  constexpr double rounding = 1.001;
  const Vec3f middle =
      (on.curve.points[segment].at.position + on.curve.points[on.curve.next(segment)].at.position) / 2;
  const Index first = on.samples.at(on.curve.points[segment].t);
  const Index steps = on.samples.steps(first, on.samples.at(on.curve.segment_end(segment)));
  float radius = 0;
  for (Index i = 0; i <= steps; ++i) {
    const Index sample = (first + i) % on.samples.size();
    radius = std::max(radius, on.samples.chord(sample, middle) + on.samples.disc(sample));
  }
  return {middle.cast<double>(), rounding * static_cast<double>(radius)};
}

void Seeds::gather_around(const SurfacePoint& at, const Ball& discs) {
  for (const Index corner : at.corners) {
    const auto gather = [&](Index vertex) {
      if (own_.holds(vertex) && !is_around(vertex)) around_.push_back(vertex);
    };
    gather(corner);
    for (const Index vertex : neighbours_.around(corner, discs.middle, discs.radius)) gather(vertex);
    gathered_.push_back(corner);
  }
}

/// Without a look at all that are: a corner may have very many neighbours.
bool Seeds::is_around(Index vertex) const {
  return std::ranges::any_of(gathered_, [&](Index corner) {
    return corner == vertex || std::ranges::binary_search(ground_->neighbours(corner), vertex);
  });
}

void Seeds::offer(const FrontStroke& on, std::size_t segment, Index vertex, ChartNodes& nodes) {
  const Foot foot = foot_on(on.curve, segment, (*ground_)[vertex].position);
  const Index node = nodes.at(vertex, on.samples.at(arc_length_at(on.curve, foot)));
  if (node == no_index) return;
  Index& seed = nodes[node].seed;
  if (seed == no_index) {
    seed = static_cast<Index>(entries_.size());
    entries_.emplace_back().node = node;
  }
  Entry& entry = entries_[seed];
  offers_.push_back({seed, entry.last_offer, foot});
  entry.last_offer = static_cast<Index>(offers_.size() - 1);
  make_stale(seed);
}

void Seeds::renew(const FrontStroke& on, Index index, ChartNodes& nodes) {
  Entry& entry = entries_[index];
  entry.stale = false;
  Seed seed;
  if (entry.last_offer != no_index) {
    // The first of equally near segments counts.
    const Foot* best = &offers_[entry.last_offer].foot;
    for (Index i = entry.last_offer; i != no_index; i = offers_[i].before)
      if (offers_[i].foot.distance <= best->distance) best = &offers_[i].foot;
    const FrontNode& node = nodes[entry.node];
    const auto [foot, last_segment] = nearest_from(on.curve, *best, node.position);
    seed = {foot.distance, frame_from((*ground_)[node.vertex()], on.curve, on.curvature, on.path, foot)};
    depend(index, last_segment);
  }
  if (seed == entry.seed) return;
  changes_.push_back({entry.node, entry.seed.distance});
  entry.seed = seed;
}

}  // namespace burin
