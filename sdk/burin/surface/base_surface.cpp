// Base surfaces by moving least squares over clusters [Lancaster and Salkauskas 1981]. The height over the
// plane across the mean normal is a weighted least-squares quadratic in (x, y), whose value at the node keeps
// heights of third degree and nearly removes waves shorter than the reach; twice, since a second time removes
// as much of what came through and adds as little to the loss of longer waves. Clusters count by their area
// as seen along the normal, which is what an integral over (x, y) asks for however steep the relief is.
#include <burin/base/parallel.h>
#include <burin/base/sort_unique.h>
#include <burin/surface/base_surface.h>
#include <burin/surface/quadratic_fit.h>
#include <burin/surface/triangle_shape.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace burin {
namespace {

constexpr std::size_t nodes_a_block = 64;

/// Over which heights are fitted, in radii, and over which paraboloids are, and are blended, in spacings.
constexpr double reach_over_radius = 0.55, ring_over_spacing = 2.5, blend_over_spacing = 1.6;

/// Normals of the base surface that differ by more (cosine) do not belong to one patch.
constexpr float same_side = 0.2F;

/// The nodes around one that are connected with it through others, nearest in edges first.
class Nearby {
 public:
  /// Of those that `within(node)` holds for; the first always counts. Never more than fit into the table.
  template <class Within>
  std::span<const Index> find(const Csr& neighbours, Index node, const Within& within) {
    table_.fill(no_index);
    found_.clear();
    insert(node);
    for (std::size_t i = 0; i < found_.size() && found_.size() < most; ++i)
      for (const Index neighbour : neighbours[found_[i]])
        if (found_.size() < most && !known(neighbour) && within(neighbour)) insert(neighbour);
    return found_;
  }

 private:
  static constexpr std::size_t table_size = 4096, most = table_size / 2;

  std::size_t slot_of(Index node) const {
    std::size_t slot = node * std::size_t{2654435761} % table_size;
    while (table_[slot] != no_index && table_[slot] != node) slot = (slot + 1) % table_size;
    return slot;
  }
  bool known(Index node) const { return table_[slot_of(node)] == node; }
  void insert(Index node) {
    table_[slot_of(node)] = node;
    found_.push_back(node);
  }

  std::array<Index, table_size> table_;
  std::vector<Index> found_;
};

Vec3f local(const Vec3f& origin, const Vec3f& axis_x, const Vec3f& axis_y, const Vec3f& normal,
            const Vec3f& point) {
  const Vec3f way = point - origin;
  return {way.dot(axis_x), way.dot(axis_y), way.dot(normal)};
}

}  // namespace

Vec2f BasePatch::foot(const Vec3f& point) const {
  const Vec3f flat = local(position, axis_x, axis_y(), normal, point);
  const Vec2f below = flat.head<2>();
  Vec2f at = below;
  for (int i = 0; i < 2; ++i) at = below + (flat.z() - height(at)) * slope(at);
  return at;
}

Vec3f BasePatch::place(const Vec2f& at) const {
  return position + at.x() * axis_x + at.y() * axis_y() + height(at) * normal;
}

Vec3f BasePatch::normal_at(const Vec2f& at) const {
  const Vec2f tilt = slope(at);
  return (normal - tilt.x() * axis_x - tilt.y() * axis_y()).normalized();
}

bool BaseSurface::set_radius(double radius) {
  const auto coarse_enough = [&](std::size_t level) {
    return levels_->spacing(level) * (level == 0 ? fewest_own_edges : fewest_edges) <= radius;
  };
  std::size_t level = levels_->size() - 1;
  while (level > 0 && !coarse_enough(level)) --level;
  if (!coarse_enough(level)) return false;
  const double reach = reach_over_radius * radius;
  if (!stages_.empty() && level == level_ && reach == reach_) return true;
  level_ = level;
  reach_ = reach;
  ring_ = ring_over_spacing * spacing();
  const Index count = node_count();
  stages_.assign(count, Stage::nothing);
  around_.assign(count, false);
  means_.resize(count);
  once_.resize(count);
  low_passed_.resize(count);
  patches_.resize(count);
  nodes_.positions.resize(count);
  nodes_.normals.resize(count);
  nodes_.gauss_curvature.resize(count);
  nodes_.neighbours = neighbours();
  nodes_.source_vertex.resize(count);
  std::iota(nodes_.source_vertex.begin(), nodes_.source_vertex.end(), Index{0});
  nodes_.scale = surface_->scale;
  return true;
}

