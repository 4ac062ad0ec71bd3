// Searches the edges near a chord depth first. A path over triangles crosses edges, and each of them has a
// vertex in common with the next one, so that the search goes from near edges to near edges at their
// vertices.
#include <burin/base/segment.h>
#include <burin/surface/topology/chord_path.h>

#include <algorithm>
#include <array>
#include <unordered_set>
#include <utility>
#include <vector>

namespace burin {
namespace {

struct Segment {
  Vec3d from, to;
};

Segment segment(const Vec3f& from, const Vec3f& to) { return {from.cast<double>(), to.cast<double>()}; }

double closest(const Segment& segment, const Vec3d& position) {
  return share_on_segment(segment.from, segment.to, position);
}

Vec3d at(const Segment& segment, double s) { return segment.from + s * (segment.to - segment.from); }

/// The distance of two segments. The closest point of one of their lines to the other line, taken back into
/// its segment, gives the closest point of the other segment, and that again the one of the first.
/// [C. Ericson, Real-Time Collision Detection, 5.1.9]
double distance(const Segment& a, const Segment& b) {
  const Vec3d u = a.to - a.from, v = b.to - b.from, w = a.from - b.from;
  const double uu = u.squaredNorm(), uv = u.dot(v), vv = v.squaredNorm();
  const double determinant = uu * vv - uv * uv;
  const double s = determinant > 0 ? std::clamp((uv * v.dot(w) - vv * u.dot(w)) / determinant, 0.0, 1.0) : 0;
  const Vec3d on_b = at(b, closest(b, at(a, s)));
  return (at(a, closest(a, on_b)) - on_b).norm();
}

class ChordSearch {
 public:
  ChordSearch(const Surface& surface, const SurfacePoint& from, const SurfacePoint& to, double reach)
      : surface_(surface), chord_(segment(from.position, to.position)), reach_(reach) {}

  bool joins(const SurfacePoint& from, const SurfacePoint& to) {
    const std::vector<Index> ends = near_corners(to);
    for (const Index vertex : near_corners(from)) reach_vertex(vertex);
    while (!waiting_.empty()) {
      const Index vertex = waiting_.back();
      waiting_.pop_back();
      if (std::ranges::count(ends, vertex) > 0) return true;
      for (const Index next : surface_.neighbours[vertex])
        if (is_near(vertex, next)) reach_vertex(next);
    }
    return false;
  }

 private:
  bool is_near(Index a, Index b) const {
    return distance(chord_, segment(surface_.positions[a], surface_.positions[b])) <= reach_;
  }

  /// The vertices of the near edges of the triangle that a point lies in.
  std::vector<Index> near_corners(const SurfacePoint& point) const {
    const auto& [a, b, c] = point.corners;
    std::vector<Index> corners;
    for (const auto& [u, v] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
      if (is_near(u, v)) corners.insert(corners.end(), {u, v});
    return corners;
  }

  void reach_vertex(Index vertex) {
    if (reached_.insert(vertex).second) waiting_.push_back(vertex);
  }

  const Surface& surface_;
  const Segment chord_;
  const double reach_;
  std::unordered_set<Index> reached_;
  std::vector<Index> waiting_;
};

}  // namespace

bool has_path_near_chord(const Surface& surface, const SurfacePoint& from, const SurfacePoint& to,
                         double reach) {
  return ChordSearch(surface, from, to, reach).joins(from, to);
}

}  // namespace burin
