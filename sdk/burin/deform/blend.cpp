#include <burin/base/parallel.h>
#include <burin/deform/blend.h>
#include <burin/deform/displacement.h>
#include <burin/deform/first_failure.h>
#include <burin/deform/vertex_sheets.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace burin {
namespace {

bool is_sum(Overlap overlap) { return overlap == Overlap::add || overlap == Overlap::average; }

/// Where the nodes of a vertex say that it goes.
class VertexBlend {
 public:
  VertexBlend(const Surface& surface, std::span<const InstanceSheets> instances, Index vertex)
      : base_(surface.positions[vertex]), sheets_(instances, vertex) {}

  Vec3f place(const BlendOptions& options) const {
    Vec3f free = unlimited(options);
    const double distance = (free - base_).cast<double>().norm();
    if (!(distance > options.limit)) return free;
    return base_ + static_cast<float>(options.limit / distance) * (free - base_);
  }

 private:
  Vec3f unlimited(const BlendOptions& options) const;
  Vec3f place(const SheetNode& node) const {
    return displaced(base_, node.chart().e1[node.slot], node.chart().normal[node.slot], node.displacement());
  }
  bool farther_out(const SheetNode& a, const SheetNode& b) const;
  SheetNode winner(Overlap overlap) const;
  Vec3d in_space(const SheetNode& node) const;
  Vec3d sum(const BlendOptions& options) const;

  const Vec3f& base_;
  VertexSheets sheets_;
};

/// By the displacement along the normal; ties by where the vertex would go, whatever the order of sheets.
bool VertexBlend::farther_out(const SheetNode& a, const SheetNode& b) const {
  const float up_a = a.displacement().z(), up_b = b.displacement().z();
  if (up_a != up_b) return up_a > up_b;
  const Vec3f place_a = place(a), place_b = place(b);
  return std::lexicographical_compare(place_b.begin(), place_b.end(), place_a.begin(), place_a.end());
}

SheetNode VertexBlend::winner(Overlap overlap) const {
  std::optional<SheetNode> best;
  sheets_.for_each([&](const SheetNode& node) {
    const bool better = !best || overlap == Overlap::latest ||
                        (overlap == Overlap::max && farther_out(node, *best)) ||
                        (overlap == Overlap::min && farther_out(*best, node));
    if (better) best = node;
  });
  return *best;
}

/// In doubles, so that floats cannot tell in which order sums were taken.
Vec3d VertexBlend::in_space(const SheetNode& node) const {
  const Vec3d n = node.chart().normal[node.slot].cast<double>();
  const Vec3d e1 = node.chart().e1[node.slot].cast<double>();
  return burin::in_space<Vec3d>(e1, n, node.displacement().cast<double>());
}

Vec3d VertexBlend::sum(const BlendOptions& options) const {
  Vec3d total = Vec3d::Zero();
  if (options.overlap == Overlap::latest) {
    sheets_.for_each_weighed(options.radius,
                             [&](const SheetNode& node, double weight) { total += weight * in_space(node); });
    return total;
  }
  sheets_.for_each([&](const SheetNode& node) { total += in_space(node); });
  return options.overlap == Overlap::add ? total : Vec3d(total / static_cast<double>(sheets_.count()));
}

Vec3f VertexBlend::unlimited(const BlendOptions& options) const {
  if (sheets_.count() == 0) return base_;
  if (sheets_.count() == 1) return place(sheets_.first());
  std::size_t instances = 0;
  sheets_.for_each_latest([&](const SheetNode&) { ++instances; });
  const bool summed = is_sum(options.overlap) || (options.overlap == Overlap::latest && instances > 1);
  if (!summed) return place(winner(options.overlap));
  const Vec3d total = sum(options);
  if (total.isZero(0)) return base_;
  return (base_.cast<double>() + total).cast<float>();
}

Tint blended_tint(const VertexSheets& sheets, const Tint& before, const BlendOptions& options) {
  if (sheets.count() == 0) return before;
  Eigen::Matrix<double, 5, 1> sum = Eigen::Matrix<double, 5, 1>::Zero();
  if (options.overlap == Overlap::latest) {
    sheets.for_each_weighed(options.radius, [&](const SheetNode& node, double weight) {
      sum += weight * node.tint().cast<double>();
    });
    return sum.cast<float>();
  }
  if (is_sum(options.overlap)) {
    sheets.for_each([&](const SheetNode& node) { sum += (node.tint() - before).cast<double>(); });
    if (options.overlap == Overlap::average) sum /= static_cast<double>(sheets.count());
    return (before.cast<double>() + sum).cwiseMax(0).cwiseMin(1).cast<float>();
  }
  std::optional<Tint> best;
  sheets.for_each([&](const SheetNode& node) {
    if (!best) best = node.tint();
    const Tint most = best->cwiseMax(node.tint()), least = best->cwiseMin(node.tint());
    best = options.overlap == Overlap::max ? most : least;
  });
  return *best;
}

}  // namespace

void blend_sheets(const Surface& surface, std::span<const InstanceSheets> instances,
                  std::span<const Index> vertices, const BlendOptions& options, std::string_view brush,
                  std::span<Vec3f> places) {
  FirstFailure failure;
  parallel_blocks(vertices.size(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      places[i] = VertexBlend(surface, instances, vertices[i]).place(options);
      if (!places[i].allFinite()) return failure.note(i, "displaces beyond the range of floats");
    }
  });
  if (!failure.any()) return;
  VertexSheets(instances, vertices[failure.element()]).for_each([&](const SheetNode& node) {
    failure.throw_at(brush, node.chart(), node.slot);
  });
}

void blend_tints(const Paint& paint, std::span<const InstanceSheets> instances,
                 std::span<const Index> vertices, const BlendOptions& options, std::span<Tint> tints) {
  parallel_blocks(vertices.size(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Tint before = tint_of(paint.colour_of(vertices[i]), paint.mask_of(vertices[i]));
      tints[i] = blended_tint(VertexSheets(instances, vertices[i]), before, options);
    }
  });
}

}  // namespace burin
