// Bisection of longest edges [M.-C. Rivara, Algorithms for refining triangular grids suitable for adaptive
// and multigrid techniques, 1984] with flips towards Delaunay after each split [Rivara, New longest-edge
// algorithms for the refinement and/or improvement of unstructured triangulations, 1997]. Bisection alone
// keeps the least angle above half of what it was; flips mend it on facets and where the surface is nearly
// flat at the scale of the edges. O(n log n) for n new triangles.
#include <burin/base/error.h>
#include <burin/refine/face_quad.h>
#include <burin/refine/refine_surface.h>
#include <burin/refine/region_mesh.h>
#include <burin/refine/smooth_facets.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>
#include <unordered_map>
#include <unordered_set>

namespace burin {
namespace {

/// Goes over the triangles of a surface where edges may have the least length, and over those elsewhere that
/// have edges which are nearly too long. Calls found(triangle) for those that have such edges.
class LongEdges {
 public:
  LongEdges(const Surface& surface, const EdgeLength& lengths, std::span<const Vec3f> given)
      : surface_(surface), lengths_(lengths), given_(given) {}

  template <class Found>
  void find(std::span<const Index> seeds, const Found& found) {
    for (const Index seed : seeds)
      if (seen_.insert(seed).second) open_.push_back(seed);
    for (std::size_t i = 0; i < open_.size(); ++i) {
      const Triangle& t = surface_.triangles[open_[i]];
      constexpr double nearly = 0.75;
      bool is_long = false, goes_on = false;
      for (std::size_t k = 0; k < 3; ++k) {
        const Index a = t[k], b = t[(k + 1) % 3];
        const Vec3d from = position(a), to = position(b);
        const double length = std::sqrt(judged_squared(surface_.positions, given_, a, b));
        goes_on |= allowed(a) <= lengths_.edge() || length > nearly * std::min(allowed(a), allowed(b));
        is_long |= lengths_.is_exceeded(from, allowed(a), to, allowed(b), length, longest_edge_factor);
      }
      if (is_long) found(open_[i]);
      if (!is_long && !goes_on) continue;
      for (const Index corner : t)
        for (const Index other : surface_.incident[corner])
          if (seen_.insert(other).second) open_.push_back(other);
    }
  }

 private:
  Vec3d position(Index vertex) const { return surface_.positions[vertex].cast<double>(); }
  double allowed(Index vertex) {
    const auto [found, is_new] = allowed_.try_emplace(vertex, 0);
    if (is_new) found->second = lengths_.at(position(vertex));
    return found->second;
  }

  const Surface& surface_;
  const EdgeLength& lengths_;
  std::span<const Vec3f> given_;
  std::unordered_set<Index> seen_;
  std::vector<Index> open_;
  std::unordered_map<Index, double> allowed_;  ///< [vertex] length
};

class Refinement {
 public:
  Refinement(const Surface& surface, const EdgeLength& lengths, std::span<const Vec3f> given,
             std::size_t most)
      : surface_(surface),
        lengths_(lengths),
        given_(given),
        most_(most),
        mesh_(surface, given),
        facets_(surface) {}

  void run(std::span<const Index> seeds) {
    LongEdges(surface_, lengths_, given_).find(seeds, [&](Index triangle) {
      look_at(mesh_.take_in(triangle));
    });
    flip_on_facets();
    while (!queue_.empty()) {
      const Long next = queue_.top();
      queue_.pop();
      if (pending_[next.face] == next.squared) split_after_longer(longest_long(next.face));
    }
  }

  SurfaceRefinement made() const;

 private:
  /// A face with an edge that is too long, as it was when it was found.
  struct Long {
    double squared;  ///< judged length of that edge
    Index face;
    bool operator<(const Long& other) const {
      return squared != other.squared ? squared < other.squared : face > other.face;
    }
  };

  void look_at(Index face);
  Side longest_long(Index face);
  bool is_long(Side side);
  double allowed(Index vertex);
  void split_after_longer(Side side);
  Side longer_beside(Side side);
  Vec3d flat(Index vertex) const;
  bool is_flat(Side side);
  FacetPlace middle_of(Side side, double& apart);
  Vec3d split_point(Side side, FacetPlace& place);
  void split(Side side);
  void flip_on_facets();
  void flip_around(bool only_in_plane);
  bool should_flip(Side side, bool only_in_plane);

