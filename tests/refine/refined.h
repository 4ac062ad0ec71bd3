#pragma once
#include <burin/refine/refine_surface.h>
#include <burin/surface/picker.h>
#include <burin/surface/surface_patch.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace burin::test {

/// A box from the origin to its size of 12 triangles.
inline TriangleMesh box(const Vec3f& size) {
  TriangleMesh mesh;
  for (unsigned i = 0; i < 8; ++i)
    mesh.positions.emplace_back(i & 1 ? size.x() : 0, i & 2 ? size.y() : 0, i & 4 ? size.z() : 0);
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

/// A strip of the plane z = 0 of triangles that are 200 times as long as wide.
inline TriangleMesh slivers() {
  constexpr Index count = 100;
  constexpr float width = 0.005F;
  TriangleMesh mesh;
  for (Index i = 0; i <= count; ++i)
    for (const float y : {0.F, 1.F}) mesh.positions.emplace_back(static_cast<float>(i) * width, y, 0.F);
  for (Index i = 0; i < 2 * count; i += 2) {
    mesh.triangles.push_back({i, i + 2, i + 1});
    mesh.triangles.push_back({i + 1, i + 2, i + 3});
  }
  return mesh;
}

/// Triangles of random corners: edges with any number of triangles, in any direction, and some without area.
inline TriangleMesh random_soup(std::mt19937& random) {
  std::uniform_real_distribution<float> place(-1, 1);
  TriangleMesh mesh;
  for (int i = 0; i < 12; ++i) mesh.positions.emplace_back(place(random), place(random), place(random));
  mesh.positions[5] = (mesh.positions[3] + mesh.positions[4]) / 2;
  mesh.triangles.push_back({3, 4, 5});
  std::uniform_int_distribution<Index> corner(0, 11);
  for (int i = 0; i < 20; ++i) mesh.triangles.push_back({corner(random), corner(random), corner(random)});
  // Where two have the same corners their halves have an edge in common that counts once.
  std::set<std::set<Index>> known;
  std::erase_if(mesh.triangles, [&](const Triangle& t) { return !known.emplace(t.begin(), t.end()).second; });
  return mesh;
}

/// Six times the volume; of an open surface the cone over it.
inline double volume(const Surface& surface) {
  double sum = 0;
  for (const Triangle& t : surface.triangles)
    sum += surface.positions[t[0]].cast<double>().dot(
        surface.positions[t[1]].cast<double>().cross(surface.positions[t[2]].cast<double>()));
  return sum;
}

/// A surface that is to be refined along a line near it.
struct Refinable {
  Refinable(TriangleMesh mesh, const std::vector<Vec3d>& line, double radius, double edge)
      : surface(make_surface(std::move(mesh))), lengths({line}, radius, edge), line_(line) {}

  SurfacePatch refine(std::size_t most = 1'000'000) const {
    return refine_surface(surface, lengths, seeds(surface), most).patch;
  }
  std::vector<Index> seeds(const Surface& on) const {
    const Picker picker(on);
    std::vector<Index> triangles;
    for (const Vec3d& place : line_) triangles.push_back(picker.closest(place.cast<float>(), 10)->triangle);
    return triangles;
  }

  Surface surface;
  EdgeLength lengths;

 private:
  std::vector<Vec3d> line_;
};

inline std::vector<Vec3d> straight(const Vec3d& from, const Vec3d& to, int steps = 40) {
  std::vector<Vec3d> line;
  for (int i = 0; i <= steps; ++i) line.push_back(from + static_cast<double>(i) / steps * (to - from));
  return line;
}

/// Ascending angles, degrees, and lengths of edges of triangles. `all`: of those outside of the radius too.
struct Shapes {
  std::vector<double> angles, edges;

  Shapes(const Surface& surface, const EdgeLength& lengths, bool all) {
    for (const Triangle& t : surface.triangles) {
      std::array<Vec3d, 3> p;
      for (std::size_t i = 0; i < 3; ++i) p[i] = surface.positions[t[i]].cast<double>();
      const bool within =
          std::ranges::all_of(p, [&](const Vec3d& at) { return lengths.at(at) <= lengths.edge(); });
      if (!within && !all) continue;
      for (std::size_t i = 0; i < 3; ++i) {
        const Vec3d b = p[(i + 1) % 3] - p[i], c = p[(i + 2) % 3] - p[i];
        angles.push_back(std::atan2(b.cross(c).norm(), b.dot(c)) * 180 / std::numbers::pi);
        edges.push_back(b.norm());
      }
    }
    std::ranges::sort(angles);
    std::ranges::sort(edges);
  }
  double first_percent() const { return angles[angles.size() / 100]; }
};

}  // namespace burin::test
