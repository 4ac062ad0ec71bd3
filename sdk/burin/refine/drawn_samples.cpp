// Hands points of the surface before collapses on to the faces that come in place of others.
#include <burin/refine/drawn_samples.h>

#include <algorithm>
#include <array>
#include <optional>

namespace burin {
namespace {

/// Whether texture coordinates are those of the corners at these weights, to a hundredth of the longest side.
bool fits(const Vec2f& at, const TriangleUv& uv, const std::array<double, 3>& weights) {
  constexpr float share = 0.01F;
  Vec2f there = Vec2f::Zero();
  float squared = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    there += static_cast<float>(weights[i]) * uv[i];
    squared = std::max(squared, (uv[(i + 1) % 3] - uv[i]).squaredNorm());
  }
  return (there - at).squaredNorm() <= share * share * squared;
}

/// One of some facets, and the weights of its corners at a point.
struct Keeper {
  std::size_t number = 0;
  std::array<double, 3> weights{};
};

/// The facet that keeps a point: the first one above which it is near enough, or else the nearest; nothing if
/// none is near enough.
std::optional<Keeper> keeper_of(const std::vector<FlatFacet>& facets, const Vec3d& point, double apart) {
  for (std::size_t i = 0; i < facets.size(); ++i)
    if (const auto foot = facets[i].foot(point); foot && (foot->at - point).squaredNorm() <= apart * apart)
      return Keeper{i, foot->weights};
  double least = apart * apart;
  std::optional<Keeper> found;
  for (std::size_t i = 0; i < facets.size(); ++i) {
    const FlatFacet::Place place = facets[i].nearest(point);
    const double squared = (place.at - point).squaredNorm();
    if (!(squared <= least)) continue;
    least = squared;
    found = Keeper{i, place.weights};
  }
  return found;
}

}  // namespace

void DrawnSamples::append_kept(Index face, std::vector<Sample>& samples) const {
  if (face < kept_.size()) samples.insert(samples.end(), kept_[face].begin(), kept_[face].end());
  const RegionMesh::Face& f = mesh_->faces()[face];
  if (f.changed) return;
  const auto& [a, b, c] = f.corners;
  samples.push_back({(mesh_->position(a) + mesh_->position(b) + mesh_->position(c)) / 3,
                     (f.uv[0] + f.uv[1] + f.uv[2]) / 3, no_index});
}

void DrawnSamples::append_vertex(Side side, std::vector<Sample>& samples) const {
  const Index vertex = mesh_->from(side);
  samples.push_back(
      {mesh_->position(vertex), mesh_->faces()[side / 3].uv[side % 3], mesh_->vertices()[vertex].source});
}

Triangle DrawnSamples::numbers_of(const Triangle& corners) const {
  return {mesh_->vertices()[corners[0]].source, mesh_->vertices()[corners[1]].source,
          mesh_->vertices()[corners[2]].source};
}

bool DrawnSamples::is_like(const Sample& sample, const RegionMesh::Corners& corners,
                           const std::array<double, 3>& weights, const Bounds& bounds) const {
  if (!surface_->triangle_uv.empty() && !fits(sample.uv, corners.uv, weights)) return false;
  if (sample.vertex == no_index || !bounds.is_like) return true;
  return bounds.is_like(sample.vertex, numbers_of(corners.vertices), weights);
}

bool DrawnSamples::assign(std::span<const Draft> drafts, const Bounds& bounds,
                          std::vector<Sample>& samples) const {
  std::vector<FlatFacet> facets;
  for (const Draft& draft : drafts) {
    const auto& [a, b, c] = draft.corners.vertices;
    facets.emplace_back(std::array{mesh_->position(a), mesh_->position(b), mesh_->position(c)});
  }
  for (Sample& sample : samples) {
    const std::optional<Keeper> keeper = keeper_of(facets, sample.at, bounds.apart);
    if (!keeper) return false;
    const auto& [face, corners] = drafts[keeper->number];
    if (!is_like(sample, corners, keeper->weights, bounds)) return false;
    sample.face = face;
  }
  return true;
}

void DrawnSamples::keep(std::span<const Draft> drafts, std::span<const Sample> samples) {
  for (const Draft& draft : drafts) {
    if (kept_.size() <= draft.face) kept_.resize(mesh_->faces().size());
    kept_[draft.face].clear();
  }
  for (const Sample& sample : samples) kept_[sample.face].push_back(sample);
}

}  // namespace burin
