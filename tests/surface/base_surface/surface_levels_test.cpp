#include <burin/base/parallel.h>
#include <burin/surface/base_surface/surface_levels.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "support/point_shapes.h"

namespace burin {
namespace {

Surface ball() { return make_surface(test::shuffled(test::sphere(6, 0.2, 5), 9)); }

/// The vertices of each cluster of a level.
std::vector<std::vector<Index>> clusters_of(const SurfaceLevels& levels, std::size_t level) {
  std::vector<std::vector<Index>> clusters(levels.neighbours(level).rows());
  for (Index cluster = 0; cluster < clusters.size(); ++cluster)
    levels.for_each_vertex(level, cluster, [&](Index vertex) { clusters[cluster].push_back(vertex); });
  return clusters;
}

TEST(SurfaceLevels, PutEachVertexIntoOneCluster) {
  const Surface surface = ball();
  const SurfaceLevels levels(surface);
  ASSERT_GE(levels.size(), 5U);
  for (std::size_t level = 0; level < levels.size(); ++level) {
    std::vector<Index> seen;
    const auto clusters = clusters_of(levels, level);
    for (Index cluster = 0; cluster < clusters.size(); ++cluster) {
      EXPECT_EQ(levels.cluster(level, levels.first_member(level, cluster, 0)), cluster);
      for (const Index vertex : clusters[cluster]) {
        EXPECT_EQ(levels.cluster(level, vertex), cluster);
        seen.push_back(vertex);
      }
    }
    std::ranges::sort(seen);
    ASSERT_EQ(seen.size(), surface.vertex_count());
    EXPECT_EQ(std::ranges::adjacent_find(seen), seen.end());
  }
}

// A point set has levels of about the spacing of the mesh that its points are the vertices of.
TEST(SurfaceLevels, OfPointsAreAsWideAsThoseOfTheirTriangles) {
  const Surface points = make_point_surface(test::sphere_points(6, 4)), mesh = ball();
  const SurfaceLevels of_points(points), of_mesh(mesh);
  ASSERT_EQ(of_points.size(), of_mesh.size());
  for (std::size_t level = 0; level < of_points.size(); ++level)
    EXPECT_NEAR(of_points.spacing(level) / of_mesh.spacing(level), 1, 0.2) << "level " << level;
}

TEST(SurfaceLevels, DoubleTheSpacing) {
  const Surface surface = ball();
  const SurfaceLevels levels(surface);
  for (std::size_t level = 1; level < levels.size(); ++level) {
    const double factor = levels.spacing(level) / levels.spacing(level - 1);
    EXPECT_GT(factor, 1.55) << "level " << level;
    EXPECT_LT(factor, 2.4) << "level " << level;
  }
}

// Neighbours both ways, and each cluster connected by edges and no wider than 2.5 spacings.
TEST(SurfaceLevels, HaveRoundConnectedClusters) {
  const Surface surface = ball();
  const SurfaceLevels levels(surface);
  for (std::size_t level = 1; level < levels.size(); ++level) {
    for (const std::vector<Index>& cluster : clusters_of(levels, level)) {
      std::set<Index> left(cluster.begin(), cluster.end());
      std::vector<Index> reached{cluster.front()};
      left.erase(cluster.front());
      for (std::size_t i = 0; i < reached.size(); ++i)
        for (const Index neighbour : surface.neighbours[reached[i]])
          if (left.erase(neighbour) > 0) reached.push_back(neighbour);
      ASSERT_TRUE(left.empty()) << "a cluster in pieces, level " << level;
      for (const Index vertex : cluster)
        ASSERT_LT((surface.positions[vertex] - surface.positions[cluster.front()]).norm(),
                  2.5 * levels.spacing(level));
    }
    const Csr& neighbours = levels.neighbours(level);
    for (Index cluster = 0; cluster < neighbours.rows(); ++cluster)
      for (const Index other : neighbours[cluster])
        ASSERT_TRUE(std::ranges::binary_search(neighbours[other], cluster));
  }
}

// Two sheets that nearly touch are two surfaces.
TEST(SurfaceLevels, JoinNoSheetsThatAreOnlyNear) {
  TriangleMesh mesh = test::plane(1, 0.03, 3);
  const auto count = static_cast<Index>(mesh.positions.size());
  for (Index vertex = 0; vertex < count; ++vertex)
    mesh.positions.emplace_back(mesh.positions[vertex] - Vec3f(0, 0, 0.001F));
  const std::size_t triangles = mesh.triangles.size();
  for (std::size_t i = 0; i < triangles; ++i) {
    const auto [a, b, c] = mesh.triangles[i];
    mesh.triangles.push_back({a + count, c + count, b + count});
  }
  const Surface surface = make_surface(mesh);
  const SurfaceLevels levels(surface);
  ASSERT_GE(levels.size(), 3U);
  for (std::size_t level = 1; level < levels.size(); ++level)
    for (const std::vector<Index>& cluster : clusters_of(levels, level))
      for (const Index vertex : cluster)
        ASSERT_EQ(surface.positions[vertex].z(), surface.positions[cluster.front()].z());
}

TEST(SurfaceLevels, AreTheSameOnAnyNumberOfThreads) {
  const Surface surface = make_surface(test::plane(2, 0.02, 3));  // more than one range of vertices
  const SurfaceLevels many(surface);
  const ThreadLimit one_thread(1);
  const SurfaceLevels one(surface);
  ASSERT_EQ(one.size(), many.size());
  for (std::size_t level = 1; level < one.size(); ++level) {
    EXPECT_EQ(one.neighbours(level).items, many.neighbours(level).items);
    for (Index vertex = 0; vertex < surface.vertex_count(); ++vertex)
      ASSERT_EQ(one.cluster(level, vertex), many.cluster(level, vertex));
  }
}

TEST(SurfaceLevels, OfASmallSurfaceAreItsVertices) {
  const Surface surface = make_surface(test::sphere(0, 0, 1));
  const SurfaceLevels levels(surface);
  EXPECT_EQ(levels.size(), 1U);
  EXPECT_EQ(levels.cluster(0, 5), 5U);
}

}  // namespace
}  // namespace burin
