#include <burin/surface/curvature.h>
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

}  // namespace
}  // namespace burin