/// Vertices of a run are near each other, so that little is forgotten in vain.
void BaseSurface::forget(std::span<const Index> moved_vertices, double distance) {
  if (stages_.empty()) return;
  std::vector<Index> nodes;
  for (const Index vertex : moved_vertices) {
    nodes.push_back(node_of(vertex));
    // Areas of triangles beside it belong to its neighbours too.
    for (const Index neighbour : surface_->neighbours[vertex]) nodes.push_back(node_of(neighbour));
  }
  sort_unique(nodes);
  constexpr std::size_t nodes_a_run = 1024;
  for (std::size_t begin = 0; begin < nodes.size(); begin += nodes_a_run) {
    const auto run = std::span(nodes).subspan(begin, std::min(nodes_a_run, nodes.size() - begin));
    for (const Index node : around(run, 2 * reach_ + ring_ + distance)) stages_[node] = Stage::nothing;
  }
}

void BaseSurface::prepare(std::span<const Index> nodes) {
  if (std::ranges::all_of(nodes, [&](Index node) { return stages_[node] == Stage::fitted; })) return;
  const std::vector<Index> fitted_over = around(nodes, ring_);
  const std::vector<Index> again_over = around(fitted_over, reach_);
  const std::vector<Index> smoothed_over = around(again_over, reach_);
  bring_to(Stage::averaged, smoothed_over, [this](Index node) { means_[node] = mean_of(node); });
  bring_to(Stage::smoothed, again_over, [this](Index node) {
    once_[node] = low_passed(node, [this](Index at) -> const Vec3f& { return means_[at].position; });
  });
  bring_to(Stage::smoothed_again, fitted_over, [this](Index node) {
    low_passed_[node] = low_passed(node, [this](Index at) -> const Vec3f& { return once_[at].position; });
  });
  bring_to(Stage::fitted, nodes, [this](Index node) { make_patch(node); });
}

void BaseSurface::prepare_around(Index node) {
  const std::vector<Index> nodes = around(std::array{node}, spacing());
  prepare(nodes);
}

/// Makes of these nodes those that are not at the stage yet, each of which was at the one before.
template <class Make>
void BaseSurface::bring_to(Stage stage, std::span<const Index> nodes, const Make& make) {
  std::vector<Index> missing;
  for (const Index node : nodes) {
    if (stages_[node] >= stage) continue;
    stages_[node] = stage;
    missing.push_back(node);
  }
  parallel_blocks(missing.size(), nodes_a_block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) make(missing[i]);
  });
}

/// These nodes and all that may lie within `reach` of one of them and be connected with it within: those that
/// are connected within a box. Low-passed places and means lie within about a cluster of its vertices.
std::vector<Index> BaseSurface::around(std::span<const Index> nodes, double reach) {
  Eigen::AlignedBox3f box;
  for (const Index node : nodes) box.extend(vertex_of(node));
  const auto margin = static_cast<float>(reach + 4 * spacing());
  box.min().array() -= margin;
  box.max().array() += margin;
  std::vector<Index> found;
  const auto add = [&](Index node) {
    if (around_[node]) return;
    around_[node] = true;
    found.push_back(node);
  };
  for (const Index node : nodes) add(node);
  for (std::size_t i = 0; i < found.size(); ++i)
    for (const Index neighbour : neighbours()[found[i]])
      if (!around_[neighbour] && box.contains(vertex_of(neighbour))) add(neighbour);
  for (const Index node : found) around_[node] = false;
  return found;
}

BaseSurface::Mean BaseSurface::mean_of(Index node) const {
  Vec3d position = Vec3d::Zero(), area = Vec3d::Zero(), plain = Vec3d::Zero();
  double weights = 0, count = 0;
  for_each_vertex(node, [&](Index vertex) {
    Vec3d doubled = Vec3d::Zero();
    double weight = 0;
    const Vec3f& at = surface_->positions[vertex];
    for (const Index index : surface_->incident[vertex]) {
      const Triangle& triangle = surface_->triangles[index];
      const std::size_t corner = corner_of(triangle, vertex);
      const Vec3d normal = (surface_->positions[triangle[(corner + 1) % 3]] - at)
                               .cross(surface_->positions[triangle[(corner + 2) % 3]] - at)
                               .cast<double>();
      doubled += normal;
      weight += normal.norm();
    }
    area += doubled / 6;
    position += weight * at.cast<double>();
    weights += weight;
    plain += at.cast<double>();
    count += 1;
  });
  return {(weights > 0 ? Vec3d(position / weights) : Vec3d(plain / count)).cast<float>(), area.cast<float>()};
}

