// Draws what strokes made: one picture for every command, so that none leaves out the parts beside the
// surface.
#include "pictures/result_picture.h"

#include <burin/level_set/solid_mesh.h>
#include <burin/surface/append_mesh.h>
#include <burin/surface/picker.h>
#include <burin/surface/surface.h>

#include <utility>

#include "pictures/painted.h"
#include "pictures/render.h"

namespace burin {

std::vector<TriangleMesh> part_meshes(const Session& session) {
  std::vector<TriangleMesh> meshes;
  for (const StrokeSolid& solid : session.parts()) meshes.push_back(mesh_of(solid));
  const std::span<const TriangleMesh> bent = session.bent_meshes();
  meshes.insert(meshes.end(), bent.begin(), bent.end());
  return meshes;
}

Picture draw_mesh(TriangleMesh mesh, const Camera& camera, const Progress& progress) {
  const Surface surface = make_surface(std::move(mesh), progress);
  return render(surface, Picker(surface), camera, clay, progress);
}

Picture draw_result(const Session& session, std::span<const TriangleMesh> parts, const Camera& camera,
                    const Progress& progress) {
  if (parts.empty())
    return render(session.surface(), session.picker(), camera, painted(session.paint()), progress);
  const std::span<const Vec3f> positions = session.positions();
  TriangleMesh mesh{{positions.begin(), positions.end()}, session.surface().triangles, {}};
  for (const TriangleMesh& part : parts) append(part, mesh);
  return draw_mesh(std::move(mesh), camera, progress);
}

}  // namespace burin
