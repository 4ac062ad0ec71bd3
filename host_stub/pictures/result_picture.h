#pragma once
#include <burin/base/progress.h>
#include <burin/host/session.h>
#include <burin/stamp/files/picture.h>
#include <burin/stroke/camera.h>
#include <burin/surface/triangle_mesh.h>

#include <span>
#include <vector>

namespace burin {

/// What strokes made beside the surface: the surfaces of solids, then meshes that were bent along strokes.
std::vector<TriangleMesh> part_meshes(const Session& session);

/// Draws a mesh as plain clay.
Picture draw_mesh(TriangleMesh mesh, const Camera& camera, const Progress& progress = {});

/// Draws the session's surface with its paint. If there are parts beside it, it is drawn with them instead,
/// all as plain clay.
Picture draw_result(const Session& session, std::span<const TriangleMesh> parts, const Camera& camera,
                    const Progress& progress = {});

}  // namespace burin
