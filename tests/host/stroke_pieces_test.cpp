#include "sessions.h"

#include <burin/host/replay.h>
#include <burin/host/stroke_pieces.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

/// Along the plane's middle, with a gap where the pen is far above it.
std::vector<Sample> lifted_in_the_middle() {
  std::vector<Sample> samples;
  for (int i = 0; i <= 40; ++i) {
    const double x = 0.04 * i - 0.8;
    samples.push_back({0.01 * i, Vec3d(x, 0, std::abs(x) < 0.3 ? 5 : 0), {}});
  }
  return samples;
}

/// Along the middle of the upper of two plates, and from half way on of the lower.
std::vector<Sample> jump_to_the_lower_plate() {
  std::vector<Sample> samples;
  for (int i = 0; i <= 30; ++i) samples.push_back({0.01 * i, Vec3d(0.04 * i - 0.6, 0, i < 15 ? 0 : -1), {}});
  return samples;
}

TriangleMesh two_plates() {
  TriangleMesh mesh = test::plane(1, 0.05, 4);
  const auto vertices = static_cast<Index>(mesh.positions.size());
  const std::size_t triangles = mesh.triangles.size();
  for (Index i = 0; i < vertices; ++i) mesh.positions.emplace_back(mesh.positions[i] - Vec3f(0, 0, 1));
  for (std::size_t i = 0; i < triangles; ++i) {
    const auto [a, b, c] = mesh.triangles[i];
    mesh.triangles.push_back({a + vertices, b + vertices, c + vertices});
  }
  return mesh;
}

StrokeSettings groove() {
  StrokeSettings groove = test::settings("org.burin.groove");
  groove.fields = {.time = true};
  return groove;
}

/// Draws as an application would, uploading every change when it is reported. Returns the hash.
std::uint64_t drawn_in_pieces(const Surface& surface, const std::vector<Sample>& samples) {
  Session session(surface, test::brushes());
  std::vector<Vec3f> uploaded = surface.positions;
  const auto upload = [&](std::span<const Index> changed) {
    EXPECT_TRUE(std::ranges::is_sorted(changed));
    for (const Index vertex : changed) uploaded[vertex] = session.positions()[vertex];
  };
  StrokePieces stroke(session, groove());
  for (const Sample& sample : samples) upload(stroke.add(sample.position, sample.time, sample.pen).changed);
  upload(stroke.end());
  EXPECT_EQ(uploaded, session.surface().positions);
  return session.result_hash();
}

ReplayResult replayed(const Surface& surface, const std::vector<Sample>& samples) {
  RecordedStroke stroke;
  stroke.settings[&StrokeSettings::brush] = groove().brush;
  stroke.settings[&StrokeSettings::radius] = groove().radius;
  stroke.fields = groove().fields;
  stroke.samples = samples;
  Recording recording;
  recording.strokes = {stroke};
  Session session(surface, test::brushes());
  return replay(session, recording);
}

TEST(StrokePieces, BreakWhereThePenLeavesTheSurface) {
  const Surface surface = make_surface(test::plane(1, 0.02, 4));
  const ReplayResult result = replayed(surface, lifted_in_the_middle());
  EXPECT_EQ(result.pieces, 2u);
  EXPECT_EQ(drawn_in_pieces(surface, lifted_in_the_middle()), result.hash);

  Session bridged(surface, test::brushes());
  bridged.begin_stroke(groove());
  for (const Sample& sample : lifted_in_the_middle())
    bridged.add_sample(sample.position, sample.time, sample.pen);
  bridged.end_stroke();
  EXPECT_NE(bridged.result_hash(), result.hash);
}

TEST(StrokePieces, BreakWhereThePenJumpsAcrossAGap) {
  const Surface surface = make_surface(two_plates());
  const ReplayResult result = replayed(surface, jump_to_the_lower_plate());
  EXPECT_EQ(result.pieces, 2u);
  EXPECT_EQ(result.samples_drawn, jump_to_the_lower_plate().size());
  EXPECT_EQ(drawn_in_pieces(surface, jump_to_the_lower_plate()), result.hash);
}

}  // namespace
}  // namespace burin
