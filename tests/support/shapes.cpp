#include "support/shapes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <random>

namespace burin::test {
namespace {

/// A uniform random number in [-1, 1], the same on every platform (unlike
/// std::uniform_real_distribution).
double uniform_signed(std::mt19937& random) { return static_cast<double>(random()) / 2147483647.5 - 1; }

template <class T>
void shuffle(std::vector<T>& items, std::mt19937& random) {
  for (std::size_t i = items.size(); i > 1; --i) std::swap(items[i - 1], items[random() % i]);
}

TriangleMesh icosahedron() {
  const float g = std::numbers::phi_v<float>;
  TriangleMesh mesh;
  mesh.positions = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                    {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  mesh.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                    {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                    {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  for (Vec3f& p : mesh.positions) p.normalize();
  return mesh;
}

TriangleMesh split_on_sphere(const TriangleMesh& coarse) {
  TriangleMesh fine{coarse.positions, {}};
  std::map<std::pair<Index, Index>, Index> middles;
  const auto middle = [&](Index a, Index b) {
    const auto [entry, is_new] =
        middles.try_emplace(std::minmax(a, b), static_cast<Index>(fine.positions.size()));
    if (is_new) {
      fine.positions.push_back((coarse.positions[a].cast<double>() + coarse.positions[b].cast<double>())
                                   .normalized()
                                   .cast<float>());
    }
    return entry->second;
  };
  for (const auto& [a, b, c] : coarse.triangles) {
    const Index ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    fine.triangles.insert(fine.triangles.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  return fine;
}

}  // namespace

TriangleMesh patch(const PatchGrid& grid, const std::function<Vec3d(double, double)>& map) {
  std::mt19937 random(grid.seed);
  const int columns = grid.cells_u + (grid.wrap_u ? 0 : 1), rows = grid.cells_v + 1;
  const double du = (grid.u_max - grid.u_min) / grid.cells_u, dv = (grid.v_max - grid.v_min) / grid.cells_v;
  TriangleMesh mesh;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const bool free_u = grid.wrap_u || (i > 0 && i < grid.cells_u), free_v = j > 0 && j < grid.cells_v;
      const double move_u = grid.jitter_u * uniform_signed(random),
                   move_v = grid.jitter_v * uniform_signed(random);
      mesh.positions.push_back(
          map(grid.u_min + du * (i + (free_u ? move_u : 0)), grid.v_min + dv * (j + (free_v ? move_v : 0)))
              .cast<float>());
    }
  }
  const auto at = [&](int i, int j) { return static_cast<Index>(j * columns + i % columns); };
  for (int j = 0; j < grid.cells_v; ++j) {
    for (int i = 0; i < grid.cells_u; ++i) {
      const Index a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
      if (random() % 2 == 0) {
        mesh.triangles.insert(mesh.triangles.end(), {{a, b, c}, {a, c, d}});
      } else {
        mesh.triangles.insert(mesh.triangles.end(), {{a, b, d}, {b, c, d}});
      }
    }
  }
  return mesh;
}

TriangleMesh plane(double half_width, double edge, std::uint32_t seed) {
  const int cells = static_cast<int>(std::lround(2 * half_width / edge));
  return patch({-half_width, half_width, -half_width, half_width, cells, cells, false, 0.3, 0.3, seed},
               [](double u, double v) { return Vec3d(u, v, 0); });
}

TriangleMesh cylinder(double radius, double half_length, double edge, double jitter, std::uint32_t seed) {
  const double turn = 2 * std::numbers::pi;
  return patch({0, turn, -half_length, half_length, static_cast<int>(std::lround(turn * radius / edge)),
                static_cast<int>(std::lround(2 * half_length / edge)), true, jitter, 0.3, seed},
               [radius](double u, double v) { return Vec3d(radius * std::cos(u), radius * std::sin(u), v); });
}

TriangleMesh sphere(int levels, double jitter, std::uint32_t seed) {
  TriangleMesh mesh = icosahedron();
  for (int level = 0; level < levels; ++level) mesh = split_on_sphere(mesh);
  std::mt19937 random(seed);
  const double edge = 1.1 / (1 << levels);
  for (Vec3f& p : mesh.positions) {
    const Vec3d move(uniform_signed(random), uniform_signed(random), uniform_signed(random));
    p = (p.cast<double>() + jitter * edge * move).normalized().cast<float>();
  }
  return mesh;
}

TriangleMesh fitted(TriangleMesh mesh) {
  Eigen::AlignedBox3f box;
  for (const Vec3f& p : mesh.positions) box.extend(p);
  for (Vec3f& p : mesh.positions) p = (p - box.center()) * (4 / box.diagonal().norm());
  return mesh;
}

TriangleMesh shuffled(const TriangleMesh& mesh, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::vector<Index> place(mesh.positions.size());
  std::iota(place.begin(), place.end(), 0);
  shuffle(place, random);
  TriangleMesh result;
  result.positions.resize(place.size());
  for (std::size_t v = 0; v < place.size(); ++v) result.positions[place[v]] = mesh.positions[v];
  for (const auto& [a, b, c] : mesh.triangles) result.triangles.push_back({place[a], place[b], place[c]});
  shuffle(result.triangles, random);
  return result;
}

}  // namespace burin::test