  const Surface& surface_;
  const EdgeLength& lengths_;
  std::span<const Vec3f> given_;
  std::size_t most_;
  RegionMesh mesh_;
  SmoothFacets facets_;
  std::vector<double> allowed_;     ///< [vertex] length of edges there; 0 where it was not asked for
  std::vector<FacetPlace> places_;  ///< [new vertex]
  std::vector<Index> new_of_;       ///< [vertex] number among the new ones
  std::vector<double> pending_;     ///< [face] squared length of its longest edge that is too long, or 0
  std::priority_queue<Long> queue_;
  std::vector<Side> to_flip_, opposite_;
  std::vector<Index> touched_;
};

double Refinement::allowed(Index vertex) {
  if (allowed_.size() <= vertex) allowed_.resize(mesh_.vertices().size() + vertex / 2 + 16, 0);
  if (allowed_[vertex] == 0) allowed_[vertex] = lengths_.at(mesh_.position(vertex));
  return allowed_[vertex];
}

bool Refinement::is_long(Side side) {
  const double squared = mesh_.judged_squared_length(side), least = longest_edge_factor * lengths_.edge();
  if (squared <= least * least) return false;
  const Index a = mesh_.from(side), b = mesh_.to(side);
  return lengths_.is_exceeded(mesh_.position(a), allowed(a), mesh_.position(b), allowed(b),
                              std::sqrt(squared), longest_edge_factor);
}

/// no_index where none is too long.
Side Refinement::longest_long(Index face) {
  Side found = no_index;
  double most = 0;
  for (Side side = 3 * face; side < 3 * face + 3; ++side)
    if (const double squared = mesh_.judged_squared_length(side); squared > most && is_long(side)) {
      most = squared;
      found = side;
    }
  return found;
}

void Refinement::look_at(Index face) {
  if (pending_.size() <= face) pending_.resize(mesh_.faces().size(), 0);
  const Side side = longest_long(face);
  pending_[face] = side == no_index ? 0 : mesh_.judged_squared_length(side);
  if (side != no_index) queue_.push({pending_[face], face});
}

/// A longer edge of the faces beside one; no_index where there is none. What is hardly longer does not count,
/// so that splits do not spread over meshes with edges of about one length.
Side Refinement::longer_beside(Side side) {
  constexpr double longer = 1.15 * 1.15;
  double most = longer * mesh_.judged_squared_length(side);
  Side found = no_index, member = side;
  do {
    for (const Side other : {RegionMesh::after(member), RegionMesh::before(member)})
      if (const double squared = mesh_.judged_squared_length(other); squared > most) {
        most = squared;
        found = other;
      }
    member = mesh_.next(member);
  } while (member != side);
  return found;
}

/// Splits the edge itself only if none beside it is longer; otherwise its face stays in the queue.
void Refinement::split_after_longer(Side side) {
  const Index asked_for = side / 3;
  for (;;) {
    mesh_.connect(side / 3);
    const Side longer = longer_beside(side);
    if (longer == no_index) break;
    side = longer;
  }
  split(side);
  // It may have become another one by flips, which looked at it.
  look_at(asked_for);
}

/// Where a vertex is on the triangles of the surface.
Vec3d Refinement::flat(Index vertex) const {
  return new_of_[vertex] == no_index ? mesh_.position(vertex) : places_[new_of_[vertex]].flat;
}

/// Whether an edge lies on flat facets, as far as its faces and ends tell.
bool Refinement::is_flat(Side side) {
  Side member = side;
  do {
    if (facets_.is_curved(mesh_.faces()[member / 3].origin)) return false;
    member = mesh_.next(member);
  } while (member != side);
  return std::ranges::none_of(std::array{mesh_.from(side), mesh_.to(side)}, [&](Index end) {
    return new_of_[end] != no_index && facets_.is_curved(places_[new_of_[end]].triangle);
  });
}

/// The place of the surface in the middle of an edge, searched from where its faces and ends came from;
/// `apart`: squared distance from the middle.
FacetPlace Refinement::middle_of(Side side, double& apart) {
  const Index from = mesh_.from(side), to = mesh_.to(side);
  const Vec3d middle = (flat(from) + flat(to)) / 2;
  apart = std::numeric_limits<double>::infinity();
  FacetPlace best;
  const double exact = 1e-24 * mesh_.squared_length(side);
  const auto search = [&](Index triangle) {
    if (apart <= exact) return;
    const FacetPlace place = facets_.nearest(triangle, middle);
    if (const double squared = (place.flat - middle).squaredNorm(); squared < apart) {
      apart = squared;
      best = place;
    }
  };
  Side member = side;
  do {
    search(mesh_.faces()[member / 3].origin);
    member = mesh_.next(member);
  } while (member != side);
  for (const Index end : {from, to})
    if (new_of_[end] != no_index) search(places_[new_of_[end]].triangle);
  return best;
}

/// Where an edge is split, and on which place of the surface that is.
Vec3d Refinement::split_point(Side side, FacetPlace& place) {
  const Index from = mesh_.from(side), to = mesh_.to(side);
  const Vec3d middle = (mesh_.position(from) + mesh_.position(to)) / 2;
  place = {mesh_.faces()[side / 3].origin, {}, (flat(from) + flat(to)) / 2};
  if (is_flat(side)) return middle;
  double apart = 0;
  const FacetPlace found = middle_of(side, apart);
  // Where flips led away from the triangles that were, the edge itself is all there is to go by.
  constexpr double astray = 0.05;
  if (apart > astray * mesh_.squared_length(side)) return middle;
  place = found;
  return facets_.smooth(place);
}

void Refinement::split(Side side) {
  if (mesh_.faces().size() > most_)
    throw Error(fmt::format("refining the surface would take more than {} triangles", most_));
  for (Side member = mesh_.next(side); member != side; member = mesh_.next(member)) mesh_.connect(member / 3);
  new_of_.resize(mesh_.vertices().size(), no_index);
  FacetPlace place;
  const Vec3d at = split_point(side, place).cast<float>().cast<double>();
  mesh_.split(side, at, opposite_);
  new_of_.push_back(static_cast<Index>(places_.size()));
  places_.push_back(place);
  touched_.clear();
  for (const Side other : opposite_) touched_.push_back(other / 3);
  to_flip_ = opposite_;
  flip_around(false);
  for (const Index face : touched_) look_at(face);
}

/// Delaunay triangles of flat facets, where something is to be split, are fewer and better.
void Refinement::flip_on_facets() {
  const auto known = static_cast<Index>(pending_.size());
  for (Index face = 0; face < known; ++face)
    if (pending_[face] > 0)
      for (Side side = 3 * face; side < 3 * face + 3; ++side) to_flip_.push_back(side);
  touched_.clear();
  flip_around(true);
  for (const Index face : touched_) look_at(face);
}

void Refinement::flip_around(bool only_in_plane) {
  std::array<Side, 4> outer{};
  while (!to_flip_.empty()) {
    const Side side = to_flip_.back();
    to_flip_.pop_back();
    if (!should_flip(side, only_in_plane)) continue;
    touched_.push_back(side / 3);
    touched_.push_back(mesh_.twin(side) / 3);
    mesh_.flip(side, outer);
    to_flip_.insert(to_flip_.end(), outer.begin(), outer.end());
  }
}

bool Refinement::should_flip(Side side, bool only_in_plane) {
  mesh_.connect(side / 3);
  if (mesh_.is_sharp_side(side)) return false;
  const Side other = mesh_.twin(side);
  if (other == no_index || mesh_.from(other) != mesh_.to(side)) return false;
  const Index a = mesh_.from(side), b = mesh_.to(side), c = mesh_.apex(side), d = mesh_.apex(other);
  // Where faces around a vertex are not one fan, the new edge might be there already.
  if (mesh_.vertices()[c].is_crowded || mesh_.vertices()[d].is_crowded) return false;
  const FaceQuad quad{mesh_.position(a), mesh_.position(b), mesh_.position(c), mesh_.position(d)};
  if (quad.is_delaunay()) return false;
  constexpr double in_plane = 2e-6, nearly = 0.01;
  double most = in_plane * quad.longest_diagonal();
  if (!only_in_plane)
    most = std::max(most, nearly * std::min({allowed(a), allowed(b), allowed(c), allowed(d)}));
  if (!quad.can_flip(most)) return false;
  mesh_.connect(other / 3);
  return !mesh_.are_joined(RegionMesh::before(side), d);
}

SurfaceRefinement Refinement::made() const {
  SurfaceRefinement made;
  SurfacePatch& patch = made.patch;
  const auto number = [&](Index vertex) {
    const Index source = mesh_.vertices()[vertex].source;
    return source != no_index ? source : surface_.vertex_count() + new_of_[vertex];
  };
  for (const RegionMesh::Face& face : mesh_.faces()) {
    if (!face.changed) continue;
    patch.triangles.push_back({number(face.corners[0]), number(face.corners[1]), number(face.corners[2])});
    if (!surface_.triangle_uv.empty()) patch.triangle_uv.push_back(face.uv);
  }
  patch.removed = mesh_.changed_triangles();
  for (const RegionMesh::Vertex& vertex : mesh_.vertices()) {
    if (vertex.source != no_index) continue;
    patch.positions.push_back(vertex.at.cast<float>());
    made.given.push_back(vertex.given.cast<float>());
    made.edges.push_back(static_cast<float>(lengths_.at(vertex.at)));
  }
  return made;
}

}  // namespace

SurfaceRefinement refine_surface(const Surface& surface, const EdgeLength& lengths,
                                 std::span<const Index> seeds, std::size_t most_triangles,
                                 std::span<const Vec3f> given) {
  Refinement refinement(surface, lengths, given.empty() ? surface.positions : given, most_triangles);
  refinement.run(seeds);
  return refinement.made();
}

}  // namespace burin
