// Solves the banded system of a smoothing spline of third differences.
#include <burin/feature/smooth_offsets.h>

#include <Eigen/SparseCholesky>
#include <algorithm>

namespace burin {

std::vector<double> smooth_offsets(std::span<const WeightedValue> values, std::span<const double> bends,
                                   double stiffness) {
  const auto count = static_cast<Eigen::Index>(values.size());
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd right(count);
  // So that the system is definite when a single value has a weight.
  constexpr double least_weight = 1e-9;
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto& [value, weight] = values[static_cast<std::size_t>(i)];
    const double used = std::max(weight, least_weight);
    entries.emplace_back(i, i, used);
    right[i] = used * value;
  }
  constexpr double third_difference[] = {-1, 3, -3, 1};
  for (Eigen::Index i = 0; i + 3 < count; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const double of_curve = bends[at + 2] - bends[at + 1];
    for (Eigen::Index a = 0; a < 4; ++a) {
      const double factor = stiffness * third_difference[a];
      right[i + a] -= factor * of_curve;
      for (Eigen::Index b = 0; b <= a; ++b) entries.emplace_back(i + a, i + b, factor * third_difference[b]);
    }
  }
  Eigen::SparseMatrix<double> system(count, count);
  system.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower, Eigen::NaturalOrdering<int>> solver(
      system);
  const Eigen::VectorXd solution = solver.solve(right);
  return {solution.begin(), solution.end()};
}

}  // namespace burin
