// Triangulates a mesh that is to be laid along a stroke and turns it into the stroke's axes.
#include <burin/along/source_part.h>
#include <burin/base/error.h>
#include <burin/surface/triangulate.h>

namespace burin {

SourcePart::SourcePart(const PolygonMesh& mesh, const AlongSettings& axes) {
  TriangleMesh source = triangulate(mesh);
  triangles = std::move(source.triangles);
  triangle_uv = std::move(source.triangle_uv);
  // The axes of the stroke are right-handed: t, d to its left, h up.
  const Vec3d across = axes.up.cross(axes.forward);
  points.reserve(source.positions.size());
  for (const Vec3f& position : source.positions) {
    const Vec3d p = position.cast<double>();
    points.emplace_back(p.dot(axes.forward), p.dot(across), p.dot(axes.up));
  }
  for (const Triangle& triangle : triangles)
    for (const Index vertex : triangle) box.extend(points[vertex]);
  if (triangles.empty()) throw Error("there is no triangle to bend");
  if (!(length() > 0)) throw Error("the mesh has no length along the stroke");
}

}  // namespace burin
