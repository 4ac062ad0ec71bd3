// M. Desbrun, M. Meyer, P. Alliez, Intrinsic parameterizations of surface meshes, 2002, section 3.3: the
// conformal energy is the Dirichlet energy less the area of the image, which depends on the boundary only.
#include "dncp.h"

#include <burin/base/error.h>

#include <Eigen/SparseCholesky>

#include "stopwatch.h"

namespace burin::paper {
namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Entries = std::vector<Eigen::Triplet<double>>;

/// Adds the energy of the edge from a to b. The unknowns are all u, then all v.
void add_edge(Entries& entries, Index a, Index b, double weight, Index vertices) {
  for (const Index first : {Index{0}, vertices}) {
    entries.emplace_back(first + a, first + a, weight);
    entries.emplace_back(first + b, first + b, weight);
    entries.emplace_back(first + a, first + b, -weight);
    entries.emplace_back(first + b, first + a, -weight);
  }
  // Less the area (u_a v_b - u_b v_a) / 2; between neighbouring triangles it cancels.
  entries.emplace_back(a, vertices + b, -0.5);
  entries.emplace_back(vertices + b, a, -0.5);
  entries.emplace_back(b, vertices + a, 0.5);
  entries.emplace_back(vertices + a, b, 0.5);
}

Matrix energy(std::span<const FlatTriangle> triangles, const test::Region& region, const Springs& springs) {
  const auto vertices = static_cast<Index>(region.vertices.size());
  Entries entries;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      add_edge(entries, region.corners[i][corner], region.corners[i][(corner + 1) % 3],
               triangles[i].edge_weights[corner], vertices);
    }
  }
  springs.add_to(entries, 0);
  springs.add_to(entries, vertices);
  Matrix matrix(2 * vertices, 2 * vertices);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

}  // namespace

Parameterization dncp(std::span<const FlatTriangle> triangles, const test::Region& region,
                      std::span<const Constraint> constraints, SolveTimes& times) {
  Stopwatch watch;
  const Springs springs(constraints, fixed);
  const Eigen::SimplicialLDLT<Matrix> factors(energy(triangles, region, springs));
  if (factors.info() != Eigen::Success) throw Error("DNCP: the constraints do not hold the region");
  times.setup = watch.lap();
  Parameterization places = Parameterization::Zero(static_cast<Eigen::Index>(region.vertices.size()), 2);
  springs.add_to(places);
  const Eigen::VectorXd solution = factors.solve(Eigen::VectorXd(places.reshaped()));
  places = solution.reshaped(places.rows(), 2);
  times.solve = watch.lap();
  return places;
}

}  // namespace burin::paper
