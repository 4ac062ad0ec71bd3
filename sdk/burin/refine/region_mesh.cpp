// Rings of sides around edges, after the radial edges of K. Weiler (1988). Sides of which the ring is not
// known belong to faces that are still triangles of the surface: a face is connected before it changes.
#include <burin/refine/region_mesh.h>
#include <burin/refine/smooth_facets.h>
#include <burin/refine/vertex_fan.h>
#include <burin/surface/geometry/triangle_shape.h>

#include <algorithm>

namespace burin {

Index RegionMesh::vertex_of(Index source) {
  const auto [at, is_new] = vertex_of_.try_emplace(source, static_cast<Index>(vertices_.size()));
  if (is_new)
    vertices_.push_back({surface_->positions[source].cast<double>(), given_[source].cast<double>(), source,
                         is_crowded(source)});
  return at->second;
}

/// Where a new vertex of an edge would be if nothing was drawn. Between vertices that did not move that is
/// where it is, on the smooth surface; else on the chord.
Vec3d RegionMesh::given_between(Index a, Index b, const Vec3d& at) const {
  const Vertex &one = vertices_[a], &other = vertices_[b];
  if (one.given == one.at && other.given == other.at) return at;
  return ((one.given + other.given) / 2).cast<float>().cast<double>();
}

bool RegionMesh::is_crowded(Index source) {
  star_.clear();
  for (const Index triangle : surface_->incident[source]) {
    const Triangle& t = surface_->triangles[triangle];
    const std::size_t i = corner_of(t, source);
    star_.add(triangle, t[(i + 2) % 3], t[(i + 1) % 3]);
  }
  star_.connect();
  return star_.fans() > 1 ||
         std::ranges::any_of(star_.edges(), [](const StarEdge& edge) { return edge.faces() > 2; });
}

Index RegionMesh::take_in(Index triangle) {
  const auto [at, is_new] = face_of_.try_emplace(triangle, static_cast<Index>(faces_.size()));
  if (!is_new) return at->second;
  Face face;
  for (std::size_t i = 0; i < 3; ++i) face.corners[i] = vertex_of(surface_->triangles[triangle][i]);
  face.next.fill(no_index);
  if (!surface_->triangle_uv.empty()) face.uv = surface_->triangle_uv[triangle];
  face.origin = triangle;
  faces_.push_back(face);
  return at->second;
}

void RegionMesh::connect(Index face) {
  for (Side side = 3 * face; side < 3 * face + 3; ++side)
    if (next(side) == no_index) connect_side(side);
}

void RegionMesh::connect_side(Side side) {
  const Index triangle = faces_[side / 3].origin;
  const bool sharp = is_sharp(*surface_, triangle, side % 3);
  triangles_beside(*surface_, triangle, side % 3, beside_);
  ring_.assign(1, side);
  const Index a = from(side), b = to(side);
  for (const Index other : beside_) {
    const Index face = take_in(other);
    for (Side there = 3 * face; there < 3 * face + 3; ++there)
      if ((from(there) == a && to(there) == b) || (from(there) == b && to(there) == a))
        ring_.push_back(there);
  }
  close_ring(ring_);
  for (const Side there : ring_) faces_[there / 3].sharp[there % 3] = sharp;
}

void RegionMesh::close_ring(const std::vector<Side>& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i) link(ring[i], ring[(i + 1) % ring.size()]);
}

Side RegionMesh::previous(Side side) const {
  Side before = side;
  while (next(before) != side) before = next(before);
  return before;
}

void RegionMesh::split(Side side, const Vec3d& at, std::vector<Side>& opposite) {
  const auto middle = static_cast<Index>(vertices_.size());
  ring_.clear();
  for (Side member = side; ring_.empty() || member != side; member = next(member)) ring_.push_back(member);
  vertices_.push_back({at, given_between(from(side), to(side), at), no_index, ring_.size() > 2});
  const Index first = from(side);
  first_half_.clear();
  second_half_.clear();
  opposite.clear();
  for (const Side member : ring_) {
    const auto made = static_cast<Index>(faces_.size());
    const std::size_t i = member % 3, j = (i + 1) % 3, k = (i + 2) % 3;
    faces_.push_back(faces_[member / 3]);
    Face &kept = faces_[member / 3], &added = faces_.back();
    kept.changed = added.changed = true;
    kept.corners[j] = added.corners[i] = middle;
    kept.uv[j] = added.uv[i] = (kept.uv[i] + kept.uv[j]) / 2;
    const auto fixed = static_cast<Side>(3 * (member / 3)), fresh = static_cast<Side>(3 * made);
    // The side from the middle on to the apex was that from the end to the apex, which the new face takes
    // over.
    const Side moved = static_cast<Side>(fixed + j), moved_to = static_cast<Side>(fresh + j);
    const Side before_it = previous(moved), after_it = next(moved);
    link(moved_to, after_it == moved ? moved_to : after_it);
    if (before_it != moved) link(before_it, moved_to);
    link(moved, static_cast<Side>(fresh + k));
    link(static_cast<Side>(fresh + k), moved);
    kept.sharp[j] = added.sharp[k] = false;
    const bool forwards = kept.corners[i] == first;
    (forwards ? first_half_ : second_half_).push_back(member);
    (forwards ? second_half_ : first_half_).push_back(static_cast<Side>(fresh + i));
    opposite.push_back(static_cast<Side>(fixed + k));
    opposite.push_back(moved_to);
  }
  close_ring(first_half_);
  close_ring(second_half_);
}

