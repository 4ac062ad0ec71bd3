// L. Liu, L. Zhang, Y. Xu, C. Gotsman, S. J. Gortler, A local/global approach to mesh parameterization, 2008.
#include "arap.h"

#include <burin/base/error.h>

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>
#include <cmath>

#include "stopwatch.h"

namespace burin::paper {
namespace {

using Matrix = Eigen::SparseMatrix<double>;

/// Calls use(triangle, a, b, edge in the flat triangle from a to b, weight) for every edge of every triangle.
template <class Use>
void for_each_edge(std::span<const FlatTriangle> triangles, const test::Region& region, const Use& use) {
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (std::size_t from = 0; from < 3; ++from) {
      const std::size_t to = (from + 1) % 3;
      use(i, region.corners[i][from], region.corners[i][to],
          Vec2d(triangles[i].corners[to] - triangles[i].corners[from]), triangles[i].edge_weights[from]);
    }
  }
}

Matrix laplacian(std::span<const FlatTriangle> triangles, const test::Region& region,
                 const Springs& springs) {
  std::vector<Eigen::Triplet<double>> entries;
  for_each_edge(triangles, region, [&](std::size_t, Index a, Index b, const Vec2d&, double weight) {
    entries.emplace_back(a, a, weight);
    entries.emplace_back(b, b, weight);
    entries.emplace_back(a, b, -weight);
    entries.emplace_back(b, a, -weight);
  });
  springs.add_to(entries, 0);
  const auto size = static_cast<Eigen::Index>(region.vertices.size());
  Matrix matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

/// The local step: each triangle's best rotation, an angle.
std::vector<double> rotations(std::span<const FlatTriangle> triangles, const test::Region& region,
                              const Parameterization& places) {
  std::vector<Eigen::Matrix2d> covariance(triangles.size(), Eigen::Matrix2d::Zero());
  for_each_edge(triangles, region, [&](std::size_t i, Index a, Index b, const Vec2d& edge, double weight) {
    covariance[i] += weight * (places.row(b) - places.row(a)).transpose() * edge.transpose();
  });
  std::vector<double> angles;
  for (const Eigen::Matrix2d& c : covariance)
    angles.push_back(std::atan2(c(1, 0) - c(0, 1), c(0, 0) + c(1, 1)));
  return angles;
}

/// The right side of the global step.
Parameterization rotated_edges(std::span<const FlatTriangle> triangles, const test::Region& region,
                               const std::vector<double>& angles) {
  Parameterization forces = Parameterization::Zero(static_cast<Eigen::Index>(region.vertices.size()), 2);
  for_each_edge(triangles, region, [&](std::size_t i, Index a, Index b, const Vec2d& edge, double weight) {
    const Vec2d rotated = weight * (Eigen::Rotation2Dd(angles[i]) * edge);
    forces.row(b) += rotated;
    forces.row(a) -= rotated;
  });
  return forces;
}

}  // namespace

Parameterization arap(std::span<const FlatTriangle> triangles, const test::Region& region,
                      std::span<const Constraint> constraints, Parameterization initial, int iterations,
                      SolveTimes& times) {
  Stopwatch watch;
  const Springs springs(constraints, fixed);
  const Eigen::SimplicialLDLT<Matrix> factors(laplacian(triangles, region, springs));
  if (factors.info() != Eigen::Success) throw Error("ARAP: the constraints do not hold the region");
  times.setup = watch.lap();
  Parameterization places = std::move(initial);
  for (int i = 0; i < iterations; ++i) {
    Parameterization forces = rotated_edges(triangles, region, rotations(triangles, region, places));
    springs.add_to(forces);
    places = factors.solve(forces);
  }
  times.solve = watch.lap();
  return places;
}

double arap_energy(std::span<const FlatTriangle> triangles, const test::Region& region,
                   const Parameterization& places) {
  const std::vector<double> angles = rotations(triangles, region, places);
  double energy = 0, area = 0;
  for_each_edge(triangles, region, [&](std::size_t i, Index a, Index b, const Vec2d& edge, double weight) {
    const Vec2d image = places.row(b) - places.row(a);
    energy += weight * (image - Eigen::Rotation2Dd(angles[i]) * edge).squaredNorm();
    area += weight * edge.squaredNorm() / 2;
  });
  return energy / area;
}

}  // namespace burin::paper
