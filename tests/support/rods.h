#pragma once
#include <burin/chart/chart.h>
#include <burin/surface/triangle_mesh.h>
#include <burin/volume/solid.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

namespace burin::test {

/// The distance to a round rod of this radius, whose middle runs at a height over the stroke, with round
/// ends.
inline DistanceToSolid rod(const Chart& chart, double radius, double height) {
  return [&chart, radius, height](std::span<const ShellPoint> points, std::span<float> distances) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const ShellPoint& point = points[i];
      const double beyond = chart.closed ? 0 : point.t - std::clamp(point.t, 0., chart.length);
      const double across = static_cast<double>(point.d), up = static_cast<double>(point.h) - height;
      distances[i] = static_cast<float>(std::sqrt(beyond * beyond + across * across + up * up) - radius);
    }
  };
}

/// Volume within a closed mesh, and its area.
struct Extent {
  double volume = 0, area = 0;
};

inline Extent extent_of(const TriangleMesh& mesh) {
  Extent extent;
  for (const Triangle& t : mesh.triangles) {
    const Vec3d a = mesh.positions[t[0]].cast<double>(), b = mesh.positions[t[1]].cast<double>(),
                c = mesh.positions[t[2]].cast<double>();
    extent.volume += a.dot(b.cross(c)) / 6;
    extent.area += (b - a).cross(c - a).norm() / 2;
  }
  return extent;
}

/// What holds of the edges of a mesh.
struct Edges {
  std::size_t open = 0;   ///< without a triangle on the other side that runs the other way
  std::size_t multi = 0;  ///< that several triangles run along in the same direction
  long euler = 0;         ///< vertices - edges + triangles
};

inline Edges edges_of(const TriangleMesh& mesh) {
  std::map<std::pair<Index, Index>, int> count;
  for (const Triangle& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) ++count[{t[i], t[(i + 1) % 3]}];
  Edges edges;
  for (const auto& [edge, times] : count) {
    if (times > 1) ++edges.multi;
    if (!count.contains({edge.second, edge.first})) ++edges.open;
  }
  edges.euler = static_cast<long>(mesh.positions.size()) - static_cast<long>(count.size() / 2) +
                static_cast<long>(mesh.triangles.size());
  return edges;
}

/// All angles of the triangles, degrees, ascending.
inline std::vector<double> angles_of(const TriangleMesh& mesh) {
  std::vector<double> angles;
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3d at = mesh.positions[t[i]].cast<double>();
      const Vec3d a = mesh.positions[t[(i + 1) % 3]].cast<double>() - at,
                  b = mesh.positions[t[(i + 2) % 3]].cast<double>() - at;
      angles.push_back(std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / std::numbers::pi);
    }
  }
  std::ranges::sort(angles);
  return angles;
}

}  // namespace burin::test
