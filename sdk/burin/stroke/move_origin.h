#pragma once
#include <burin/stroke/recording.h>

namespace burin {

/// Counts the places of a recording, or those that its camera sees, from `origin` on, as the positions of a
/// mesh far away are (PolygonMesh::origin).
void move_origin(Recording& recording, const Vec3d& origin);

/// Turns the places of a recording, or those that its camera sees, about the origin. The tilts and the twist
/// of the pen are told in axes of their own and stay.
void turn(Recording& recording, const Eigen::Matrix3d& rotation);

/// A camera that sees what the given one sees, of a surface whose positions are counted from `origin` on.
Camera seen_from(Camera camera, const Vec3d& origin);

}  // namespace burin