/// place(other): where another node stands before.
template <class Place>
BaseSurface::LowPassed BaseSurface::low_passed(Index node, const Place& place) const {
  const Vec3f& origin = place(node);
  const auto squared = [&](Index other) {
    return static_cast<double>((place(other) - origin).squaredNorm());
  };
  Nearby nearby;
  const double whole = reach_ * reach_;
  std::span<const Index> found =
      nearby.find(neighbours(), node, [&](Index n) { return squared(n) <= whole; });
  Vec3f sum = Vec3f::Zero();
  for (const Index other : found)
    if (4 * squared(other) <= whole) sum += means_[other].area;
  if (!(sum.squaredNorm() > 0)) return {origin, Vec3f::Zero()};
  const Vec3f normal = sum.normalized(), axis_x = normal.unitOrthogonal(), axis_y = normal.cross(axis_x);
  const auto seen = [&](Index other) { return static_cast<double>(means_[other].area.dot(normal)); };
  // Where a sheet turns away, what is connected beyond it is another one.
  if (std::ranges::any_of(found, [&](Index other) { return seen(other) <= 0; }))
    found = nearby.find(neighbours(), node, [&](Index n) { return squared(n) <= whole && seen(n) > 0; });
  QuadraticFit fit(reach_);
  for (const Index other : found)
    fit.add(local(origin, axis_x, axis_y, normal, place(other)), std::max(seen(other), 0.));
  return {origin + static_cast<float>(fit.solve()[0]) * normal, normal};
}

BasePatch BaseSurface::patch_of(Index node) const {
  const Vec3f& origin = low_passed_[node].position;
  const auto near = [&](Index other) {
    return static_cast<double>((low_passed_[other].position - origin).squaredNorm()) <= ring_ * ring_ &&
           low_passed_[other].normal.dot(low_passed_[node].normal) > same_side;
  };
  Nearby nearby;
  const std::span<const Index> ring = nearby.find(neighbours(), node, near);
  Vec3f normal = low_passed_[node].normal;
  if (normal.isZero(0)) normal = Vec3f::UnitZ();
  for (int round = 0;; ++round) {
    const Vec3f axis_x = normal.unitOrthogonal(), axis_y = normal.cross(axis_x);
    QuadraticFit fit(ring_);
    for (const Index other : ring)
      fit.add(local(origin, axis_x, axis_y, normal, low_passed_[other].position), 1);
    const QuadraticFit::Terms z = fit.solve();
    if (round == 2)
      return {origin,
              normal,
              axis_x,
              static_cast<float>(z[3]),
              static_cast<float>(z[4]),
              static_cast<float>(z[5])};
    normal = (normal - static_cast<float>(z[1]) * axis_x - static_cast<float>(z[2]) * axis_y).normalized();
  }
}

void BaseSurface::make_patch(Index node) {
  patches_[node] = patch_of(node);
  nodes_.positions[node] = patches_[node].position;
  nodes_.normals[node] = patches_[node].normal;
  nodes_.gauss_curvature[node] = patches_[node].gauss_curvature();
}

Index BaseSurface::nearest(Index near, const Vec3f& point) {
  for (;;) {
    std::vector<Index> candidates{near};
    for (const Index neighbour : neighbours()[near]) candidates.push_back(neighbour);
    for (const Index candidate : candidates) require(candidate);
    const Index best = *std::ranges::min_element(candidates, {}, [&](Index node) {
      const bool same = patches_[node].normal.dot(patches_[near].normal) > 0;
      return same ? (patches_[node].position - point).squaredNorm() : std::numeric_limits<float>::infinity();
    });
    if (best == near) return near;
    near = best;
  }
}

BasePoint BaseSurface::project(Index near, const Vec3f& point) {
  const Index node = nearest(near, point);
  const BasePatch& own = patches_[node];
  const Vec2f foot = own.foot(point);
  const Vec3f middle = own.place(foot);
  const double reach = blend_over_spacing * spacing();
  const auto squared = [&](Index other) {
    return static_cast<double>((patches_[other].position - middle).squaredNorm()) / (reach * reach);
  };
  std::vector<Index> two_rings{node};
  for (const Index one : neighbours()[node]) {
    two_rings.push_back(one);
    for (const Index two : neighbours()[one]) two_rings.push_back(two);
  }
  sort_unique(two_rings);
  Vec3d position = Vec3d::Zero(), normal = Vec3d::Zero();
  double weights = 0;
  for (const Index other : two_rings) require(other);
  for (const Index other : two_rings) {
    const BasePatch& patch = patches_[other];
    const double weight = patch.normal.dot(own.normal) > same_side ? bump_weight(squared(other)) : 0;
    if (!(weight > 0)) continue;
    const Vec2f at = patch.foot(point);
    position += weight * patch.place(at).cast<double>();
    normal += weight * patch.normal_at(at).cast<double>();
    weights += weight;
  }
  if (!(weights > 0 && normal.squaredNorm() > 0)) return {middle, own.normal_at(foot), node};
  return {(position / weights).cast<float>(), normal.normalized().cast<float>(), node};
}

}  // namespace burin
