// Meshes that strokes of a session bend along themselves.
#include <burin/surface/polygon_mesh.h>

#include <algorithm>
#include <memory>
#include <numbers>

#include "host/sessions.h"
#include "support/rods.h"

namespace burin {
namespace {

using namespace test;

MeshSource box(float length, float height, float width) {
  PolygonMesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.positions.emplace_back(i & 1 ? length : 0, i & 2 ? height : 0, i & 4 ? width : 0);
  mesh.face_sizes.assign(6, 4);
  mesh.face_vertices = {0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
  return {std::make_shared<const PolygonMesh>(std::move(mesh)), ""};
}

StrokeSettings boxes(double radius = 0.1) {
  StrokeSettings settings;
  settings.radius = radius;
  settings.along.middle = box(4, 1, 2);
  return settings;
}

std::vector<Sample> straight(double length, float pressure_at_end = 1) {
  std::vector<Sample> samples;
  for (int i = 0; i <= 40; ++i) {
    const double s = i / 40.;
    Sample sample;
    sample.time = 0.01 * i;
    sample.position = Vec3d(length * (s - 0.5), 0.02, 0);
    sample.pen.pressure = 1 + static_cast<float>(s) * (pressure_at_end - 1);
    samples.push_back(sample);
  }
  return samples;
}

void draw_bent(Session& session, const StrokeSettings& settings, const std::vector<Sample>& samples,
               Closure closure = Closure::open) {
  session.begin_stroke(settings);
  for (const Sample& sample : samples) session.add_sample(sample.position, sample.time, sample.pen);
  session.end_stroke(closure);
}

TEST(Along, LiesBesideTheSurfaceAndIsUndone) {
  Session session = plane_session();
  const std::uint64_t before = session.result_hash();
  const std::vector<Vec3f> positions(session.positions().begin(), session.positions().end());
  draw_bent(session, boxes(), straight(1.2));
  ASSERT_EQ(session.bent_meshes().size(), 1u);
  EXPECT_TRUE(std::ranges::equal(session.positions(), positions));
  const TriangleMesh& mesh = session.bent_meshes()[0];
  EXPECT_EQ(mesh.triangles.size(), 36u);
  EXPECT_NEAR(extent_of(mesh).volume, 1.2 * 0.02, 1e-5);
  const std::uint64_t one = session.result_hash();
  EXPECT_NE(one, before);
  draw_bent(session, settings("org.burin.groove"), straight(1));
  EXPECT_EQ(session.bent_meshes().size(), 1u);
  draw_bent(session, boxes(0.05), straight(1));
  EXPECT_EQ(session.bent_meshes().size(), 2u);
  EXPECT_TRUE(session.undo());
  EXPECT_TRUE(session.undo());
  EXPECT_EQ(session.result_hash(), one);
  EXPECT_TRUE(session.undo());
  EXPECT_TRUE(session.bent_meshes().empty());
  EXPECT_EQ(session.result_hash(), before);
  EXPECT_TRUE(session.redo());
  EXPECT_EQ(session.result_hash(), one);
  EXPECT_EQ(session.redo_count(), 2u);
  EXPECT_TRUE(session.redo());
  EXPECT_EQ(session.bent_meshes().size(), 1u);
  EXPECT_TRUE(session.redo());
  EXPECT_EQ(session.bent_meshes().size(), 2u);
}

TEST(Along, IsDroppedWithItsStroke) {
  Session session = plane_session();
  session.begin_stroke(boxes());
  for (const Sample& sample : straight(1)) session.add_sample(sample.position, sample.time, sample.pen);
  session.cancel_stroke();
  EXPECT_TRUE(session.bent_meshes().empty());
  EXPECT_FALSE(session.undo());
}

TEST(Along, IsAsWideAsThePenPresses) {
  Session session = plane_session();
  StrokeSettings pressed = boxes();
  pressed.fields.pressure = true;
  pressed.pressure_width = 1;
  draw_bent(session, pressed, straight(1.2, 0.5F));
  ASSERT_EQ(session.bent_meshes().size(), 1u);
  float at_start = 0, at_end = 0;
  for (const Vec3f& p : session.bent_meshes()[0].positions) {
    if (p.x() < -0.59F) at_start = std::max(at_start, p.z());
    if (p.x() > 0.59F) at_end = std::max(at_end, p.z());
  }
  EXPECT_NEAR(at_start, 0.1F, 1e-4F);
  EXPECT_NEAR(at_end, 0.05F, 1e-3F);
}

TEST(Along, IsDrawnWithSymmetryAndInPieces) {
  Session session = plane_session();
  StrokeSettings mirrored = boxes();
  mirrored.symmetry.mirror_x = true;
  session.begin_stroke(mirrored);
  const auto piece = [&](double y, double from_time) {
    for (Sample sample : straight(0.4)) {
      sample.position += Vec3d(0.5, y, 0);
      session.add_sample(sample.position, from_time + sample.time, sample.pen);
    }
  };
  piece(0, 0);
  session.end_piece();
  piece(0.4, 1);
  session.end_stroke();
  ASSERT_EQ(session.bent_meshes().size(), 1u);
  const TriangleMesh& mesh = session.bent_meshes()[0];
  EXPECT_EQ(mesh.triangles.size(), 48u);
  EXPECT_NEAR(extent_of(mesh).volume, 4 * 0.4 * 0.02, 1e-4);
  EXPECT_TRUE(session.undo());
  EXPECT_TRUE(session.bent_meshes().empty());
}

TEST(Along, GoesAroundClosedStrokes) {
  Session session = plane_session();
  std::vector<Sample> samples;
  for (int i = 0; i < 100; ++i) {
    const double angle = 2 * std::numbers::pi * i / 100;
    Sample sample;
    sample.time = 0.01 * i;
    sample.position = Vec3d(0.5 * std::cos(angle), 0.5 * std::sin(angle), 0);
    samples.push_back(sample);
  }
  draw_bent(session, boxes(), samples, Closure::closed);
  ASSERT_EQ(session.bent_meshes().size(), 1u);
  const double volume = std::numbers::pi * 0.02;
  EXPECT_NEAR(extent_of(session.bent_meshes()[0]).volume, volume, 0.003 * volume);
  EXPECT_EQ(edges_of(session.bent_meshes()[0]).euler, 2 * 8);
}

TEST(Along, RefusesWhatItCannotBend) {
  Session session = plane_session();
  StrokeSettings missing = boxes();
  missing.along.middle = {{}, "nowhere.obj"};
  EXPECT_THROW(session.begin_stroke(missing), FileError);
  StrokeSettings flat = boxes();
  flat.along.middle = box(0, 1, 2);
  EXPECT_THROW(session.begin_stroke(flat), Error);
  StrokeSettings dabs = boxes();
  dabs.dab_spacing = 1;
  EXPECT_THROW(session.begin_stroke(dabs), Error);
  StrokeSettings skew = boxes();
  skew.along.up = Vec3d(1, 1, 0).normalized();
  EXPECT_THROW(session.begin_stroke(skew), ContractError);
  StrokeSettings backwards = boxes();
  backwards.along.spacing = -1;
  EXPECT_THROW(session.begin_stroke(backwards), ContractError);
  session.begin_stroke(boxes());
  session.end_stroke();
  EXPECT_FALSE(session.undo());
}

}  // namespace
}  // namespace burin
