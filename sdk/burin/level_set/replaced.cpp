// Finds the part of a surface around a solid that is cut out, before it is cut along the exact line: whole
// triangles. One pass over all triangles finds those in the solid's box; the rest costs what is there. A
// triangle is near if the distance at its middle says so, or that of a quarter of it, and so on down to a
// voxel.
#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/level_set/replaced.h>
#include <burin/remesh/refine.h>
#include <burin/surface/geometry/triangle_box.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace burin {
namespace {

constexpr std::size_t triangles_a_block = 4096;

Vec3d corner_position(const Surface& surface, const Triangle& triangle, std::size_t i) {
  return surface.positions[triangle[i]].cast<double>();
}

/// Whether a part of the triangle may be near.
bool is_near(const Replacement& in, const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const Vec3d middle = (a + b + c) / 3;
  const double radius = std::sqrt(
      std::max({(a - middle).squaredNorm(), (b - middle).squaredNorm(), (c - middle).squaredNorm()}));
  const double at = in.beyond(middle);
  if (at < in.near) return true;
  if (std::min(at, in.known) - radius >= in.near) return false;
  if (!in.box.intersects(
          Eigen::AlignedBox3d(middle - Vec3d::Constant(radius), middle + Vec3d::Constant(radius))))
    return false;
  if (radius < in.voxel) return at - radius < in.near;
  const Vec3d ab = (a + b) / 2, bc = (b + c) / 2, ca = (c + a) / 2;
  return is_near(in, a, ab, ca) || is_near(in, ab, b, bc) || is_near(in, ca, bc, c) ||
         is_near(in, ab, bc, ca);
}

/// What `triangle(i)` returns for all i below `count`, but no_index. It is called on all threads.
template <class TriangleOf>
std::vector<Index> chosen(std::size_t count, const TriangleOf& triangle) {
  std::vector<std::vector<Index>> of_block(count / triangles_a_block + 1);
  parallel_blocks(count, triangles_a_block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      if (const Index t = triangle(static_cast<Index>(i)); t != no_index)
        of_block[begin / triangles_a_block].push_back(t);
  });
  std::vector<Index> all;
  for (const std::vector<Index>& some : of_block) all.insert(all.end(), some.begin(), some.end());
  return all;
}

std::vector<Index> near_triangles(const Replacement& in) {
  return chosen(in.candidates.size(), [&](Index i) {
    const Index t = in.candidates[i];
    const Triangle& triangle = in.surface.triangles[t];
    const bool near =
        is_near(in, corner_position(in.surface, triangle, 0), corner_position(in.surface, triangle, 1),
                corner_position(in.surface, triangle, 2));
    return near ? t : no_index;
  });
}

/// The triangles with a side from one vertex to the other, in this direction.
std::vector<Index> with_side(const Surface& surface, Index from, Index to) {
  std::vector<Index> triangles;
  for (const Index number : surface.incident[from]) {
    const Triangle& t = surface.triangles[number];
    for (std::size_t i = 0; i < 3; ++i)
      if (t[i] == from && t[(i + 1) % 3] == to) triangles.push_back(number);
  }
  return triangles;
}

void grow(const Replacement& in, std::vector<Index>& triangles) {
  constexpr double too_long = 2;
  std::vector<bool> chosen(in.surface.triangles.size(), false);
  for (const Index t : triangles) chosen[t] = true;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const Triangle triangle = in.surface.triangles[triangles[i]];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      const Vec3d from = corner_position(in.surface, triangle, k),
                  to = corner_position(in.surface, triangle, next);
      if ((to - from).norm() <= too_long * least_size(in.size, from, to)) continue;
      for (const Index other : with_side(in.surface, triangle[next], triangle[k])) {
        if (chosen[other]) continue;
        chosen[other] = true;
        triangles.push_back(other);
      }
    }
  }
  std::ranges::sort(triangles);
}

/// Each side must be that of one other triangle, in the other direction.
void check_sides(const Surface& surface, const Triangle& triangle) {
  for (std::size_t i = 0; i < 3; ++i) {
    const Index from = triangle[i], to = triangle[(i + 1) % 3];
    const std::size_t same = with_side(surface, from, to).size(), other = with_side(surface, to, from).size();
    if (same == 1 && other == 1) continue;
    const Vec3f& at = surface.positions[from];
    throw Error(fmt::format("the surface is {} at ({:.6g}, {:.6g}, {:.6g}), where the solid meets it",
                            same == 1 && other == 0 ? "open" : "no manifold", at.x(), at.y(), at.z()));
  }
}

}  // namespace

std::vector<Index> triangles_within(const Surface& surface, const Eigen::AlignedBox3d& box) {
  return chosen(surface.triangles.size(), [&](Index t) {
    const Eigen::AlignedBox3f own = triangle_box(surface.positions, surface.triangles[t]);
    return own.cast<double>().intersects(box) ? t : no_index;
  });
}

std::vector<Index> replaced_triangles(const Replacement& replacement) {
  std::vector<Index> triangles = near_triangles(replacement);
  grow(replacement, triangles);
  return triangles;
}

PatchMesh piece_of(const Surface& surface, const std::vector<Index>& triangles,
                   const std::function<bool(const Vec3d&)>& keep) {
  std::unordered_map<Index, Index> number;
  PatchMesh piece;
  const auto is_chosen = [&](Index t) { return std::ranges::binary_search(triangles, t); };
  const auto add = [&](Index vertex) {
    piece.positions.push_back(surface.positions[vertex].cast<double>());
    const bool inside = std::ranges::all_of(surface.incident[vertex], is_chosen);
    piece.kept.push_back(!inside || keep(piece.positions.back()) ? vertex : no_index);
  };
  for (const Index t : triangles) {
    check_sides(surface, surface.triangles[t]);
    Triangle own{};
    for (std::size_t i = 0; i < 3; ++i) {
      const Index vertex = surface.triangles[t][i];
      const auto [place, is_new] = number.try_emplace(vertex, piece.vertex_count());
      if (is_new) add(vertex);
      own[i] = place->second;
    }
    piece.triangles.push_back(own);
  }
  return piece;
}

}  // namespace burin
