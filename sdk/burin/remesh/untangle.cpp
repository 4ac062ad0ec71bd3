// Moves vertices back that turn triangles over or make them cross, and repeats, since a vertex that is moved
// back may turn its other triangles.
#include <burin/remesh/intersection.h>
#include <burin/remesh/untangle.h>

namespace burin {
namespace {

Vec3d area_vector(const std::vector<Vec3d>& positions, const Triangle& t) {
  return (positions[t[1]] - positions[t[0]]).cross(positions[t[2]] - positions[t[0]]);
}

/// Moves vertices of a mesh back.
class Restorer {
 public:
  Restorer(PatchMesh& mesh, const std::vector<Vec3d>& before) : mesh_(&mesh), before_(&before) {}

  /// A vertex that is taken back may turn its other triangles, whose vertices follow.
  void restore_turned() {
    while (restore_turned_now()) {
    }
  }

  /// False where none has moved.
  bool restore(const Triangle& triangle) {
    bool moved = false;
    for (const Index vertex : triangle) {
      moved = moved || mesh_->positions[vertex] != (*before_)[vertex];
      mesh_->positions[vertex] = (*before_)[vertex];
    }
    return moved;
  }

 private:
  bool restore_turned_now() {
    constexpr double steepest = 0.2;  // cosine of the angle by which a triangle may turn
    bool any = false;
    for (const Triangle& t : mesh_->triangles) {
      const Vec3d now = area_vector(mesh_->positions, t), then = area_vector(*before_, t);
      if (!(now.dot(then) > steepest * now.norm() * then.norm())) any = restore(t) || any;
    }
    return any;
  }

  PatchMesh* mesh_;
  const std::vector<Vec3d>* before_;
};

}  // namespace

void untangle(PatchMesh& mesh, const std::vector<Vec3d>& before) {
  Restorer restorer(mesh, before);
  for (bool again = true; again;) {
    restorer.restore_turned();
    again = false;
    for (const Index t : crossing_triangles(mesh)) again = restorer.restore(mesh.triangles[t]) || again;
  }
}

}  // namespace burin
