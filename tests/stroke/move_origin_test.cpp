#include <burin/stroke/move_origin.h>
#include <gtest/gtest.h>

namespace burin {
namespace {

const Vec3d origin(448256, 5411840, -8);

TEST(MoveOrigin, CountsSamplesOnASurfaceFromThere) {
  Recording recording;
  recording.strokes.resize(1);
  recording.strokes[0].samples.resize(1);
  recording.strokes[0].samples[0].position = Vec3d(448257.5, 5411841, 2);
  move_origin(recording, origin);
  EXPECT_EQ(recording.strokes[0].samples[0].position, Vec3d(1.5, 1, 10));
}

TEST(MoveOrigin, LetsACameraSeeTheSame) {
  Recording recording;
  recording.space = StrokeSpace::screen;
  recording.camera = framing_camera(origin, origin + Vec3d(1, 2, 3), {-1, -1, -2}, {0, 1, 0}, 400, 300, 0.6);
  recording.strokes.resize(1);
  recording.strokes[0].samples.resize(1);
  recording.strokes[0].samples[0].position = Vec3d(20, 30, 0);
  const Vec3d place = origin + Vec3d(0.5, 1, 2.5);
  const Eigen::Vector4d before = recording.camera->view * place.homogeneous();
  move_origin(recording, origin);
  EXPECT_EQ(recording.strokes[0].samples[0].position, Vec3d(20, 30, 0));
  EXPECT_LT((recording.camera->view * (place - origin).homogeneous() - before).norm(), 1e-8);
}

Eigen::Matrix3d quarter_about_x() {
  Eigen::Matrix3d rotation;
  rotation << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  return rotation;
}

TEST(TurnRecording, TurnsSamplesOnASurface) {
  Recording recording;
  recording.strokes.resize(1);
  recording.strokes[0].samples.resize(1);
  recording.strokes[0].samples[0].position = Vec3d(1.5, 2, 3);
  turn(recording, quarter_about_x());
  EXPECT_EQ(recording.strokes[0].samples[0].position, Vec3d(1.5, -3, 2));
}

TEST(TurnRecording, LetsACameraSeeTheSame) {
  Recording recording;
  recording.space = StrokeSpace::screen;
  recording.camera = framing_camera({0, 0, 0}, {1, 2, 3}, {-1, -1, -2}, {0, 1, 0}, 400, 300, 0.6);
  recording.strokes.resize(1);
  recording.strokes[0].samples.resize(1);
  recording.strokes[0].samples[0].position = Vec3d(20, 30, 0);
  const Vec3d place(0.5, 1, 2.5);
  const Eigen::Vector4d before = recording.camera->view * place.homogeneous();
  turn(recording, quarter_about_x());
  EXPECT_EQ(recording.strokes[0].samples[0].position, Vec3d(20, 30, 0));
  EXPECT_EQ(recording.camera->view * Vec3d(0.5, -2.5, 1).homogeneous(), before);
}

}  // namespace
}  // namespace burin
