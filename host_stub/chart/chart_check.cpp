// Checks a chart against independent distances. Distances along the edges of the mesh [Dijkstra 1959] are
// never too short, so a vertex within the stroke by them must have a node. On planes and spheres the exact
// distance to every segment of the curve is known; with n vertices and m segments that part costs O(n m).
#include "chart/chart_check.h"

#include <burin/base/segment.h>
#include <burin/chart/path/closed_length.h>
#include <burin/math/elementary.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <unordered_map>
#include <utility>
#include <vector>

namespace burin::command {
namespace {

/// How far a surface may be from a plane or a sphere, in radii of the stroke.
constexpr double flat_enough = 1e-4;

/// The position of a point of the curve, in doubles.
Vec3d place(const SurfaceCurve& curve, std::size_t point) {
  return curve.points[point].at.position.cast<double>();
}

/// The vertices whose distance along edges to a point of the curve is within the stroke's half width at that
/// point.
std::vector<Index> vertices_under_pen(const Surface& surface, const Picker& picker, const SurfaceCurve& curve,
                                      double radius) {
  // The queue is ordered by the remaining half width, greatest first.
  std::priority_queue<std::pair<double, Index>> queue;
  std::unordered_map<Index, double> left_at;
  const auto reach = [&](Index vertex, double left) {
    // Vertices at the very rim are left out, since rounding decides there.
    if (left < 1e-5 * radius) return;
    const auto [entry, is_new] = left_at.try_emplace(vertex, left);
    if (!is_new && entry->second >= left) return;
    entry->second = left;
    queue.emplace(left, vertex);
  };
  for (const CurvePoint& point : curve.points) {
    const auto at = picker.closest(point.at.position, static_cast<float>(radius));
    if (!at) continue;
    for (const Index corner : at->corners)
      reach(corner, radius * static_cast<double>(point.width) -
                        static_cast<double>((surface.positions[corner] - point.at.position).norm()));
  }
  while (!queue.empty()) {
    const auto [left, vertex] = queue.top();
    queue.pop();
    if (left < left_at[vertex]) continue;
    for (const Index next : surface.neighbours[vertex])
      reach(next, left - static_cast<double>((surface.positions[next] - surface.positions[vertex]).norm()));
  }
  std::vector<Index> vertices;
  for (const auto& [vertex, left] : left_at) vertices.push_back(vertex);
  std::ranges::sort(vertices);
  return vertices;
}

/// A plane, or a sphere fitted by linear least squares of |x|^2 - 2 c . x.
struct Shape {
  bool sphere = false;
  Vec3d centre = Vec3d::Zero();  ///< centre of the sphere
  double radius = 0;             ///< radius of the sphere, object units

  double distance(const Vec3d& x, const Vec3d& a, const Vec3d& b) const {
    return sphere ? on_sphere(x - centre, a - centre, b - centre) : on_plane(x, a, b);
  }

