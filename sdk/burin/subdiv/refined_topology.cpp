// Wraps OpenSubdiv's topology refiner: makes it from a cage, applies its rules to positions and texture
// coordinates, and triangulates its levels.
#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/subdiv/check_cage.h>
#include <burin/subdiv/refined_topology.h>
#include <burin/subdiv/weld_uv.h>
#include <fmt/format.h>
#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/topologyDescriptor.h>

namespace burin {
namespace {

namespace Far = OpenSubdiv::Far;
namespace Sdc = OpenSubdiv::Sdc;

constexpr std::size_t faces_per_block = 16384;

/// A position or texture coordinate with the interface that OpenSubdiv's refiner needs.
template <class Vector>
struct Refined {
  Vector value;
  void Clear() { value.setZero(); }
  void AddWithWeight(const Refined& from, float weight) { value += weight * from.value; }
};
static_assert(sizeof(Refined<Vec3f>) == sizeof(Vec3f) && sizeof(Refined<Vec2f>) == sizeof(Vec2f));

template <class Vector>
const Refined<Vector>* refined(std::span<const Vector> values) {
  return reinterpret_cast<const Refined<Vector>*>(values.data());
}

template <class Vector>
Refined<Vector>* refined(std::span<Vector> values) {
  return reinterpret_cast<Refined<Vector>*>(values.data());
}

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
    holes.assign(cage.holes.begin(), cage.holes.end());
    if (cage.corner_uv.empty()) return;
    const WeldedUv uv = weld_uv(cage);
    uv_indices.assign(uv.corners.begin(), uv.corners.end());
    uv_channel.numValues = static_cast<int>(uv.values.size());
    uv_channel.valueIndices = uv_indices.data();
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
    result.numHoles = static_cast<int>(holes.size());
    result.holeIndices = holes.data();
    result.numFVarChannels = uv_indices.empty() ? 0 : 1;
    result.fvarChannels = &uv_channel;
    return result;
  }

  std::vector<int> face_sizes, face_vertices, crease_vertices, corner_vertices, holes, uv_indices;
  Far::TopologyDescriptor::FVarChannel uv_channel;
  std::vector<float> crease_weights, corner_weights;
};

void check_refinable(const PolygonMesh& cage, SubdivisionScheme scheme, int level) {
  if (scheme == SubdivisionScheme::loop && natural_scheme(cage) != SubdivisionScheme::loop)
    throw Error("Loop subdivision needs a cage of triangles only");
  const std::size_t triangles = refined_triangle_count(cage, scheme, level);
  if (level < 1 || level > highest_level || triangles > most_triangles)
    throw Error(fmt::format("level {} of this cage has {} triangles; at most {} can be", level, triangles,
                            most_triangles));
  check_cage(cage);
}

Triangle triangle(const Far::ConstIndexArray& face, int a, int b, int c) {
  return {static_cast<Index>(face[a]), static_cast<Index>(face[b]), static_cast<Index>(face[c])};
}

/// Removes the triangles of the level's faces that are holes.
void drop_holes(const TopologyLevel& level, std::size_t triangles_per_face,
                std::vector<Triangle>& triangles) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < triangles.size(); ++i)
    if (!level.IsFaceHole(static_cast<int>(i / triangles_per_face))) triangles[kept++] = triangles[i];
  triangles.resize(kept);
}

/// Splits the level's faces, except holes, into fans of triangles around their first corners. corners(face)
/// returns the vertices or texture coordinates of a face.
template <class Corners>
std::vector<Triangle> fans(const TopologyLevel& level, const Corners& corners) {
  const auto faces = static_cast<std::size_t>(level.GetNumFaces());
  const std::size_t triangles_per_face = face_size(level) - 2;
  std::vector<Triangle> triangles(faces * triangles_per_face);
  parallel_blocks(faces, faces_per_block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Far::ConstIndexArray face = corners(static_cast<int>(i));
      for (std::size_t fan = 0; fan < triangles_per_face; ++fan)
        triangles[i * triangles_per_face + fan] =
            triangle(face, 0, static_cast<int>(fan) + 1, static_cast<int>(fan) + 2);
    }
  });
  drop_holes(level, triangles_per_face, triangles);
  return triangles;
}

Sdc::Options::VtxBoundaryInterpolation boundary_of(BoundaryRule rule) {
  if (rule == BoundaryRule::none) return Sdc::Options::VTX_BOUNDARY_NONE;
  if (rule == BoundaryRule::edges_and_corners) return Sdc::Options::VTX_BOUNDARY_EDGE_AND_CORNER;
  return Sdc::Options::VTX_BOUNDARY_EDGE_ONLY;
}

}  // namespace

std::unique_ptr<TopologyRefiner> refined_topology(const PolygonMesh& cage, SubdivisionScheme scheme,
                                                  int level) {
  check_refinable(cage, scheme, level);
  Sdc::Options rules;
  rules.SetVtxBoundaryInterpolation(boundary_of(cage.boundary));
  rules.SetCreasingMethod(cage.crease_method == CreaseMethod::chaikin ? Sdc::Options::CREASE_CHAIKIN
                                                                      : Sdc::Options::CREASE_UNIFORM);
  rules.SetFVarLinearInterpolation(Sdc::Options::FVAR_LINEAR_BOUNDARIES);
  const auto type = scheme == SubdivisionScheme::loop ? Sdc::SCHEME_LOOP : Sdc::SCHEME_CATMARK;
  using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
  std::unique_ptr<Far::TopologyRefiner> refiner(Factory::Create(
      DescriptorArrays(cage).descriptor(cage.positions.size()), Factory::Options(type, rules)));
  if (!refiner) throw Error("OpenSubdiv cannot refine this cage");
  refiner->RefineUniform(Far::TopologyRefiner::UniformOptions(level));
  return refiner;
}

void subdivide(const TopologyRefiner& refiner, int level, std::span<const Vec3f> coarse,
               std::span<Vec3f> fine) {
  Refined<Vec3f>* to = refined(fine);
  Far::PrimvarRefiner(refiner).Interpolate(level, refined(coarse), to);
}

std::vector<Triangle> level_triangles(const TopologyRefiner& refiner, int level) {
  const TopologyLevel& topology = refiner.GetLevel(level);
  return fans(topology, [&](int face) { return topology.GetFaceVertices(face); });
}

std::vector<TriangleUv> level_triangle_uv(const TopologyRefiner& refiner, int level,
                                          const PolygonMesh& cage) {
  std::vector<Vec2f> values = weld_uv(cage).values;
  for (int step = 1; step <= level; ++step) {
    std::vector<Vec2f> finer(static_cast<std::size_t>(refiner.GetLevel(step).GetNumFVarValues()));
    Refined<Vec2f>* to = refined(std::span(finer));
    Far::PrimvarRefiner(refiner).InterpolateFaceVarying(step, refined(std::span<const Vec2f>(values)), to);
    values = std::move(finer);
  }
  const TopologyLevel& topology = refiner.GetLevel(level);
  const std::vector<Triangle> corners =
      fans(topology, [&](int face) { return topology.GetFaceFVarValues(face); });
  std::vector<TriangleUv> uv(corners.size());
  for (std::size_t i = 0; i < corners.size(); ++i)
    uv[i] = {values[corners[i][0]], values[corners[i][1]], values[corners[i][2]]};
  return uv;
}

}  // namespace burin
