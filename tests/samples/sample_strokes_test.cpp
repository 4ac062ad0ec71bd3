#include <burin/stroke/stroke_file.h>
#include <burin/subdiv/refine.h>
#include <burin/surface/mesh_file.h>
#include <burin/surface/picker.h>
#include <burin/surface/surface.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace burin {
namespace {

constexpr int level = 4;       // of the surface that these tests look at
constexpr int full_level = 6;  // the lowest with 3M triangles

const Surface& ewer() {
  static const Surface surface = make_surface(
      refine(read_mesh(BURIN_SAMPLES "/meshes/ewer.obj"), SubdivisionScheme::catmull_clark, level));
  return surface;
}

const Picker& ewer_picker() {
  static const Picker picker(ewer());
  return picker;
}

Recording recording(const std::string& name) {
  return read_strokes(BURIN_SAMPLES "/strokes/" + name + ".stroke");
}

const RecordedStroke& only_stroke(const Recording& recording) {
  EXPECT_EQ(recording.strokes.size(), 1u);
  return recording.strokes.front();
}

std::vector<double> arc_lengths(const std::vector<Sample>& samples) {
  std::vector<double> lengths(samples.size(), 0.);
  for (std::size_t i = 1; i < samples.size(); ++i)
    lengths[i] = lengths[i - 1] + (samples[i].position - samples[i - 1].position).norm();
  return lengths;
}

class SampleStroke : public ::testing::TestWithParam<const char*> {};
class ObjectStroke : public SampleStroke {};

INSTANTIATE_TEST_SUITE_P(All, SampleStroke, ::testing::Values("meander", "scale_band", "wave", "scroll"));
INSTANTIATE_TEST_SUITE_P(All, ObjectStroke, ::testing::Values("meander", "scale_band", "wave"));

TEST_P(SampleStroke, IsReportedLikeATablets) {
  const Recording file = recording(GetParam());
  const RecordedStroke& stroke = only_stroke(file);
  EXPECT_EQ(stroke.fields, (PenFields{.time = true, .pressure = true, .tilt = true}));
  ASSERT_GT(stroke.samples.size(), 500u);
  for (std::size_t i = 0; i < stroke.samples.size(); ++i)
    EXPECT_NEAR(stroke.samples[i].time, static_cast<double>(i) / 240, 1e-5);
}

TEST_P(SampleStroke, PressesAsAHandDoes) {
  const Recording file = recording(GetParam());
  const std::vector<Sample>& samples = only_stroke(file).samples;
  float most = 0;
  for (const Sample& sample : samples) {
    EXPECT_GE(sample.pen.pressure, 0);
    EXPECT_LE(sample.pen.pressure, 1);
    most = std::max(most, sample.pen.pressure);
  }
  EXPECT_LT(samples.front().pen.pressure, most / 4);
  EXPECT_LT(samples.back().pen.pressure, most / 4);
}

TEST_P(SampleStroke, StartsAndEndsSlowly) {
  const Recording file = recording(GetParam());
  const std::vector<double> s = arc_lengths(only_stroke(file).samples);
  const double mean = s.back() / static_cast<double>(s.size() - 1);
  EXPECT_LT(s[5], 5 * mean / 2);
  EXPECT_LT(s.back() - s[s.size() - 6], 5 * mean / 2);
}

TEST_P(ObjectStroke, LiesOnTheEwer) {
  const Recording file = recording(GetParam());
  for (const Sample& sample : only_stroke(file).samples) {
    const auto closest = ewer_picker().closest(sample.position.cast<float>(), .01f);
    ASSERT_TRUE(closest) << "at " << sample.time << " s";
    EXPECT_LT((closest->position.cast<double>() - sample.position).norm(), 2e-5);
  }
}

TEST_P(ObjectStroke, HoldsTenThousandVerticesUnderTheBrush) {
  const Recording file = recording(GetParam());
  const RecordedStroke& stroke = only_stroke(file);
  std::size_t fewest = ewer().positions.size();
  for (std::size_t i = 0; i < stroke.samples.size(); i += 100) {
    const Vec3f centre = stroke.samples[i].position.cast<float>();
    const double radius = stroke.settings.complete().radius;
    const auto inside = [&](const Vec3f& p) { return (p - centre).norm() < radius; };
    const auto count = std::count_if(ewer().positions.begin(), ewer().positions.end(), inside);
    fewest = std::min(fewest, static_cast<std::size_t>(count));
  }
  // Each level has four times the vertices of the one before.
  EXPECT_GE(fewest << 2 * (full_level - level), 10'000u);
}

/// Smallest distance between samples that are farther apart along the stroke than `apart`.
double closest_return(const std::vector<Sample>& samples, double apart) {
  const std::vector<double> s = arc_lengths(samples);
  double closest = s.back();
  for (std::size_t i = 0; i < s.size(); i += 5)
    for (std::size_t j = s.size() - 1; s[j] - s[i] > apart; --j)
      closest = std::min(closest, (samples[j].position - samples[i].position).norm());
  return closest;
}

TEST_P(ObjectStroke, KeepsClearOfItself) {
  const Recording file = recording(GetParam());
  const RecordedStroke& stroke = only_stroke(file);
  const double radius = stroke.settings.complete().radius;
  EXPECT_GT(closest_return(stroke.samples, 4 * radius), 2 * radius);
}

TEST(Scroll, MeetsTheEwerEverywhere) {
  const Recording file = recording("scroll");
  ASSERT_EQ(file.space, StrokeSpace::screen);
  for (const Sample& sample : only_stroke(file).samples)
    EXPECT_TRUE(ewer_picker().pick(pixel_ray(*file.camera, sample.position.x(), sample.position.y())));
}

TEST(Meander, IsLong) {
  const Recording file = recording("meander");
  const std::vector<double> s = arc_lengths(only_stroke(file).samples);
  EXPECT_GT(s.back(), 7);
}

}  // namespace
}  // namespace burin
