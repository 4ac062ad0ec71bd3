#include <burin/surface/geometry/curvature.h>
#include <burin/surface/point_set.h>
#include <gtest/gtest.h>

#include <cmath>

#include "support/shapes.h"

namespace burin {
namespace {

TEST(GaussCurvature, OfASphereIsOneOverItsSquaredRadius) {
  TriangleMesh mesh = test::sphere(5, 0.2, 9);
  for (Vec3f& p : mesh.positions) p *= 3;
  const Surface surface = make_surface(mesh);
  double mean = 0;
  for (const float k : surface.gauss_curvature) {
    EXPECT_NEAR(k, 1 / 9., 0.02);
    mean += static_cast<double>(k) / surface.vertex_count();
  }
  EXPECT_NEAR(mean, 1 / 9., 1e-3);
}

TEST(GaussCurvature, OfAPlaneAndACylinderIsZero) {
  for (const float k : make_surface(test::plane(1, 0.05, 3)).gauss_curvature) EXPECT_EQ(k, 0);
  const Surface cylinder = make_surface(test::cylinder(1, 1, 0.05, 0, 3));
  for (Index v = 0; v < cylinder.vertex_count(); ++v) {
    if (std::abs(cylinder.positions[v].z()) > 0.9F) continue;
    EXPECT_NEAR(cylinder.gauss_curvature[v], 0, 1e-4);
  }
}

TEST(GaussCurvature, OfASaddleIsNegative) {
  const Surface surface = make_surface(
      test::patch({.u_min = -1, .u_max = 1, .v_min = -1, .v_max = 1, .cells_u = 80, .cells_v = 80, .seed = 2},
                  [](double x, double y) { return Vec3d(x, y, (x * x - y * y) / 2); }));
  double mean = 0;
  int inner = 0;
  for (Index v = 0; v < surface.vertex_count(); ++v) {
    const auto p = surface.positions[v].cast<double>();
    if (std::max(std::abs(p.x()), std::abs(p.y())) > 0.9) continue;
    const double exact = -1 / std::pow(1 + p.x() * p.x() + p.y() * p.y(), 2);
    EXPECT_NEAR(surface.gauss_curvature[v], exact, 0.3);
    mean += std::abs(surface.gauss_curvature[v] - exact);
    ++inner;
  }
  EXPECT_GT(inner, 4000);
  EXPECT_LE(mean / inner, 0.03);
}

/// The vertices of a mesh without its triangles, with these normals.
template <class NormalAt>
Surface points_of(const TriangleMesh& mesh, const NormalAt& normal_at) {
  PointSet points{mesh.positions, {}};
  for (const Vec3f& position : mesh.positions) points.normals.push_back(normal_at(position));
  return make_point_surface(points);
}

TEST(GaussCurvature, OfPointsOnASphereIsOneOverItsSquaredRadius) {
  TriangleMesh mesh = test::sphere(5, 0.2, 9);
  for (Vec3f& position : mesh.positions) position *= 3;
  const Surface surface = points_of(mesh, [](const Vec3f& at) { return at.normalized(); });
  for (const float k : surface.gauss_curvature) ASSERT_NEAR(k, 1 / 9., 1e-3);
}

TEST(GaussCurvature, OfPointsOnACylinderIsZero) {
  const Surface surface = points_of(test::cylinder(1, 1, 0.05, 0.3, 3),
                                    [](const Vec3f& at) { return Vec3f(at.x(), at.y(), 0).normalized(); });
  for (const float k : surface.gauss_curvature) ASSERT_NEAR(k, 0, 1e-3);
}

}  // namespace
}  // namespace burin