 private:
  static double on_plane(const Vec3d& x, const Vec3d& a, const Vec3d& b) {
    return (x - a - share_on_segment(a, b, x) * (b - a)).norm();
  }
  double on_sphere(const Vec3d& x, const Vec3d& a, const Vec3d& b) const {
    const auto angle = [](const Vec3d& u, const Vec3d& v) {
      return math::atan2(u.cross(v).norm(), u.dot(v));
    };
    const Vec3d pole = a.cross(b);
    const bool beside = pole.cross(a).dot(x) > 0 && b.cross(pole).dot(x) > 0;
    const double height = beside ? std::abs(pole.normalized().dot(x)) : 0;
    const double from_way = math::atan2(height, std::sqrt(std::max(x.squaredNorm() - height * height, 0.)));
    return radius * (beside ? from_way : std::min(angle(x, a), angle(x, b)));
  }
};

std::optional<Shape> shape_of(const Surface& surface, const std::vector<Index>& vertices, double radius) {
  if (vertices.size() < 10) return std::nullopt;
  const Vec3d origin = surface.positions[vertices[0]].cast<double>();
  Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
  Eigen::Vector4d right = Eigen::Vector4d::Zero();
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  Vec3d sum = Vec3d::Zero();
  for (const Index vertex : vertices) sum += surface.positions[vertex].cast<double>() - origin;
  const Vec3d middle = sum / static_cast<double>(vertices.size());
  for (const Index vertex : vertices) {
    const Vec3d x = surface.positions[vertex].cast<double>() - origin - middle;
    const Eigen::Vector4d row(x.x(), x.y(), x.z(), 1);
    normal += row * row.transpose();
    right += x.squaredNorm() * row;
    spread += x * x.transpose();
  }
  const auto fits = [&](const std::function<double(const Vec3d&)>& height) {
    return std::ranges::all_of(vertices, [&](Index vertex) {
      const Vec3d x = surface.positions[vertex].cast<double>() - origin - middle;
      return std::abs(height(x)) <= flat_enough * radius;
    });
  };
  const Vec3d across = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors().col(0);
  if (fits([&](const Vec3d& x) { return across.dot(x); })) return Shape{};
  const Eigen::Vector4d solution = normal.ldlt().solve(right);
  const Vec3d centre = solution.head<3>() / 2;
  const double size = std::sqrt(std::max(solution[3] + centre.squaredNorm(), 0.));
  if (!fits([&](const Vec3d& x) { return (x - centre).norm() - size; })) return std::nullopt;
  return Shape{true, origin + middle + centre, size};
}

double exact_distance(const Shape& shape, const SurfaceCurve& curve, const Vec3d& x) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < curve.segment_count(); ++i) {
    const Vec3d a = place(curve, i), b = place(curve, curve.next(i));
    // Segments farther away along the straight line cannot be nearer along the surface.
    if ((x - a).norm() - (b - a).norm() <= least) least = std::min(least, shape.distance(x, a, b));
  }
  return least;
}

/// The least distance to the curve among the nodes of each vertex of a chart.
std::unordered_map<Index, double> told_distances(const Chart& chart) {
  std::unordered_map<Index, double> told;
  for (std::size_t i = 0; i < chart.size(); ++i) {
    const double beyond = beyond_ends(chart.t[i], chart.length, chart.closed);
    const double distance = math::hypot(beyond, static_cast<double>(chart.d[i]));
    const auto [entry, is_new] = told.try_emplace(chart.vertex[i], distance);
    if (!is_new) entry->second = std::min(entry->second, distance);
  }
  return told;
}

}  // namespace

ChartCheck check_chart(const Surface& surface, const Picker& picker, const SurfaceCurve& curve,
                       const Chart& chart, double radius, Join join) {
  const std::vector<Index> vertices = vertices_under_pen(surface, picker, curve, radius);
  const std::unordered_map<Index, double> told = told_distances(chart);
  ChartCheck check;
  check.under_pen = vertices.size();
  // Smooth and mitered joins define distances of their own at bends.
  const bool to_stroke = join == Join::round || join == Join::overlap;
  const std::optional<Shape> shape = to_stroke ? shape_of(surface, vertices, radius) : std::nullopt;
  if (shape) check.distances.emplace().sphere = shape->sphere;
  for (const Index vertex : vertices) {
    const auto found = told.find(vertex);
    if (found == told.end()) {
      ++check.holes;
      continue;
    }
    if (!shape) continue;
    const double exact = exact_distance(*shape, curve, surface.positions[vertex].cast<double>());
    const double error = std::abs(found->second - exact) / radius;
    check.distances->mean += error / static_cast<double>(vertices.size());
    check.distances->off_2 += error > 0.02 ? 1 : 0;
    check.distances->off_10 += error > 0.1 ? 1 : 0;
    check.distances->worst = std::max(check.distances->worst, error);
  }
  return check;
}

}  // namespace burin::command
