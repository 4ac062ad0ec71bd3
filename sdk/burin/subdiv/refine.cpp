#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/subdiv/check_cage.h>
#include <burin/subdiv/refine.h>
#include <burin/surface/triangulate.h>
#include <fmt/format.h>
#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/topologyDescriptor.h>

#include <algorithm>
#include <memory>

namespace burin {
namespace {

namespace Far = OpenSubdiv::Far;
namespace Sdc = OpenSubdiv::Sdc;

constexpr std::size_t most_triangles = std::size_t{1} << 30;  ///< OpenSubdiv counts corners in ints
constexpr int highest_level = 15;                             ///< OpenSubdiv counts levels in 4 bits

/// A position as OpenSubdiv's refiner wants to combine it.
struct RefinedPosition {
  Vec3f position;
  void Clear() { position.setZero(); }
  void AddWithWeight(const RefinedPosition& from, float weight) { position += weight * from.position; }
};
static_assert(sizeof(RefinedPosition) == sizeof(Vec3f));

/// The cage in the arrays that OpenSubdiv's descriptor points to.
struct DescriptorArrays {
  explicit DescriptorArrays(const PolygonMesh& cage)
      : face_sizes(cage.face_sizes.begin(), cage.face_sizes.end()),
        face_vertices(cage.face_vertices.begin(), cage.face_vertices.end()) {
    for (const CreaseEdge& crease : cage.creases) {
      crease_vertices.push_back(static_cast<int>(crease.a));
      crease_vertices.push_back(static_cast<int>(crease.b));
      crease_weights.push_back(crease.sharpness);
    }
    for (const CornerVertex& corner : cage.corners) {
      corner_vertices.push_back(static_cast<int>(corner.vertex));
      corner_weights.push_back(corner.sharpness);
    }
  }

  Far::TopologyDescriptor descriptor(std::size_t vertices) const {
    Far::TopologyDescriptor result;
    result.numVertices = static_cast<int>(vertices);
    result.numFaces = static_cast<int>(face_sizes.size());
    result.numVertsPerFace = face_sizes.data();
    result.vertIndicesPerFace = face_vertices.data();
    result.numCreases = static_cast<int>(crease_weights.size());
    result.creaseVertexIndexPairs = crease_vertices.data();
    result.creaseWeights = crease_weights.data();
    result.numCorners = static_cast<int>(corner_weights.size());
    result.cornerVertexIndices = corner_vertices.data();
    result.cornerWeights = corner_weights.data();
    return result;
  }

