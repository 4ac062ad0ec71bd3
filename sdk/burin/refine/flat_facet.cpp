// Finds points of a triangle by the gradients of its barycentric coordinates, which are computed once.
#include <burin/base/segment.h>
#include <burin/refine/flat_facet.h>

#include <limits>

namespace burin {

FlatFacet::FlatFacet(const std::array<Vec3d, 3>& of) : corners(of) {
  const Vec3d b = corners[1] - corners[0], c = corners[2] - corners[0], area = b.cross(c);
  const double squared = area.squaredNorm();
  has_area = squared > 0;
  if (!has_area) return;
  along_b = c.cross(area) / squared;
  along_c = area.cross(b) / squared;
}

std::optional<FlatFacet::Place> FlatFacet::foot(const Vec3d& point) const {
  if (!has_area) return {};
  const Vec3d way = point - corners[0];
  const double b = along_b.dot(way), c = along_c.dot(way), a = 1 - b - c;
  if (!(a >= 0 && b >= 0 && c >= 0)) return {};
  return Place{{a, b, c}, a * corners[0] + b * corners[1] + c * corners[2]};
}

FlatFacet::Place FlatFacet::nearest(const Vec3d& point) const {
  if (const std::optional<Place> there = foot(point)) return *there;
  Place best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t next = (i + 1) % 3;
    const double share = share_on_segment(corners[i], corners[next], point);
    const Vec3d there = (1 - share) * corners[i] + share * corners[next];
    const double squared = (there - point).squaredNorm();
    if (!(squared < least)) continue;
    least = squared;
    best = {{0, 0, 0}, there};
    best.weights[i] = 1 - share;
    best.weights[next] = share;
  }
  return best;
}

}  // namespace burin
