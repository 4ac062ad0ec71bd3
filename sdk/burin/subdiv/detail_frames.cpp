// Computes frames at the vertices of a refined level from the edges and faces around them.
#include <burin/base/counting_sort.h>
#include <burin/subdiv/detail_frames.h>
#include <burin/subdiv/refined_topology.h>
#include <burin/surface/geometry/normals.h>

#include <Eigen/Geometry>

namespace burin {
namespace {

/// An edge whose component across the normal is a smaller share of its length has no reliable direction.
constexpr double least_share = 1e-3;

/// Sets `tangent` to the unit direction of `edge` projected onto the plane of the unit `normal`. Returns
/// false if the projection is too short.
bool across(const Vec3d& normal, const Vec3d& edge, Vec3d& tangent) {
  tangent = edge - edge.dot(normal) * normal;
  if (!(tangent.squaredNorm() > least_share * least_share * edge.squaredNorm())) return false;
  tangent.normalize();
  // A second projection removes the rounding errors of the first, which are relative to the whole edge.
  tangent = (tangent - tangent.dot(normal) * normal).normalized();
  return true;
}

}  // namespace

DetailFrames::DetailFrames(const TopologyLevel& level)
    : level_(level), face_size_(static_cast<Index>(face_size(level))) {
  const auto corners = static_cast<std::size_t>(level.GetNumFaceVertices());
  corners_.items.resize(corners);
  corners_.offsets = counting_sort(
      corners, static_cast<std::size_t>(level.GetNumVertices()),
      [&](std::size_t corner, const auto& emit) { emit(vertex_of(static_cast<Index>(corner), 0)); },
      [&](std::size_t corner, std::size_t at) { corners_.items[at] = static_cast<Index>(corner); });
}

Index DetailFrames::vertex_of(Index corner, Index steps) const {
  const auto face = level_.GetFaceVertices(static_cast<int>(corner / face_size_));
  return static_cast<Index>(face[static_cast<int>((corner + steps) % face_size_)]);
}

Eigen::Matrix3d DetailFrames::at(std::span<const Vec3f> positions, Index vertex) const {
  const Vec3d here = positions[vertex].cast<double>();
  const auto edge = [&](Index corner, Index steps) -> Vec3d {
    return positions[vertex_of(corner, steps)].cast<double>() - here;
  };
  NormalSum sum;
  for (const Index corner : corners_[vertex]) sum.add(edge(corner, 1), edge(corner, face_size_ - 1));
  const Vec3d normal = sum.unit();
  Vec3d tangent;
  const auto usable = [&](Index corner) { return across(normal, edge(corner, 1), tangent); };
  if (std::ranges::none_of(corners_[vertex], usable)) tangent = normal.unitOrthogonal();
  Eigen::Matrix3d frame;
  frame << tangent, normal.cross(tangent), normal;
  return frame;
}

}  // namespace burin
