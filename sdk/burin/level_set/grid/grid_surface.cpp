// Finds surfaces of grids by OpenVDB's dual contouring, and the way to where the distance is 0, taken as
// quadratic between voxels.
#include <burin/base/parallel.h>
#include <burin/level_set/grid/grid_surface.h>
#include <openvdb/tools/Interpolation.h>
#include <openvdb/tools/VolumeToMesh.h>

#include <algorithm>

namespace burin {
namespace {

Vec3f vec(const openvdb::Vec3s& v) { return {v.x(), v.y(), v.z()}; }

/// The least angle's cosine of a triangle, the greater the worse.
float worst_cosine(const Vec3f& a, const Vec3f& b, const Vec3f& c) {
  const auto at = [](const Vec3f& p, const Vec3f& q, const Vec3f& r) {
    return (q - p).normalized().dot((r - p).normalized());
  };
  return std::max({at(a, b, c), at(b, c, a), at(c, a, b)});
}

/// Cut along the diagonal that leaves the greater least angle at these positions.
void add_quad(std::vector<Triangle>& triangles, const std::vector<Vec3f>& positions,
              const std::array<Index, 4>& quad) {
  const auto [a, b, c, d] = quad;
  const auto worst = [&](Index i, Index j, Index k) {
    return worst_cosine(positions[i], positions[j], positions[k]);
  };
  if (std::max(worst(a, b, c), worst(a, c, d)) <= std::max(worst(a, b, d), worst(b, c, d))) {
    triangles.push_back({a, b, c});
    triangles.push_back({a, c, d});
  } else {
    triangles.push_back({a, b, d});
    triangles.push_back({b, c, d});
  }
}

}  // namespace

void GridSurface::bring(std::vector<Vec3f>& positions) const {
  parallel_blocks(positions.size(), 1024, [&](std::size_t begin, std::size_t end) {
    const auto accessor = grid_->getConstAccessor();
    for (std::size_t i = begin; i < end; ++i)
      positions[i] = on_surface(accessor, positions[i].cast<double>()).cast<float>();
  });
}

Vec3d GridSurface::bring(const Vec3d& near) const { return on_surface(grid_->getConstAccessor(), near); }

Vec3d GridSurface::on_surface(const Accessor& accessor, const Vec3d& near) const {
  constexpr int steps = 2;
  constexpr double longest = 0.5;  // voxels
  Vec3d p = near / voxel_;
  for (int step = 0; step < steps; ++step) {
    const Vec3d slope = gradient(accessor, p);
    const double squared = slope.squaredNorm();
    // Where two sides meet there is no way to the surface.
    if (!(squared > 1e-2 * voxel_ * voxel_)) break;
    const double value =
        openvdb::tools::QuadraticSampler::sample(accessor, openvdb::Vec3d(p.x(), p.y(), p.z()));
    const Vec3d way = -value / squared * slope;
    const double length = way.norm();
    p += length > longest ? Vec3d(longest / length * way) : way;
  }
  return voxel_ * p;
}

Vec3d GridSurface::gradient(const Accessor& accessor, const Vec3d& p) {
  constexpr double h = 0.5;
  Vec3d slope;
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3d way = h * Vec3d::Unit(axis), ahead = p + way, behind = p - way;
    const auto at = [&](const Vec3d& q) {
      return static_cast<double>(
          openvdb::tools::BoxSampler::sample(accessor, openvdb::Vec3d(q.x(), q.y(), q.z())));
    };
    slope[axis] = (at(ahead) - at(behind)) / (2 * h);
  }
  return slope;
}

TriangleMesh GridSurface::mesh() const {
  std::vector<openvdb::Vec3s> points;
  std::vector<openvdb::Vec3I> triangles;
  std::vector<openvdb::Vec4I> quads;
  openvdb::tools::volumeToMesh(*grid_, points, triangles, quads);
  TriangleMesh mesh;
  for (const openvdb::Vec3s& point : points) mesh.positions.push_back(vec(point));
  std::vector<Vec3f> brought = mesh.positions;
  bring(brought);
  // OpenVDB counts clockwise.
  for (const auto& t : triangles) mesh.triangles.push_back({t[0], t[2], t[1]});
  for (const auto& q : quads) add_quad(mesh.triangles, brought, {q[0], q[3], q[2], q[1]});
  return mesh;
}

}  // namespace burin
