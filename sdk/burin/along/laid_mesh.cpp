// Lays one copy of a mesh along a straight stroke: stretches it to its interval's length and scales it
// across.
#include <burin/along/laid_mesh.h>

namespace burin {

void lay(const SourcePart& part, const CopyInterval& interval, const LaidFrame& frame, bool with_uv,
         LaidMesh& into) {
  const auto first = static_cast<Index>(into.points.size());
  for (const Vec3d& point : part.points) {
    const double share = part.share(point);
    const double t = share == 1 ? interval.end : interval.begin + share * (interval.end - interval.begin);
    into.points.emplace_back(t, frame.scale * (point.y() - frame.across),
                             frame.scale * (point.z() - frame.up));
  }
  for (const Triangle& t : part.triangles)
    into.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  if (!with_uv) return;
  into.triangle_uv.insert(into.triangle_uv.end(), part.triangle_uv.begin(), part.triangle_uv.end());
  into.triangle_uv.resize(into.triangles.size(), {Vec2f::Zero(), Vec2f::Zero(), Vec2f::Zero()});
}

}  // namespace burin
