#pragma once
#include <burin/stroke/recording.h>

// The functions may be called on any thread, also on several at once for different recordings.
namespace burin {

/// Makes the positions of a recording, or its camera, relative to `origin`, like the positions of a mesh that
/// is far from the coordinate origin (PolygonMesh::origin).
void move_origin(Recording& recording, const Vec3d& origin);

/// Rotates the positions of a recording, or the world that its camera sees, about the origin. Tilts and twist
/// of the pen have axes of their own and do not change.
void turn(Recording& recording, const Eigen::Matrix3d& rotation);

/// The camera for positions relative to `origin` that shows what the given camera shows.
Camera seen_from(Camera camera, const Vec3d& origin);

}  // namespace burin