  std::vector<int> face_sizes, face_vertices, crease_vertices, corner_vertices;
  std::vector<float> crease_weights, corner_weights;
};

std::unique_ptr<Far::TopologyRefiner> refined_topology(const PolygonMesh& cage, SubdivisionScheme scheme,
                                                       int level) {
  Sdc::Options rules;
  rules.SetVtxBoundaryInterpolation(cage.boundary == BoundaryRule::edges_and_corners
                                        ? Sdc::Options::VTX_BOUNDARY_EDGE_AND_CORNER
                                        : Sdc::Options::VTX_BOUNDARY_EDGE_ONLY);
  const auto type = scheme == SubdivisionScheme::loop ? Sdc::SCHEME_LOOP : Sdc::SCHEME_CATMARK;
  using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
  std::unique_ptr<Far::TopologyRefiner> refiner(Factory::Create(
      DescriptorArrays(cage).descriptor(cage.positions.size()), Factory::Options(type, rules)));
  if (!refiner) throw Error("OpenSubdiv cannot refine this cage");
  refiner->RefineUniform(Far::TopologyRefiner::UniformOptions(level));
  return refiner;
}

/// Positions of the last level. Holds those of two levels at a time.
std::vector<Vec3f> refined_positions(const PolygonMesh& cage, const Far::TopologyRefiner& refiner) {
  const Far::PrimvarRefiner interpolation(refiner);
  std::vector<Vec3f> coarse = cage.positions, fine;
  for (int level = 1; level <= refiner.GetMaxLevel(); ++level) {
    fine.resize(static_cast<std::size_t>(refiner.GetLevel(level).GetNumVertices()));
    auto* to = reinterpret_cast<RefinedPosition*>(fine.data());
    interpolation.Interpolate(level, reinterpret_cast<const RefinedPosition*>(coarse.data()), to);
    coarse = std::move(fine);
  }
  return coarse;
}

Triangle triangle(const Far::ConstIndexArray& face, int a, int b, int c) {
  return {static_cast<Index>(face[a]), static_cast<Index>(face[b]), static_cast<Index>(face[c])};
}

/// Quads along the diagonal from corner 0 to corner 2 in OpenSubdiv's order. All diagonals inside a quad of
/// the cage then run the same way, so that vertices there have valence 6, as they should for the front.
std::vector<Triangle> refined_triangles(const Far::TopologyRefiner& refiner) {
  constexpr std::size_t faces_a_block = 16384;
  const Far::TopologyLevel& last = refiner.GetLevel(refiner.GetMaxLevel());
  const auto faces = static_cast<std::size_t>(last.GetNumFaces());
  // A refined level holds quads only, or triangles only.
  const std::size_t triangles_a_face = static_cast<std::size_t>(last.GetNumFaceVertices()) / faces - 2;
  std::vector<Triangle> triangles(faces * triangles_a_face);
  parallel_blocks(faces, faces_a_block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Far::ConstIndexArray face = last.GetFaceVertices(static_cast<int>(i));
      for (std::size_t fan = 0; fan < triangles_a_face; ++fan)
        triangles[i * triangles_a_face + fan] =
            triangle(face, 0, static_cast<int>(fan) + 1, static_cast<int>(fan) + 2);
    }
  });
  return triangles;
}

}  // namespace

SubdivisionScheme natural_scheme(const PolygonMesh& cage) {
  const bool triangles = std::ranges::all_of(cage.face_sizes, [](Index size) { return size == 3; });
  return triangles ? SubdivisionScheme::loop : SubdivisionScheme::catmull_clark;
}

std::size_t refined_triangle_count(const PolygonMesh& cage, SubdivisionScheme scheme, int level) {
  const std::size_t corners = cage.face_vertices.size(), faces = cage.face_sizes.size();
  if (level == 0) return corners - 2 * faces;
  if (scheme == SubdivisionScheme::loop) return faces << 2 * level;
  return corners << (2 * level - 1);
}

int level_for_triangles(const PolygonMesh& cage, SubdivisionScheme scheme, std::size_t triangles) {
  for (int level = 0; level <= highest_level; ++level) {
    const std::size_t count = refined_triangle_count(cage, scheme, level);
    if (count > most_triangles) break;
    if (count >= triangles) return level;
  }
  throw Error(fmt::format("no level of at most {} triangles has {}", most_triangles, triangles));
}

TriangleMesh refine(const PolygonMesh& cage, SubdivisionScheme scheme, int level, const Progress& progress) {
  if (level == 0) return triangulate(cage);
  if (scheme == SubdivisionScheme::loop && natural_scheme(cage) != SubdivisionScheme::loop)
    throw Error("Loop subdivision needs a cage of triangles only");
  if (level < 0 || level > highest_level || refined_triangle_count(cage, scheme, level) > most_triangles)
    throw Error(fmt::format("level {} of this cage is out of range", level));
  check_cage(cage);
  report(progress, "refining the cage", 0);
  const auto refiner = refined_topology(cage, scheme, level);
  report(progress, "refining the cage", 0.5);
  TriangleMesh result;
  parallel_blocks(2, 1, [&](std::size_t half, std::size_t) {
    if (half == 0) result.positions = refined_positions(cage, *refiner);
    if (half == 1) result.triangles = refined_triangles(*refiner);
  });
  report(progress, "refining the cage", 1);
  return result;
}

}  // namespace burin
