// Translates and rotates recordings.
#include <burin/stroke/move_origin.h>

namespace burin {

Camera seen_from(Camera camera, const Vec3d& origin) {
  camera.view.col(3) += camera.view.leftCols<3>() * origin;
  return camera;
}

void move_origin(Recording& recording, const Vec3d& origin) {
  if (recording.camera) recording.camera = seen_from(*recording.camera, origin);
  if (recording.space == StrokeSpace::screen) return;
  for (RecordedStroke& stroke : recording.strokes)
    for (Sample& sample : stroke.samples) sample.position -= origin;
}

void turn(Recording& recording, const Eigen::Matrix3d& rotation) {
  if (rotation.isIdentity(0)) return;  // multiplying by the identity would turn -0 into 0
  if (recording.camera)
    recording.camera->view.leftCols<3>() =
        (recording.camera->view.leftCols<3>() * rotation.transpose()).eval();
  if (recording.space == StrokeSpace::screen) return;
  for (RecordedStroke& stroke : recording.strokes)
    for (Sample& sample : stroke.samples) sample.position = (rotation * sample.position).eval();
}

}  // namespace burin
