// Interpolates the normal coordinates of base nodes to vertices by moving least squares [Lancaster and
// Salkauskas 1981], as the base surface itself is computed. Costs one fit per node, and O(1) per vertex.
#include <burin/base/parallel.h>
#include <burin/chart/dabs/dab_transfer.h>
#include <burin/surface/geometry/parallel_transport.h>
#include <burin/surface/geometry/quadratic_fit.h>
#include <burin/surface/topology/connected_nodes.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace burin {
namespace {

/// Radius within which nodes take part in a fit, in spacings of the base nodes.
constexpr double ring_over_spacing = 2.5;

/// The nodes of a dab and their patches.
class DabNodes {
 public:
  DabNodes(BaseSurface& base, const DabChart& chart) : base_(base), chart_(chart) {
    patches_.reserve(chart.size());
    for (const Index node : chart.vertex) patches_.push_back(base.patch(node));
  }

  const DabChart& chart() const { return chart_; }
  const BasePatch& patch(std::size_t i) const { return patches_[i]; }
  double reach() const { return ring_over_spacing * base_.spacing(); }

  /// The elements around element i, itself included, whose coordinates agree with its own. Behind a horn,
  /// where a dab meets itself, the coordinates of the two sides must not be mixed.
  std::vector<std::size_t> around(std::size_t i) const {
    ConnectedNodes connected;
    std::vector<std::size_t> elements{i};
    connected.find(base_.neighbours(), std::array{chart_.vertex[i]}, [&](Index node) {
      const auto found = find(node);
      const bool counts = found && near(i, *found);
      if (counts && agree(i, *found)) elements.push_back(*found);
      return counts;
    });
    return elements;
  }

 private:
  std::optional<std::size_t> find(Index node) const {
    const auto found = std::ranges::lower_bound(chart_.vertex, node);
    if (found == chart_.vertex.end() || *found != node) return {};
    return static_cast<std::size_t>(found - chart_.vertex.begin());
  }
  float distance(std::size_t i, std::size_t other) const {
    return (patches_[other].position - patches_[i].position).norm();
  }
  bool near(std::size_t i, std::size_t other) const {
    return static_cast<double>(distance(i, other)) <= reach() &&
           patches_[i].normal.dot(patches_[other].normal) > 0;
  }
  bool agree(std::size_t i, std::size_t other) const {
    const Vec2f apart(chart_.u[other] - chart_.u[i], chart_.v[other] - chart_.v[i]);
    return apart.norm() <= 2 * distance(i, other);
  }

  const BaseSurface& base_;
  const DabChart& chart_;
  std::vector<BasePatch> patches_;  ///< [element]
};

/// Quadratics in the local coordinates (x, y) of a node's patch, fitted to the dab's coordinates (u, v) and
/// to its e1, which is expressed in the node's frame (e1, e2).
class DabPatch {
 public:
  DabPatch(const DabNodes& nodes, std::size_t i)
      : patch_(nodes.patch(i)), e1_(nodes.chart().e1[i]), e2_(patch_.normal.cross(e1_)) {
    const DabChart& chart = nodes.chart();
    std::array<QuadraticFit, 4> fits{QuadraticFit(nodes.reach()), QuadraticFit(nodes.reach()),
                                     QuadraticFit(nodes.reach()), QuadraticFit(nodes.reach())};
    for (const std::size_t other : nodes.around(i)) {
      const BasePatch& there = nodes.patch(other);
      const Vec3f way = there.position - patch_.position;
      const Vec3f carried = transport(chart.e1[other], there.normal, patch_.normal);
      const std::array values{chart.u[other], chart.v[other], carried.dot(e1_), carried.dot(e2_)};
      for (std::size_t k = 0; k < fits.size(); ++k)
        fits[k].add({way.dot(patch_.axis_x), way.dot(patch_.axis_y()), values[k]});
    }
    for (std::size_t k = 0; k < fits.size(); ++k) terms_[k] = fits[k].solve();
  }

  Vec2f coordinates(const BasePatch::Local<float>& at) const {
    return {static_cast<float>(value(0, at)), static_cast<float>(value(1, at))};
  }

  Vec3f e1(const BasePatch::Local<float>& at) const {
    const auto along = static_cast<float>(value(2, at)), across = static_cast<float>(value(3, at));
    const Vec3f mean = along * e1_ + across * e2_;
    return transport(mean.squaredNorm() > 0 ? Vec3f(mean.normalized()) : e1_, patch_.normal,
                     patch_.normal_at(at));
  }

 private:
  double value(std::size_t k, const BasePatch::Local<float>& at) const {
    const QuadraticFit::Terms& z = terms_[k];
    const double x = static_cast<double>(at.x), y = static_cast<double>(at.y);
    return z[0] + z[1] * x + z[2] * y + (z[3] * x * x + z[5] * y * y) / 2 + z[4] * x * y;
  }

  const BasePatch& patch_;
  Vec3f e1_, e2_;
  std::array<QuadraticFit::Terms, 4> terms_;
};

void append(DabChart& chart, Index vertex, const Vec2f& at, const Vec3f& e1, const Vec3f& normal) {
  chart.vertex.push_back(vertex);
  chart.u.push_back(at.x());
  chart.v.push_back(at.y());
  chart.e1.push_back(e1);
  chart.normal.push_back(normal);
}

/// Concatenates the parts and sorts their elements by vertex.
DabChart select_nodes(const std::vector<DabChart>& parts) {
  struct Place {
    Index vertex;
    const DabChart* part;
    std::size_t element;
  };
  std::vector<Place> places;
  for (const DabChart& part : parts)
    for (std::size_t i = 0; i < part.size(); ++i) places.push_back({part.vertex[i], &part, i});
  std::ranges::sort(places, {}, &Place::vertex);
  DabChart chart;
  for (const auto& [vertex, part, i] : places)
    append(chart, vertex, {part->u[i], part->v[i]}, part->e1[i], part->normal[i]);
  return chart;
}

}  // namespace

DabChart transferred_dab(BaseSurface& base, const Surface& surface, const DabChart& nodes, double radius) {
  const DabNodes on_base(base, nodes);
  constexpr std::size_t nodes_per_block = 16;
  std::vector<DabChart> parts((nodes.size() + nodes_per_block - 1) / nodes_per_block);
  parallel_blocks(nodes.size(), nodes_per_block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const BasePatch& patch = on_base.patch(i);
      const DabPatch fitted(on_base, i);
      base.for_each_vertex(nodes.vertex[i], [&](Index vertex) {
        const BasePatch::Local<float> foot = patch.foot(surface.positions[vertex]);
        const Vec2f at = fitted.coordinates(foot);
        if (at.cast<double>().norm() <= radius)
          append(parts[begin / nodes_per_block], vertex, at, fitted.e1(foot), patch.normal_at(foot));
      });
    }
  });
  return select_nodes(parts);
}

}  // namespace burin