std::array<RegionMesh::Corners, 2> RegionMesh::flipped(Side side) const {
  const Side other = twin(side);
  const Face &f = faces_[side / 3], &q = faces_[other / 3];
  const std::size_t a = side % 3, b = (a + 1) % 3, c = (a + 2) % 3, d = (other % 3 + 2) % 3;
  return {Corners{{f.corners[c], f.corners[a], q.corners[d]}, {f.uv[c], f.uv[a], q.uv[d]}},
          Corners{{q.corners[d], f.corners[b], f.corners[c]}, {q.uv[d], f.uv[b], f.uv[c]}}};
}

void RegionMesh::flip(Side side, std::array<Side, 4>& outer) {
  const Side other = twin(side);
  const Index f = side / 3, q = other / 3;
  const std::array<Side, 4> old = {before(side), after(other), before(other), after(side)};
  outer = {3 * f, 3 * f + 1, 3 * q, 3 * q + 1};
  const auto moved = [&](Side at) {
    const auto found = std::ranges::find(old, at);
    return found == old.end() ? at : outer[static_cast<std::size_t>(found - old.begin())];
  };
  std::array<Side, 4> nexts{}, lasts{};
  std::array<bool, 4> sharps{};
  for (std::size_t i = 0; i < 4; ++i) {
    nexts[i] = next(old[i]);
    lasts[i] = previous(old[i]);
    sharps[i] = is_sharp_side(old[i]);
  }
  const auto [first, second] = flipped(side);
  Face &one = faces_[f], &two = faces_[q];
  one.corners = first.vertices;
  one.uv = first.uv;
  two.corners = second.vertices;
  two.uv = second.uv;
  one.changed = two.changed = true;
  one.sharp = {sharps[0], sharps[1], false};
  two.sharp = {sharps[2], sharps[3], false};
  for (std::size_t k = 0; k < 4; ++k) {
    link(outer[k], moved(nexts[k]));
    if (std::ranges::find(old, lasts[k]) == old.end()) link(lasts[k], outer[k]);
  }
  link(3 * f + 2, 3 * q + 2);
  link(3 * q + 2, 3 * f + 2);
}

/// Joins the edges of two sides of a face that is gone: what is left of their rings becomes one.
void RegionMesh::close_over(Side outer, Side inner) {
  ring_.clear();
  for (const Side side : {outer, inner})
    for (Side member = next(side); member != side; member = next(member)) ring_.push_back(member);
  const bool sharp = is_sharp_side(outer) || is_sharp_side(inner);
  close_ring(ring_);
  for (const Side side : ring_) faces_[side / 3].sharp[side % 3] = sharp;
}

void RegionMesh::collapse(const VertexFan& fan, const Collapse& how) {
  const std::size_t count = fan.size(), k = how.onto;
  const Index onto = k < count ? to(fan.leaving[k]) : from(spoke(fan, k));
  // The faces that begin and end at the edge, as far as there are such.
  const bool has_left = k < count;
  const bool has_right = k > 0 || fan.closed;
  const std::size_t left = has_left ? k : 0, right = has_right ? fan.before(k) : 0;
  const Face before_left = faces_[fan.leaving[left] / 3], before_right = faces_[fan.leaving[right] / 3];
  const Vec2f uv_left = before_left.uv[after(fan.leaving[left]) % 3],
              uv_right = before_right.uv[before(fan.leaving[right]) % 3];
  const std::size_t end_of_left = how.crest == k ? count : (how.crest + count - k) % count;
  for (std::size_t i = 0; i < count; ++i) {
    Face& face = faces_[fan.leaving[i] / 3];
    face.changed = true;
    face.gone = (has_left && i == left) || (has_right && i == right);
    const bool is_left = has_left && (!has_right || (i + count - k) % count < end_of_left);
    face.corners[fan.leaving[i] % 3] = onto;
    face.uv[fan.leaving[i] % 3] = is_left ? uv_left : uv_right;
  }
  if (has_left) close_over(after(fan.leaving[left]), before(fan.leaving[left]));
  if (has_right) close_over(after(fan.leaving[right]), fan.leaving[right]);
}

/// Goes around the vertex at which a side begins, in one direction; `whole` tells whether it came back.
bool RegionMesh::is_beside(Side start, Index other, bool forwards, bool& whole) {
  const Index vertex = from(start);
  Side leaving = forwards ? before(start) : start;
  for (whole = false; !whole;) {
    connect(leaving / 3);
    if (to(leaving) == other || from(leaving) == other || apex(leaving) == other) return true;
    const Side across = twin(leaving);
    if (across == no_index) return false;
    // Faces may disagree on outside.
    leaving = from(across) == vertex ? before(across) : after(across);
    whole = across / 3 == start / 3;
  }
  return false;
}

bool RegionMesh::are_joined(Side side, Index other) {
  bool whole = false;
  return is_beside(side, other, true, whole) || (!whole && is_beside(side, other, false, whole));
}

std::vector<Index> RegionMesh::changed_triangles() const {
  std::vector<Index> changed;
  for (const auto& [triangle, face] : face_of_)
    if (faces_[face].changed) changed.push_back(triangle);
  std::ranges::sort(changed);
  return changed;
}

}  // namespace burin
