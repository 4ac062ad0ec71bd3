// The curved surface over triangles. Normals are the means over the triangles around a vertex up to sharp
// edges, weighted as N. Max (Weights for Computing Vertex Normals from Facet Normals, 1999), which is exact
// on spheres; but where triangles of very different size meet they are weighted by area, since large ones are
// facets that fillets meet without a bend.
#include <burin/refine/smooth_facets.h>
#include <burin/surface/geometry/area_vector.h>
#include <burin/surface/geometry/triangle_shape.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace burin {
namespace {

constexpr double sharp_cosine = 0.819152;  // of 35 degrees

Vec3d position(const Surface& surface, Index vertex) { return surface.positions[vertex].cast<double>(); }

bool has_vertex(const Triangle& t, Index vertex) { return std::ranges::find(t, vertex) != t.end(); }

/// Whether the texture goes on from one triangle to the other across the side from a to b.
bool has_seam(const Surface& surface, Index t, Index other, Index a, Index b) {
  if (surface.triangle_uv.empty()) return false;
  const auto uv = [&](Index triangle, Index vertex) {
    return surface.triangle_uv[triangle][corner_of(surface.triangles[triangle], vertex)];
  };
  return uv(t, a) != uv(other, a) || uv(t, b) != uv(other, b);
}

}  // namespace

void triangles_beside(const Surface& surface, Index triangle, std::size_t side, std::vector<Index>& beside) {
  const Triangle& t = surface.triangles[triangle];
  const Index a = t[side], b = t[(side + 1) % 3];
  beside.clear();
  const bool fewer = surface.incident[a].size() <= surface.incident[b].size();
  for (const Index other : surface.incident[fewer ? a : b])
    if (other != triangle && has_vertex(surface.triangles[other], fewer ? b : a)) beside.push_back(other);
}

bool is_sharp(const Surface& surface, Index triangle, std::size_t side) {
  std::vector<Index> beside;
  triangles_beside(surface, triangle, side, beside);
  if (beside.size() != 1) return true;
  const Triangle &t = surface.triangles[triangle], &other = surface.triangles[beside[0]];
  const Index a = t[side], b = t[(side + 1) % 3];
  if (other[(corner_of(other, a) + 2) % 3] != b) return true;
  if (has_seam(surface, triangle, beside[0], a, b)) return true;
  const Vec3d n = area_vector(surface.positions, surface.triangles[triangle]),
              m = area_vector(surface.positions, surface.triangles[beside[0]]);
  return !(n.dot(m) >= sharp_cosine * std::sqrt(n.squaredNorm() * m.squaredNorm()));
}

/// [i] the first of the triangles around a vertex with which its i-th one hangs together across edges that
/// are not sharp.
std::vector<std::size_t> SmoothFacets::fans_around(Index vertex) {
  const std::span<const Index> around = surface_->incident[vertex];
  std::vector<std::size_t> fan(around.size());
  std::iota(fan.begin(), fan.end(), std::size_t{0});
  const auto find = [&](std::size_t i) {
    while (fan[i] != i) i = fan[i];
    return i;
  };
  for (std::size_t i = 0; i < around.size(); ++i) {
    const std::size_t corner = corner_of(surface_->triangles[around[i]], vertex);
    for (const std::size_t side : {corner, (corner + 2) % 3}) {
      if (is_sharp(*surface_, around[i], side)) continue;
      triangles_beside(*surface_, around[i], side, beside_);
      const std::size_t j = std::ranges::lower_bound(around, beside_[0]) - around.begin();
      const std::size_t one = find(i), two = find(j);
      fan[std::max(one, two)] = std::min(one, two);
    }
  }
  for (std::size_t i = 0; i < fan.size(); ++i) fan[i] = find(i);
  return fan;
}

/// The fans of the triangles around a vertex between sharp edges have one normal each.
void SmoothFacets::compute_normals(Index vertex) {
  const std::span<const Index> around = surface_->incident[vertex];
  const std::vector<std::size_t> fan = fans_around(vertex);
  struct Sum {
    Vec3d by_shape = Vec3d::Zero(), by_area = Vec3d::Zero();
    double least = std::numeric_limits<double>::infinity(), most = 0;  ///< areas
  };
  std::vector<Sum> sums(around.size());
  for (std::size_t i = 0; i < around.size(); ++i) {
    const Triangle& t = surface_->triangles[around[i]];
    const std::size_t corner = corner_of(t, vertex);
    const Vec3d at = position(*surface_, vertex),
                area = area_vector(surface_->positions, surface_->triangles[around[i]]);
    const double b = (position(*surface_, t[(corner + 1) % 3]) - at).squaredNorm(),
                 c = (position(*surface_, t[(corner + 2) % 3]) - at).squaredNorm();
    Sum& sum = sums[fan[i]];
    if (b > 0 && c > 0) sum.by_shape += area / (b * c);
    sum.by_area += area;
    sum.least = std::min(sum.least, area.norm());
    sum.most = std::max(sum.most, area.norm());
  }
  constexpr double facets_differ = 8;
  std::vector<Vec3d>& normals = normals_[vertex];
  for (std::size_t i = 0; i < around.size(); ++i) {
    const Sum& sum = sums[fan[i]];
    normals.push_back((sum.most > facets_differ * sum.least ? sum.by_area : sum.by_shape).stableNormalized());
  }
}

