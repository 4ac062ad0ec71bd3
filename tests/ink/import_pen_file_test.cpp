#include <burin/ink/import_pen_file.h>
#include <burin/surface/picker.h>

#include "ink/imports.h"
#include "ink/kinds/bytes.h"
#include "support/shapes.h"

namespace burin {
namespace {

using test::import_camera;

Import import_text(std::string_view text, const PenImport& options, const Surface& surface = {}) {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "recording";
  write_file_whole(path, [&](std::ostream& out) { out << text; });
  return import_pen_file(path, read_pen_file(path), options, import_camera(100, 100), surface);
}

Surface unit_sphere() { return make_surface(test::sphere(4, 0, 1)); }

TEST(ImportPenFile, GivesTimesOfASpeedOnlyWhereAskedAndMissing) {
  const char* const text = "stroke,x,y,time\n1,0,0,\n1,30,40,\n2,0,0,7\n2,1,0,9\n3,0,0,\n3,0,10,\n";
  const Recording plain = import_text(text, {}).recording;
  EXPECT_FALSE(plain.strokes.at(0).fields.time);
  const Recording timed = import_text(text, {.speed = 20}).recording;
  ASSERT_EQ(timed.strokes.size(), 3u);
  for (const RecordedStroke& stroke : timed.strokes) EXPECT_TRUE(stroke.fields.time);
  const auto length = [](const RecordedStroke& stroke) {
    return (stroke.samples[1].position - stroke.samples[0].position).norm();
  };
  EXPECT_NEAR(length(timed.strokes[0]), 100, 1e-9) << "pixels, the view less a margin";
  EXPECT_EQ(timed.strokes[0].samples[0].time, 0);
  EXPECT_NEAR(timed.strokes[0].samples[1].time, 5, 1e-9);
  EXPECT_EQ(timed.strokes[1].samples[1].time, 2) << "as recorded";
  EXPECT_NEAR(timed.strokes[2].samples[0].time, 5, 1e-9) << "after what was before";
  EXPECT_NEAR(timed.strokes[2].samples[1].time, 6, 1e-9);
}

TEST(ImportPenFile, TakesPressureFromWidthOnlyWhereAskedAndMissing) {
  const char* const text =
      "<xournal><page><layer><stroke width='4 1 2'>1 2 3 4 5 6</stroke><stroke width='2'>1 1 2 2</stroke>"
      "</layer></page></xournal>";
  EXPECT_FALSE(import_text(text, {}).recording.strokes.at(0).fields.pressure);
  const Recording pressed = import_text(text, {.pressure_from_width = true}).recording;
  ASSERT_EQ(pressed.strokes.size(), 2u);
  EXPECT_TRUE(pressed.strokes[0].fields.pressure);
  EXPECT_EQ(pressed.strokes[0].samples.at(0).pen.pressure, 0.5F);
  EXPECT_EQ(pressed.strokes[0].samples.at(1).pen.pressure, 1);
  EXPECT_EQ(pressed.strokes[1].samples.at(0).pen.pressure, 1);
  const Recording real =
      import_text("x,y,pressure\n1,2,0.25\n2,3,0.5\n", {.pressure_from_width = true}).recording;
  EXPECT_EQ(real.strokes.at(0).samples.at(0).pen.pressure, 0.25F);
}

TEST(ImportPenFile, PutsStrokesInSpaceOnTheNearestPlaceOfASphere) {
  const Surface sphere = unit_sphere();
  const Recording recording = import_text("x,y,z\n0.5,0,0\n0,0,-3\n1,1,1\n", {}, sphere).recording;
  EXPECT_EQ(recording.space, StrokeSpace::object);
  const std::vector<Sample>& samples = recording.strokes.at(0).samples;
  ASSERT_EQ(samples.size(), 3u);
  constexpr double faceted = 3e-3, from_within = 0.03;  // the facets lie within the sphere
  EXPECT_LT((samples[0].position - Vec3d(1, 0, 0)).norm(), from_within);
  EXPECT_LT((samples[1].position - Vec3d(0, 0, -1)).norm(), faceted);
  EXPECT_LT((samples[2].position - Vec3d(1, 1, 1).normalized()).norm(), faceted);
}

/// A sketch of one stroke, in units of 0.1 m with z forward.
std::string sketch(const std::vector<Vec3f>& points) {
  test::Bytes bytes;
  bytes.add(0xc576a5cdU).add(5).add(0).add(0U).add(1);
  bytes.add(0).add(1.F).add(0.F).add(0.F).add(1.F).add(0.5F).add(0U).add(0U);
  bytes.add(static_cast<std::uint32_t>(points.size()));
  for (const Vec3f& point : points)
    bytes.add(point.x()).add(point.y()).add(point.z()).add(0.F).add(0.F).add(0.F).add(1.F);
  return bytes.text();
}

TEST(ImportPenFile, FitsASketchIntoTheBoxOfTheSphereWhateverItsUnits) {
  const Surface sphere = unit_sphere();
  // The corners of a box around (50, 20, 0); seen from outside, z points away in the file.
  const Recording recording =
      import_text(sketch({{40, 10, -10}, {60, 30, 10}, {40, 20, 0}, {50, 20, 10}}), {}, sphere).recording;
  const std::vector<Sample>& samples = recording.strokes.at(0).samples;
  ASSERT_EQ(samples.size(), 4u);
  constexpr double faceted = 4e-3;
  EXPECT_LT((samples[0].position - Vec3d(-1, -1, 1).normalized()).norm(), faceted);
  EXPECT_LT((samples[1].position - Vec3d(1, 1, -1).normalized()).norm(), faceted);
  EXPECT_LT((samples[2].position - Vec3d(-1, 0, 0)).norm(), faceted);
  EXPECT_LT((samples[3].position - Vec3d(0, 0, -1)).norm(), faceted);
}

TEST(ImportPenFile, PutsRealSketchesOnASphereWithoutLosingASample) {
  const Surface sphere = unit_sphere();
  const Picker picker(sphere);
  for (const auto& [name, count] :
       {std::pair("tilt_toolkit_sketch1.tilt", 912), {"tilt_perftest_simple.tilt", 32}}) {
    BURIN_SHARED_DATA_OR_SKIP(path, std::string("strokes/") + name);
    const Recording recording =
        import_pen_file(path, read_pen_file(path), {}, import_camera(100, 100), sphere).recording;
    int samples = 0;
    for (const RecordedStroke& stroke : recording.strokes)
      for (const Sample& sample : stroke.samples) {
        ++samples;
        EXPECT_TRUE(picker.closest(sample.position.cast<float>(), 1e-6F)) << sample.position.transpose();
      }
    EXPECT_EQ(samples, count) << name;
    test::expect_survives_a_file(recording);
  }
}

TEST(ImportPenFile, RefusesAMeshThatTheCameraDoesNotSee) {
  EXPECT_THROW(
      import_text("x,y\n1,2\n3,4\n", {.fit = PenFit::mesh}, make_surface(test::plane(1e-6, 1e-6, 1))),
      FileError);
}

}  // namespace
}  // namespace burin
