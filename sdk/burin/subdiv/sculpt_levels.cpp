// Multiresolution editing after Zorin, Schroeder and Sweldens (1997). A change of one level moves the coarser
// levels by a weighted mean (analysis), then recomputes the details up to that level and the positions of the
// finer ones (synthesis). O(vertices of the finest level) per change.
#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/subdiv/detail_frames.h>
#include <burin/subdiv/refined_topology.h>
#include <burin/subdiv/sculpt_levels.h>
#include <burin/surface/triangulate.h>
#include <fmt/format.h>

#include <algorithm>

namespace burin {
namespace {

constexpr std::size_t vertices_per_block = 4096;

/// Calls body(vertex) for all vertices, on all threads.
template <class Body>
void for_each_vertex(std::size_t vertices, const Body& body) {
  parallel_blocks(vertices, vertices_per_block, [&](std::size_t begin, std::size_t end) {
    for (Index vertex = static_cast<Index>(begin); vertex < end; ++vertex) body(vertex);
  });
}

/// One level above the cage: the frames of its vertices and their details.
struct FineLevel {
  explicit FineLevel(const TopologyLevel& level)
      : frames(level), details(static_cast<std::size_t>(level.GetNumVertices()), Vec3f::Zero()) {}

  Vec3f detail_between(std::span<const Vec3f> base, const Vec3f& place, Index vertex) const {
    const Vec3d offset = place.cast<double>() - base[vertex].cast<double>();
    if (offset.isZero(0)) return Vec3f::Zero();
    return (frames.at(base, vertex).transpose() * offset).cast<float>();
  }

  /// The position of a vertex: base position plus detail. Without detail it has the bits of the base, -0
  /// included.
  Vec3f place(std::span<const Vec3f> base, Index vertex) const {
    if (details[vertex].isZero(0)) return base[vertex];
    const Vec3d offset = frames.at(base, vertex) * details[vertex].cast<double>();
    return (base[vertex].cast<double>() + offset).cast<float>();
  }

  DetailFrames frames;
  std::vector<Vec3f> details;  ///< [vertex] in its frame, object units
};

/// The moves of the vertices of a level, given those of the next finer level.
std::vector<Vec3f> coarser_moves(const TopologyLevel& level, bool quads, const std::vector<Vec3f>& moves) {
  std::vector<Vec3f> coarse(static_cast<std::size_t>(level.GetNumVertices()));
  for_each_vertex(coarse.size(), [&](Index index) {
    const auto vertex = static_cast<int>(index);
    const auto move = [&](int child) -> const Vec3f& { return moves[static_cast<std::size_t>(child)]; };
    Vec3f sum = 4 * move(level.GetVertexChildVertex(vertex));
    float weights = 4;
    for (const int edge : level.GetVertexEdges(vertex)) {
      sum += 2 * move(level.GetEdgeChildVertex(edge));
      weights += 2;
    }
    // Loop subdivision puts no vertices into faces.
    if (quads)
      for (const int face : level.GetVertexFaces(vertex)) {
        sum += move(level.GetFaceChildVertex(face));
        weights += 1;
      }
    coarse[index] = sum / weights;
  });
  return coarse;
}

}  // namespace

struct SculptLevels::Impl {
  std::vector<Vec3f> subdivided(int level) const {
    const auto below = static_cast<std::size_t>(level) - 1;
    std::vector<Vec3f> fine(vertex_count(*refiner, level));
    subdivide(*refiner, level, positions[below], fine);
    return fine;
  }

  FineLevel& fine(int level) { return levels[static_cast<std::size_t>(level) - 1]; }
  std::vector<Vec3f>& places(int level) { return positions[static_cast<std::size_t>(level)]; }

  /// Computes the positions of a level from the level below and its details.
  void compose(int level) {
    const std::vector<Vec3f> base = subdivided(level);
    for_each_vertex(base.size(),
                    [&](Index vertex) { places(level)[vertex] = fine(level).place(base, vertex); });
  }

