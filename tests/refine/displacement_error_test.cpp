// Surfaces that are refined for displacements of known form: smooth ones, which they represent to the bound,
// and a step, along which they get the least edges.
#include <burin/refine/displacement_error.h>
#include <burin/refine/refine_surface.h>
#include <burin/surface/surface_patch.h>
#include <burin/surface/topology/euler.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numeric>

#include "refined.h"
#include "support/shapes.h"

namespace burin::test {
namespace {

using Height = std::function<double(const Vec3d& place)>;

/// A surface that is raised along z.
struct Raised {
  Surface surface;
  Height height;

  std::vector<Vec3f> displaced() const {
    std::vector<Vec3f> places = surface.positions;
    for (Vec3f& p : places) p.z() += static_cast<float>(height(p.cast<double>()));
    return places;
  }
  DisplacementError error(const DisplacementBound& bound) const {
    std::vector<Index> all(surface.vertex_count());
    std::iota(all.begin(), all.end(), Index{0});
    return displacement_error(surface, displaced(), all, bound);
  }
  /// Refines until nothing is found any more; returns how often, and checks lengths and angles.
  int refine(const DisplacementBound& bound) {
    double shortest = 1;
    const EdgeLength everywhere({{Vec3d::Zero()}}, 10, 1);
    const Shapes before(surface, everywhere, true);
    int passes = 0;
    for (; passes < 10; ++passes) {
      const DisplacementError found = error(bound);
      if (found.empty()) break;
      const EdgeLength lengths(found.lengths);
      surface = patched(surface, refine_surface(surface, lengths, found.triangles, 1'000'000).patch).surface;
      expect_no_longer_edges(surface, lengths);
      shortest = std::min(shortest, lengths.edge());
    }
    const Shapes after(surface, everywhere, true);
    EXPECT_GE(after.edges.front(), 0.4 * shortest);
    EXPECT_GE(after.angles.front(), 0.5 * before.angles.front());
    EXPECT_GE(after.first_percent(), 20);
    return passes;
  }
  static void expect_no_longer_edges(const Surface& surface, const EdgeLength& lengths) {
    std::size_t longer = 0;
    for (Index v = 0; v < surface.vertex_count(); ++v)
      for (const Index other : surface.neighbours[v]) {
        const Vec3d from = surface.positions[v].cast<double>(), to = surface.positions[other].cast<double>();
        longer += lengths.is_exceeded(from, lengths.at(from), to, lengths.at(to), (to - from).norm(), 1.4);
      }
    EXPECT_EQ(longer, 0u);
  }
  /// The greatest error in the middles of triangles and of their edges.
  double greatest_error() const {
    double most = 0;
    for (const Triangle& t : surface.triangles)
      for (const Vec3d& w : {Vec3d(1, 1, 1), Vec3d(1, 1, 0), Vec3d(0, 1, 1), Vec3d(1, 0, 1)}) {
        Vec3d at = Vec3d::Zero();
        double linear = 0;
        for (std::size_t i = 0; i < 3; ++i) {
          const Vec3d corner = surface.positions[t[i]].cast<double>();
          at += w[static_cast<Eigen::Index>(i)] / w.sum() * corner;
          linear += w[static_cast<Eigen::Index>(i)] / w.sum() * height(corner);
        }
        most = std::max(most, std::abs(linear - height(at)));
      }
    return most;
  }
};

Surface irregular_plane(double edge) { return make_surface(shuffled(plane(1, edge, 3), 4)); }

TEST(DisplacementError, IsNoneWhereADisplacementIsLinear) {
  const Raised raised{irregular_plane(0.1), [](const Vec3d& p) { return 0.3 * p.x() - 0.2 * p.y() + 0.1; }};
  EXPECT_TRUE(raised.error({.share = 0.001, .least_edge = 1e-4}).empty());
}

TEST(DisplacementError, IsBoundedAfterRefinement) {
  const Height heights[] = {
      [](const Vec3d& p) { return 0.2 * std::exp(-p.head<2>().squaredNorm() / (2 * 0.1 * 0.1)); },
      [](const Vec3d& p) { return 0.1 * std::cos(8 * p.x() + 3 * p.y()); },
      [](const Vec3d& p) { return 0.1 * (p.x() * p.x() - p.y() * p.y()); }};
  const double amplitudes[] = {0.2, 0.1, 0.1}, edges[] = {0.1, 0.1, 0.25};
  for (std::size_t i = 0; i < 3; ++i) {
    SCOPED_TRACE(i);
    Raised raised{irregular_plane(edges[i]), heights[i]};
    EXPECT_GT(raised.greatest_error(), 0.02 * amplitudes[i]);
    const DisplacementBound bound{.share = 0.01, .least_edge = 1e-4};
    EXPECT_LE(raised.refine(bound), 5);
    EXPECT_LT(raised.greatest_error(), 0.015 * amplitudes[i]);
    EXPECT_EQ(euler_characteristic(raised.surface), 1);
  }
}

// Triangles along the step only, so a tenth of those that a mesh has with such edges everywhere.
TEST(DisplacementError, GivesStepsTheLeastEdges) {
  constexpr double least = 0.004;
  const auto beside = [](const Vec3d& p) { return p.x() + 0.3 * p.y() * p.y(); };
  Raised raised{irregular_plane(0.1), [&](const Vec3d& p) { return beside(p) > 0 ? 0.1 : 0.; }};
  raised.refine({.share = 0.01, .least_edge = least});
  for (const Triangle& t : raised.surface.triangles) {
    double lowest = 1, highest = 0, longest = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3d a = raised.surface.positions[t[i]].cast<double>(),
                  b = raised.surface.positions[t[(i + 1) % 3]].cast<double>();
      lowest = std::min(lowest, raised.height(a));
      highest = std::max(highest, raised.height(a));
      longest = std::max(longest, (b - a).norm());
    }
    if (lowest != highest) EXPECT_LE(longest, longest_edge_factor * least * 1.01);
  }
  const double everywhere = 4 / (std::sqrt(3) / 4 * least * least);
  EXPECT_LT(static_cast<double>(raised.surface.triangles.size()), everywhere / 10);
}

}  // namespace
}  // namespace burin::test