Vec3d SmoothFacets::normal(Index triangle, std::size_t corner) {
  const Index vertex = surface_->triangles[triangle][corner];
  if (!normals_.contains(vertex)) compute_normals(vertex);
  const std::span<const Index> around = surface_->incident[vertex];
  return normals_.at(vertex)[std::ranges::lower_bound(around, triangle) - around.begin()];
}

SmoothFacets::Facet& SmoothFacets::facet(Index triangle) {
  const auto [at, is_new] = facet_of_.try_emplace(triangle, static_cast<Index>(facets_.size()));
  if (!is_new) return facets_[at->second];
  const Triangle& t = surface_->triangles[triangle];
  Facet made({position(*surface_, t[0]), position(*surface_, t[1]), position(*surface_, t[2])});
  if (made.has_area) bend(triangle, made);
  for (std::size_t side = 0; side < 3; ++side) {
    triangles_beside(*surface_, triangle, side, beside_);
    for (std::size_t i = 0; i < 2; ++i) made.beside[side][i] = i < beside_.size() ? beside_[i] : no_index;
  }
  facets_.push_back(made);
  return facets_.back();
}

/// Sets the control points. Those along sharp edges lie on them.
void SmoothFacets::bend(Index triangle, Facet& facet) {
  // Normals are rounded, and facets of files are flat to the rounding of floats.
  constexpr double flat = 2e-6;
  std::array<bool, 3> sharp;
  std::array<Vec3d, 3> normals;
  for (std::size_t i = 0; i < 3; ++i) {
    sharp[i] = is_sharp(*surface_, triangle, i);
    normals[i] = normal(triangle, i);
  }
  const auto beside = [&](std::size_t from, std::size_t to, bool straight) -> Vec3d {
    const Vec3d &p = facet.corners[from], &q = facet.corners[to];
    const Vec3d third = (2 * p + q) / 3;
    const double lift = (q - p).dot(normals[from]);
    if (straight || std::abs(lift) <= flat * (q - p).norm()) return third;
    facet.curved = true;
    return third - lift / 3 * normals[from];
  };
  Vec3d sum = Vec3d::Zero();
  for (std::size_t i = 0; i < 3; ++i) {
    facet.edge_points[2 * i] = beside(i, (i + 1) % 3, sharp[i]);
    facet.edge_points[2 * i + 1] = beside(i, (i + 2) % 3, sharp[(i + 2) % 3]);
    sum += facet.edge_points[2 * i] + facet.edge_points[2 * i + 1];
  }
  const Vec3d mean = sum / 6, centre = (facet.corners[0] + facet.corners[1] + facet.corners[2]) / 3;
  facet.middle = mean + (mean - centre) / 2;
}

FacetPlace SmoothFacets::nearest_on(Index triangle, const Vec3d& point) {
  const auto [weights, at] = facet(triangle).nearest(point);
  return {triangle, weights, at};
}

FacetPlace SmoothFacets::nearest(Index triangle, const Vec3d& point) {
  FacetPlace best = nearest_on(triangle, point);
  double least = (best.flat - point).squaredNorm();
  std::vector<Index> around;
  for (;;) {
    const Facet& f = facet(best.triangle);
    // Rounding alone makes no place nearer.
    if (least <= 1e-24 * (f.corners[1] - f.corners[0]).squaredNorm()) return best;
    around.clear();
    if (const auto corner = std::ranges::find(best.weights, 1.); corner != best.weights.end()) {
      const Index vertex = surface_->triangles[best.triangle][corner - best.weights.begin()];
      around.assign(surface_->incident[vertex].begin(), surface_->incident[vertex].end());
    } else {
      for (const auto& across : f.beside)
        for (const Index other : across)
          if (other != no_index) around.push_back(other);
    }
    const double before = least;
    for (const Index other : around) {
      const FacetPlace there = nearest_on(other, point);
      if (const double squared = (there.flat - point).squaredNorm(); squared < least) {
        least = squared;
        best = there;
      }
    }
    if (!(least < before)) return best;
  }
}

Vec3d SmoothFacets::smooth(const FacetPlace& place) {
  const Facet& f = facet(place.triangle);
  if (!f.curved) return place.flat;
  const auto& w = place.weights;
  Vec3d sum = 6 * w[0] * w[1] * w[2] * f.middle;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t next = (i + 1) % 3, last = (i + 2) % 3;
    sum +=
        w[i] * w[i] *
        (w[i] * f.corners[i] + 3 * w[next] * f.edge_points[2 * i] + 3 * w[last] * f.edge_points[2 * i + 1]);
  }
  return sum;
}

}  // namespace burin