  /// Computes a level's details from the level below and its positions; details that are still right keep
  /// their bits. Then sets the positions from the details, so that composing the level again gives the same
  /// bits.
  void decompose(int level) {
    const std::vector<Vec3f> base = subdivided(level);
    for_each_vertex(base.size(), [&](Index vertex) {
      Vec3f& place = places(level)[vertex];
      if (fine(level).place(base, vertex) == place) return;
      fine(level).details[vertex] = fine(level).detail_between(base, place, vertex);
      place = fine(level).place(base, vertex);
    });
  }

  /// Moves the vertices of all levels coarser than one whose vertices moved.
  void move_coarser(int level, std::vector<Vec3f> moves) {
    while (--level >= 0) {
      moves = coarser_moves(refiner->GetLevel(level), quads, moves);
      for_each_vertex(moves.size(), [&](Index vertex) { places(level)[vertex] += moves[vertex]; });
    }
  }

  PolygonMesh cage;  ///< without positions
  bool quads;
  std::unique_ptr<TopologyRefiner> refiner;
  std::vector<FineLevel> levels;              ///< from level 1 on
  std::vector<std::vector<Vec3f>> positions;  ///< [level][vertex]
};

SculptLevels::SculptLevels(PolygonMesh cage, SubdivisionScheme scheme, int finest, const Progress& progress)
    : impl_(std::make_unique<Impl>()) {
  Impl& impl = *impl_;
  impl.cage = std::move(cage);
  impl.cage.corner_uv = {};
  impl.quads = scheme == SubdivisionScheme::catmull_clark;
  report(progress, "refining the cage", 0);
  impl.refiner = refined_topology(impl.cage, scheme, finest);
  impl.positions.resize(static_cast<std::size_t>(finest) + 1);
  impl.positions[0] = std::move(impl.cage.positions);
  for (int level = 1; level <= finest; ++level) {
    report(progress, "refining the cage", 0.5 + 0.5 * level / (finest + 1));
    impl.levels.emplace_back(impl.refiner->GetLevel(level));
    impl.places(level) = impl.subdivided(level);
  }
  report(progress, "refining the cage", 1);
}

SculptLevels::~SculptLevels() = default;
SculptLevels::SculptLevels(SculptLevels&&) noexcept = default;
SculptLevels& SculptLevels::operator=(SculptLevels&&) noexcept = default;

int SculptLevels::finest() const { return impl_->refiner->GetMaxLevel(); }

std::span<const Vec3f> SculptLevels::positions(int level) const {
  if (level < 0 || level > finest())
    throw ContractError(fmt::format("level {} is not among 0 to {}", level, finest()));
  return impl_->places(level);
}

TriangleMesh SculptLevels::mesh(int level) const {
  const std::span<const Vec3f> places = positions(level);
  if (level > 0) return {{places.begin(), places.end()}, level_triangles(*impl_->refiner, level), {}};
  PolygonMesh cage = impl_->cage;
  cage.positions.assign(places.begin(), places.end());
  return triangulate(cage);
}

void SculptLevels::set_positions(int level, std::span<const Vec3f> sculpted) {
  const std::span<const Vec3f> before = positions(level);
  if (sculpted.size() != before.size())
    throw ContractError(
        fmt::format("level {} has {} vertices, not {}", level, before.size(), sculpted.size()));
  if (!std::ranges::all_of(sculpted, [](const Vec3f& p) { return p.allFinite(); }))
    throw Error("a vertex has a coordinate that is not finite");
  std::vector<Vec3f> moves(sculpted.size());
  for (std::size_t i = 0; i < moves.size(); ++i) moves[i] = sculpted[i] - before[i];
  std::ranges::copy(sculpted, impl_->places(level).begin());
  impl_->move_coarser(level, std::move(moves));
  for (int step = 1; step <= finest(); ++step) step <= level ? impl_->decompose(step) : impl_->compose(step);
}

}  // namespace burin
