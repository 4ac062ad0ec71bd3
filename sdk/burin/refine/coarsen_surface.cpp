// Collapses of half-edges [H. Hoppe, T. DeRose, T. Duchamp, J. McDonald and W. Stuetzle, Mesh optimization,
// 1993], at the vertex with the shortest edge first, with the lengths of M. Botsch and L. Kobbelt (A
// remeshing approach to multiresolution modeling, 2004). Removed vertices stay as samples of the faces that
// came in their place, so that the error is that of the result, not of one step.
#include <burin/base/segment.h>
#include <burin/base/sort_unique.h>
#include <burin/refine/coarsen_surface.h>
#include <burin/refine/face_quad.h>
#include <burin/refine/refine_surface.h>
#include <burin/refine/vertex_fan.h>
#include <burin/surface/geometry/triangle_shape.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <queue>
#include <unordered_map>
#include <utility>
#include <vector>

namespace burin {
namespace {

/// The sine of the least angle of a triangle; 0 without area.
double least_sine(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  std::array<double, 3> squared{(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()};
  std::ranges::sort(squared);
  return squared[0] > 0 ? (b - a).cross(c - a).norm() / std::sqrt(squared[1] * squared[2]) : 0;
}

/// The places that vertices had which went from sharp edges between two vertices.
class SharpLines {
 public:
  std::vector<Vec3d>& between(Index a, Index b) {
    const auto [least, most] = std::minmax(a, b);
    return places_[std::uint64_t{least} << 32U | most];
  }

 private:
  std::unordered_map<std::uint64_t, std::vector<Vec3d>> places_;
};

class Coarsening {
 public:
  Coarsening(const Surface& surface, const CoarsenBounds& bounds, std::span<const Vec3f> given)
      : surface_(surface), bounds_(bounds), mesh_(surface, given), samples_(surface, mesh_) {}

  void run(std::span<const Index> vertices);
  SurfacePatch made() const;

 private:
  /// A vertex that may go, with the squared judged length of its shortest edge when it was looked at.
  struct Short {
    double squared;
    Index vertex;
    bool operator<(const Short& other) const {
      return squared != other.squared ? squared > other.squared : vertex > other.vertex;
    }
  };

  static constexpr double none = -1;

  /// What is left on one side of a sharp line.
  struct Part {
    std::vector<DrawnSamples::Draft> drafts;  ///< of faces that stay
    std::vector<DrawnSamples::Sample> samples;
    Vec2f uv = Vec2f::Zero();  ///< of the neighbour
  };

  /// How well shaped some faces are.
  struct Shape {
    double least_sine = 1;  ///< of their angles
    std::size_t thin = 0;   ///< how many of them have a small angle

    void add(double sine) {
      constexpr double well_shaped = 0.342;  // of 20 degrees
      least_sine = std::min(least_sine, sine);
      thin += sine < well_shaped;
    }
  };

  /// One way to take a vertex out.
  struct Way {
    RegionMesh::Collapse how;
    double least_sine;  ///< of the faces that it leaves
  };

  void look_at(Index vertex);
  void try_to_remove(Index vertex);
  std::optional<std::vector<std::size_t>> sharp_neighbours() const;
  std::vector<Way> ways();
  bool satisfies_link(std::size_t k);
  bool is_gone_face(std::size_t i, std::size_t k) const;
  std::optional<Shape> shape_after(std::size_t k) const;
  bool is_too_long(Index a, Index b) const;
  Shape shape_now() const;
  std::vector<Part> parts(const RegionMesh::Collapse& how) const;
  bool keeps_sharp_line(const RegionMesh::Collapse& how);
  bool collapse(Index vertex, const RegionMesh::Collapse& how);
  void move_corners(const RegionMesh::Collapse& how, std::vector<Part>& parts) const;
  void flip_around(const std::vector<Part>& parts);
  bool should_flip(Side side);
  bool flip(Side side);
  void look_at_touched();

  const Surface& surface_;
  const CoarsenBounds& bounds_;
  RegionMesh mesh_;
  DrawnSamples samples_;
  SharpLines lines_;
  std::vector<Side> leaving_;    ///< [vertex that may go] a side that begins there; no_index for others
  std::vector<double> pending_;  ///< [vertex] as in the queue, or `none`
  std::priority_queue<Short> queue_;
  VertexFan fan_, other_fan_;
  std::vector<Index> around_, touched_;  ///< touched: faces that changed with the vertex that went
  std::vector<Side> to_flip_;
};

void Coarsening::run(std::span<const Index> vertices) {
  for (const Index vertex : vertices) {
    if (surface_.incident[vertex].empty()) continue;
    const Index triangle = surface_.incident[vertex][0], face = mesh_.take_in(triangle);
    const auto side = static_cast<Side>(3 * face + corner_of(surface_.triangles[triangle], vertex));
    leaving_.resize(std::max<std::size_t>(leaving_.size(), mesh_.from(side) + 1), no_index);
    leaving_[mesh_.from(side)] = side;
  }
  pending_.resize(leaving_.size(), none);
  for (Index vertex = 0; vertex < leaving_.size(); ++vertex) look_at(vertex);
  while (!queue_.empty()) {
    const Short next = queue_.top();
    queue_.pop();
    if (pending_[next.vertex] != next.squared) continue;
    pending_[next.vertex] = none;
    try_to_remove(next.vertex);
  }
}

void Coarsening::look_at(Index vertex) {
  if (vertex >= leaving_.size() || leaving_[vertex] == no_index) return;
  pending_[vertex] = none;
  if (!find_fan(mesh_, leaving_[vertex], fan_)) return;
  constexpr double too_short = 4. / 5;
  double least = too_short * bounds_.edge * too_short * bounds_.edge;
  bool is_short = false;
  for (std::size_t i = 0; i < fan_.neighbour_count(); ++i)
    if (const double squared = mesh_.judged_squared_length(spoke(fan_, i)); squared < least) {
      least = squared;
      is_short = true;
    }
  if (!is_short) return;
  pending_[vertex] = least;
  queue_.push({least, vertex});
}

/// The neighbours along sharp edges; nothing where these do not go on as one line, so that the vertex stays.
std::optional<std::vector<std::size_t>> Coarsening::sharp_neighbours() const {
  std::vector<std::size_t> sharp;
  for (std::size_t i = 0; i < fan_.neighbour_count(); ++i)
    if (mesh_.is_sharp_side(spoke(fan_, i))) sharp.push_back(i);
  if (sharp.size() == 1 || sharp.size() > 2) return {};
  return sharp;
}

bool Coarsening::is_gone_face(std::size_t i, std::size_t k) const { return i == k || fan_.after(i) == k; }

/// Whether the vertex and its neighbour have no neighbours in common but the apexes of the faces between
/// them, and no face would be there twice.
bool Coarsening::satisfies_link(std::size_t k) {
  const Side start = k < fan_.size() ? RegionMesh::after(fan_.leaving[k]) : spoke(fan_, k);
  if (!find_fan(mesh_, start, other_fan_)) return false;
  around_.clear();
  for (std::size_t i = 0; i < fan_.neighbour_count(); ++i)
    if (i != k) around_.push_back(neighbour(mesh_, fan_, i));
  std::size_t common = 0;
  for (std::size_t i = 0; i < other_fan_.neighbour_count(); ++i)
    common += std::ranges::count(around_, neighbour(mesh_, other_fan_, i));
  std::size_t apexes = 0;
  for (std::size_t i = 0; i < fan_.size(); ++i) apexes += is_gone_face(i, k);
  if (common != apexes) return false;
  const Index onto = neighbour(mesh_, fan_, k);
  for (std::size_t i = 0; i < fan_.size(); ++i) {
    const Side opposite = RegionMesh::after(fan_.leaving[i]);
    const bool is_border = mesh_.next(opposite) == opposite;
    if (is_gone_face(i, k)) {
      // Nothing would be left at the edge.
      const Side inner = i == k ? RegionMesh::before(fan_.leaving[i]) : fan_.leaving[i];
      if (is_border && mesh_.next(inner) == inner) return false;
      continue;
    }
    for (Side member = mesh_.next(opposite); member != opposite; member = mesh_.next(member))
      if (mesh_.apex(member) == onto) return false;
  }
  return true;
}

bool Coarsening::is_too_long(Index a, Index b) const {
  const RegionMesh::Vertex &from = mesh_.vertices()[a], &to = mesh_.vertices()[b];
  const double longest = longest_edge_factor * bounds_.edge;
  return judged_squared(from.at, to.at, from.given, to.given) > longest * longest;
}

Coarsening::Shape Coarsening::shape_now() const {
  Shape found;
  for (const Side side : fan_.leaving)
    found.add(least_sine(mesh_.position(mesh_.from(side)), mesh_.position(mesh_.to(side)),
                         mesh_.position(mesh_.apex(side))));
  return found;
}

/// Of the faces that a collapse leaves; nothing where a triangle turns by more than 60 degrees or an edge
/// becomes too long.
std::optional<Coarsening::Shape> Coarsening::shape_after(std::size_t k) const {
  const Index onto = neighbour(mesh_, fan_, k);
  const Vec3d& target = mesh_.position(onto);
  Shape found;
  for (std::size_t i = 0; i < fan_.size(); ++i) {
    if (is_gone_face(i, k)) continue;
    const Side side = fan_.leaving[i];
    const Index a = mesh_.to(side), b = mesh_.apex(side);
    const Vec3d &p = mesh_.position(mesh_.from(side)), &q = mesh_.position(a), &r = mesh_.position(b);
    if (is_too_long(onto, a) || is_too_long(onto, b)) return {};
    const Vec3d before = (q - p).cross(r - p), now = (q - target).cross(r - target);
    constexpr double least_turn = 0.5;
    if (!(before.dot(now) > least_turn * before.norm() * now.norm())) return {};
    found.add(least_sine(target, q, r));
  }
  return found;
}

/// The ways to take out the vertex of the fan that leave good triangles, the best first.
std::vector<Coarsening::Way> Coarsening::ways() {
  std::vector<Way> found;
  const auto sharp = sharp_neighbours();
  if (!sharp || fan_.neighbour_count() < 3) return found;
  const Shape now = shape_now();
  const auto add = [&](std::size_t k, std::size_t crest) {
    const auto shape = shape_after(k);
    if (!shape) return;
    const bool is_better = shape->thin < now.thin && shape->least_sine >= now.least_sine;
    if (shape->thin == 0 || is_better) found.push_back({{k, crest}, shape->least_sine});
  };
  if (sharp->empty())
    for (std::size_t k = 0; k < fan_.size(); ++k) add(k, k);
  else
    for (const std::size_t i : {0, 1}) add((*sharp)[i], (*sharp)[1 - i]);
  std::ranges::stable_sort(found, std::ranges::greater(), &Way::least_sine);
  return found;
}

/// What is left on either side of the sharp line of a collapse, with what was there. Nothing where all of a
/// side would go.
std::vector<Coarsening::Part> Coarsening::parts(const RegionMesh::Collapse& how) const {
  const std::size_t count = fan_.size(), k = how.onto;
  const bool has_line = fan_.closed && how.crest != k;
  std::vector<Part> made(has_line ? 2 : 1);
  for (std::size_t i = 0; i < count; ++i) {
    const Side side = fan_.leaving[i];
    const bool is_first = !has_line || (i + count - k) % count < (how.crest + count - k) % count;
    Part& part = made[is_first ? 0 : 1];
    samples_.append_kept(side / 3, part.samples);
    const RegionMesh::Face& face = mesh_.faces()[side / 3];
    if (!is_gone_face(i, k)) {
      if (part.drafts.empty()) samples_.append_vertex(side, part.samples);
      part.drafts.push_back({side / 3, {face.corners, face.uv}});
    } else {
      part.uv = face.uv[(i == k ? RegionMesh::after(side) : RegionMesh::before(side)) % 3];
    }
  }
  if (std::ranges::any_of(made, [](const Part& part) { return part.drafts.empty(); })) made.clear();
  move_corners(how, made);
  return made;
}

/// Whether the places of the sharp line through the vertex are within the bounds of the edge that comes
/// instead; it keeps them then.
bool Coarsening::keeps_sharp_line(const RegionMesh::Collapse& how) {
  const Index gone = mesh_.from(fan_.leaving[0]), onto = neighbour(mesh_, fan_, how.onto),
              last = neighbour(mesh_, fan_, how.crest);
  const Vec3d &from = mesh_.position(onto), &to = mesh_.position(last);
  std::vector<Vec3d> places{mesh_.position(gone)};
  for (const Index end : {onto, last}) {
    const std::vector<Vec3d>& between = lines_.between(gone, end);
    places.insert(places.end(), between.begin(), between.end());
  }
  for (const Vec3d& place : places) {
    const double share = share_on_segment(from, to, place);
    if (!((place - from - share * (to - from)).squaredNorm() <= bounds_.apart * bounds_.apart)) return false;
  }
  lines_.between(onto, last) = std::move(places);
  return true;
}

/// Puts the neighbour in the place of the vertex.
void Coarsening::move_corners(const RegionMesh::Collapse& how, std::vector<Part>& parts) const {
  const Index gone = mesh_.from(fan_.leaving[0]), onto = neighbour(mesh_, fan_, how.onto);
  for (Part& part : parts)
    for (auto& [face, corners] : part.drafts) {
      const std::size_t at = corner_of(corners.vertices, gone);
      corners.vertices[at] = onto;
      corners.uv[at] = part.uv;
    }
}

bool Coarsening::collapse(Index vertex, const RegionMesh::Collapse& how) {
  std::vector<Part> left = parts(how);
  if (left.empty() || !satisfies_link(how.onto)) return false;
  for (Part& part : left)
    if (!samples_.assign(part.drafts, {bounds_.apart, bounds_.is_like}, part.samples)) return false;
  if (how.crest != how.onto && !keeps_sharp_line(how)) return false;
  for (const Part& part : left) samples_.keep(part.drafts, part.samples);
  mesh_.collapse(fan_, how);
  leaving_[vertex] = no_index;
  flip_around(left);
  look_at_touched();
  return true;
}

/// Whether the edge between two faces, both of which have changed, is to be turned towards Delaunay.
bool Coarsening::should_flip(Side side) {
  const Side other = mesh_.twin(side);
  if (mesh_.is_sharp_side(side) || other == no_index || mesh_.from(other) != mesh_.to(side)) return false;
  if (!mesh_.faces()[side / 3].changed || !mesh_.faces()[other / 3].changed) return false;
  const Index a = mesh_.from(side), b = mesh_.to(side), c = mesh_.apex(side), d = mesh_.apex(other);
  if (mesh_.vertices()[c].is_crowded || mesh_.vertices()[d].is_crowded || is_too_long(c, d)) return false;
  const FaceQuad quad{mesh_.position(a), mesh_.position(b), mesh_.position(c), mesh_.position(d)};
  return !quad.is_delaunay() && quad.can_flip(bounds_.apart) &&
         !mesh_.are_joined(RegionMesh::before(side), d);
}

bool Coarsening::flip(Side side) {
  const Index one = side / 3, two = mesh_.twin(side) / 3;
  const auto [first, second] = mesh_.flipped(side);
  const std::array<DrawnSamples::Draft, 2> drafts{{{one, first}, {two, second}}};
  std::vector<DrawnSamples::Sample> samples;
  for (const Index face : {one, two}) samples_.append_kept(face, samples);
  if (!samples_.assign(drafts, {bounds_.apart, bounds_.is_like}, samples)) return false;
  samples_.keep(drafts, samples);
  return true;
}

/// Improves the faces that came in place of others.
void Coarsening::flip_around(const std::vector<Part>& parts) {
  touched_.clear();
  for (const Part& part : parts)
    for (const DrawnSamples::Draft& draft : part.drafts) {
      touched_.push_back(draft.face);
      for (Side side = 3 * draft.face; side < 3 * draft.face + 3; ++side) to_flip_.push_back(side);
    }
  // Where a surface is not flat flips might go round in circles.
  std::size_t left = 32 * touched_.size();
  std::array<Side, 4> outer{};
  while (!to_flip_.empty()) {
    const Side side = to_flip_.back();
    to_flip_.pop_back();
    if (left == 0 || !should_flip(side) || !flip(side)) continue;
    --left;
    touched_.push_back(side / 3);
    touched_.push_back(mesh_.twin(side) / 3);
    mesh_.flip(side, outer);
    to_flip_.insert(to_flip_.end(), outer.begin(), outer.end());
  }
}

/// Looks again at the corners of faces that changed.
void Coarsening::look_at_touched() {
  std::vector<Index> corners;
  for (const Index face : touched_)
    for (Side side = 3 * face; side < 3 * face + 3; ++side) {
      const Index vertex = mesh_.from(side);
      if (vertex >= leaving_.size() || leaving_[vertex] == no_index) continue;
      leaving_[vertex] = side;
      corners.push_back(vertex);
    }
  sort_unique(corners);
  for (const Index vertex : corners) look_at(vertex);
}

void Coarsening::try_to_remove(Index vertex) {
  if (!find_fan(mesh_, leaving_[vertex], fan_)) return;
  for (const Way& way : ways())
    if (collapse(vertex, way.how)) return;
}

SurfacePatch Coarsening::made() const {
  SurfacePatch patch;
  const auto number = [&](Index vertex) { return mesh_.vertices()[vertex].source; };
  for (const RegionMesh::Face& face : mesh_.faces()) {
    if (!face.changed || face.gone) continue;
    patch.triangles.push_back({number(face.corners[0]), number(face.corners[1]), number(face.corners[2])});
    if (!surface_.triangle_uv.empty()) patch.triangle_uv.push_back(face.uv);
  }
  patch.removed = mesh_.changed_triangles();
  return patch;
}

}  // namespace

SurfacePatch coarsen_surface(const Surface& surface, std::span<const Index> vertices,
                             const CoarsenBounds& bounds, std::span<const Vec3f> given) {
  Coarsening coarsening(surface, bounds, given.empty() ? surface.positions : given);
  coarsening.run(vertices);
  return coarsening.made();
}

}  // namespace burin
