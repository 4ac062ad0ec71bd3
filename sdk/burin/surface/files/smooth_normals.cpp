// Computes vertex normals that are equal on both sides of seams: all corners at one position are summed.
// Costs O(n log n) for finding equal positions.
#include <burin/surface/files/smooth_normals.h>
#include <burin/surface/geometry/normals.h>
#include <burin/surface/topology/weld.h>

#include <algorithm>

namespace burin {

std::vector<Vec3f> smooth_normals(const TriangleMesh& mesh) {
  const std::vector<Index> first = first_at_position(mesh.positions);
  std::vector<NormalSum> sums(first.size());
  for (const Triangle& triangle : mesh.triangles)
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const Vec3d at = mesh.positions[triangle[corner]].cast<double>();
      const Vec3d next = mesh.positions[triangle[(corner + 1) % 3]].cast<double>() - at;
      const Vec3d previous = mesh.positions[triangle[(corner + 2) % 3]].cast<double>() - at;
      sums[first[triangle[corner]]].add(next, previous);
    }
  std::vector<Vec3f> normals(first.size());
  std::ranges::transform(first, normals.begin(),
                         [&](Index at) -> Vec3f { return sums[at].unit().cast<float>(); });
  return normals;
}

}  // namespace burin
