#include "constraints.h"

#include <algorithm>
#include <set>

namespace burin::paper {
namespace {

Vec2d chart_place(const Chart& chart, Index vertex) {
  const auto node =
      static_cast<std::size_t>(std::ranges::lower_bound(chart.vertex, vertex) - chart.vertex.begin());
  return {chart.t[node], static_cast<double>(chart.d[node])};
}

}  // namespace

std::vector<Constraint> vertices_near_stroke(const test::Region& region, const Chart& chart,
                                             const SurfaceCurve& curve) {
  std::set<Index> near;
  for (const CurvePoint& point : curve.points) {
    const Index triangle = test::local_index(region.triangles, point.at.triangle);
    if (triangle != no_index) near.insert(region.corners[triangle].begin(), region.corners[triangle].end());
  }
  std::vector<Constraint> constraints;
  for (const Index v : near)
    constraints.push_back({{v, v, v}, {1, 0, 0}, chart_place(chart, region.vertices[v])});
  return constraints;
}

std::vector<Constraint> points_on_stroke(const test::Region& region, const SurfaceCurve& curve) {
  std::set<Index> held;
  std::vector<Constraint> constraints;
  for (const CurvePoint& point : curve.points) {
    const Index triangle = test::local_index(region.triangles, point.at.triangle);
    if (triangle == no_index || !held.insert(triangle).second) continue;
    const double u = point.at.weights[1], v = point.at.weights[2];
    constraints.push_back({region.corners[triangle], {1 - u - v, u, v}, {point.t, 0}});
  }
  return constraints;
}

void Springs::add_to(std::vector<Eigen::Triplet<double>>& matrix, Index first) const {
  for (const Constraint& constraint : constraints_) {
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        const double weight = constraint.weights[i] * constraint.weights[j];
        if (weight == 0) continue;
        matrix.emplace_back(first + constraint.vertices[i], first + constraint.vertices[j],
                            stiffness_ * weight);
      }
    }
  }
}

void Springs::add_to(Parameterization& right_side) const {
  for (const Constraint& constraint : constraints_) {
    for (std::size_t i = 0; i < 3; ++i) {
      right_side.row(constraint.vertices[i]) += stiffness_ * constraint.weights[i] * constraint.target;
    }
  }
}

double largest_miss(const Parameterization& parameterization, std::span<const Constraint> constraints) {
  double largest = 0;
  for (const Constraint& constraint : constraints) {
    Vec2d place = Vec2d::Zero();
    for (std::size_t i = 0; i < 3; ++i)
      place += constraint.weights[i] * parameterization.row(constraint.vertices[i]).transpose();
    largest = std::max(largest, (place - constraint.target).norm());
  }
  return largest;
}

}  // namespace burin::paper
