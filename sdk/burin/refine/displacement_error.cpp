// Linear interpolation over an edge of length l is off by l^2 / 8 times the second derivative along it. The
// diagonals of a quad cross at a place of which each has its own value; these differ by the difference of
// both errors, in units of the displacement, however thin the triangles are.
#include <burin/base/sort_unique.h>
#include <burin/refine/displacement_error.h>
#include <burin/refine/refine_surface.h>
#include <burin/refine/smooth_facets.h>
#include <burin/surface/geometry/triangle_shape.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace burin {
namespace {

class ErrorSearch {
 public:
  ErrorSearch(const Surface& surface, std::span<const Vec3f> displaced, const DisplacementBound& bound,
              double amplitude)
      : surface_(surface), displaced_(displaced), bound_(bound), allowed_(bound.share * amplitude) {}

  void look_at(Index triangle, std::size_t side, DisplacementError& found);

 private:
  /// Two triangles at an edge from a to b, with the apexes c and d.
  struct Quad {
    Index a, b, c, d;
  };
  Vec3d position(Index vertex) const { return surface_.positions[vertex].cast<double>(); }
  Vec3d displacement(Index vertex) const { return displaced_[vertex].cast<double>() - position(vertex); }
  std::optional<double> disagreement(const Quad& quad) const;
  double longest_edge(const Quad& quad) const;

  const Surface& surface_;
  std::span<const Vec3f> displaced_;
  DisplacementBound bound_;
  double allowed_;  ///< object units
  std::vector<Index> beside_;
};

/// Of both diagonals where they come nearest to each other; none where that is not within both.
std::optional<double> ErrorSearch::disagreement(const Quad& quad) const {
  const Vec3d a = position(quad.a), c = position(quad.c), ab = position(quad.b) - a,
              cd = position(quad.d) - c, ac = c - a;
  const double p = ab.squaredNorm(), q = cd.squaredNorm(), m = ab.dot(cd), determinant = p * q - m * m;
  if (!(determinant > 0)) return {};
  const double s = (q * ab.dot(ac) - m * cd.dot(ac)) / determinant,
               t = (m * ab.dot(ac) - p * cd.dot(ac)) / determinant;
  if (!(s > 0 && s < 1 && t > 0 && t < 1)) return {};
  const Vec3d on_edge = (1 - s) * displacement(quad.a) + s * displacement(quad.b),
              across = (1 - t) * displacement(quad.c) + t * displacement(quad.d);
  return (on_edge - across).norm();
}

double ErrorSearch::longest_edge(const Quad& quad) const {
  double squared = 0;
  for (const auto& [from, to] :
       {std::pair{quad.a, quad.b}, std::pair{quad.a, quad.c}, std::pair{quad.a, quad.d},
        std::pair{quad.b, quad.c}, std::pair{quad.b, quad.d}})
    squared = std::max(squared, (position(to) - position(from)).squaredNorm());
  return std::sqrt(squared);
}

void ErrorSearch::look_at(Index triangle, std::size_t side, DisplacementError& found) {
  triangles_beside(surface_, triangle, side, beside_);
  if (beside_.size() != 1 || beside_[0] < triangle) return;
  const Triangle &t = surface_.triangles[triangle], &other = surface_.triangles[beside_[0]];
  const Quad quad{t[side], t[(side + 1) % 3], t[(side + 2) % 3], *std::ranges::find_if(other, [&](Index v) {
                    return v != t[side] && v != t[(side + 1) % 3];
                  })};
  const std::optional<double> apart = disagreement(quad);
  // In one of the directions of the edges around it is at least twice the error, and it may be four times.
  constexpr double over_error = 2;
  if (!apart || !(*apart > over_error * allowed_)) return;
  const double longest = longest_edge(quad);
  if (!(longest > longest_edge_factor * bound_.least_edge)) return;
  // Shorter than it must be, so that a second search finds nothing.
  constexpr double enough = 0.65, most_at_once = 3;
  const double wanted = enough * longest * std::sqrt(over_error * allowed_ / *apart);
  const double edge = std::max({wanted, longest / most_at_once, bound_.least_edge});
  const double half_way = (position(quad.d) - position(quad.c)).norm() / 4;
  found.lengths.push_back({position(quad.a), position(quad.b), half_way, edge});
  found.triangles.push_back(triangle);
}

}  // namespace

DisplacementError displacement_error(const Surface& surface, std::span<const Vec3f> displaced,
                                     std::span<const Index> vertices, const DisplacementBound& bound) {
  float squared = 0;
  std::vector<Index> triangles;
  for (const Index vertex : vertices) {
    squared = std::max(squared, (displaced[vertex] - surface.positions[vertex]).squaredNorm());
    triangles.insert(triangles.end(), surface.incident[vertex].begin(), surface.incident[vertex].end());
  }
  sort_unique(triangles);
  ErrorSearch search(surface, displaced, bound, std::sqrt(static_cast<double>(squared)));
  DisplacementError found;
  for (const Index triangle : triangles)
    for (std::size_t side = 0; side < 3; ++side) search.look_at(triangle, side, found);
  return found;
}

}  // namespace burin
