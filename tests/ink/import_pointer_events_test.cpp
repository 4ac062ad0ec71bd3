#include <burin/base/error.h>
#include <burin/base/file.h>

#include <cmath>
#include <numbers>

#include "ink/imports.h"

namespace burin {
namespace {

TEST(ImportPointerEvents, TakesEveryEventInContactOfARealRecording) {
  BURIN_SHARED_DATA_OR_SKIP(path, "strokes/bdalab_html5_pointer_signal.json");
  const Recording recording = test::imported(path, "pointer", test::import_camera(1280, 720)).recording;
  EXPECT_EQ(recording.space, StrokeSpace::screen);
  ASSERT_EQ(recording.strokes.size(), 1u);
  const RecordedStroke& stroke = recording.strokes[0];
  EXPECT_EQ(stroke.fields,
            (PenFields{.time = true, .pressure = true, .tilt = true, .twist = true, .barrel = true}));
  ASSERT_EQ(stroke.samples.size(), 148u);
  EXPECT_NEAR(stroke.samples.back().time - stroke.samples.front().time, 2.48, 0.01);
  EXPECT_EQ(stroke.samples.front().time, 0);
  EXPECT_EQ(stroke.samples.back().pen.pressure, 0.0013427939265966415f);
  for (const Sample& sample : stroke.samples) {
    const double degrees = sample.pen.tilt_x * 180 / std::numbers::pi;
    EXPECT_NEAR(degrees, std::round(degrees), 1e-5);
    EXPECT_GE(degrees, 20);
    EXPECT_LE(degrees, 60);
  }
  test::expect_fits(recording);
}

TEST(ImportPointerEvents, SurvivesAFile) {
  BURIN_SHARED_DATA_OR_SKIP(path, "strokes/bdalab_html5_pointer_signal.json");
  test::expect_survives_a_file(test::imported(path, "pointer", test::import_camera(640, 480)).recording);
}

class PointerText : public test::ImportedText {
 protected:
  PointerText() : ImportedText("pointer") {}
};

const std::string eight_events = R"({"x": [0,1,2,3,4,5,6,7], "y": [0,0,0,0,0,0,0,0],
      "time": [0,1,2,3,4,5,6,7], )";

TEST_F(PointerText, LiftsThePenByItsButtonsWhateverThePressure) {
  const auto [recording, counts] =
      whole_import(eight_events + R"("buttons": [1,1,0,1,1,1,1,1], "pressure": [1,1,1,1,1,0,1,1]})");
  ASSERT_EQ(recording.strokes.size(), 2u);
  EXPECT_EQ(recording.strokes[0].samples.size(), 2u);
  ASSERT_EQ(recording.strokes[1].samples.size(), 5u);
  EXPECT_EQ(recording.strokes[1].samples[0].time, 0.003);
  EXPECT_EQ(recording.strokes[1].samples[2].pen.pressure, 0);
  EXPECT_EQ(recording.strokes[0].fields, (PenFields{.time = true, .pressure = true, .barrel = true}));
  EXPECT_EQ(counts.lifted, 1u);
}

TEST_F(PointerText, LiftsThePenByItsPressureWithoutButtons) {
  const Recording recording = import(eight_events + R"("pressure": [1,1,0,1,1,0,1,1]})");
  ASSERT_EQ(recording.strokes.size(), 3u);
  for (const RecordedStroke& stroke : recording.strokes) EXPECT_EQ(stroke.samples.size(), 2u);
}

TEST_F(PointerText, TakesAPressureThatIsAlways0ForNone) {
  const auto [recording, counts] =
      whole_import(eight_events + R"("buttons": [1,1,1,0,1,1,1,1], "pressure": [0,0,0,1,0,0,0,0]})");
  ASSERT_EQ(recording.strokes.size(), 2u);
  EXPECT_EQ(counts.pressures_dropped, 2u);
  for (const RecordedStroke& stroke : recording.strokes) {
    EXPECT_FALSE(stroke.fields.pressure);
    for (const Sample& sample : stroke.samples) EXPECT_EQ(sample.pen.pressure, 1);
  }
}

TEST_F(PointerText, GivesEachPointerItsStrokes) {
  const auto [recording, counts] =
      whole_import(eight_events + R"("buttons": [1,1,1,1,0,1,1,0], "pointerId": [4,9,4,9,4,9,4,9]})");
  ASSERT_EQ(recording.strokes.size(), 3u);
  const auto times = [&](std::size_t stroke) {
    std::vector<double> milliseconds;
    for (const Sample& sample : recording.strokes[stroke].samples) milliseconds.push_back(1000 * sample.time);
    return milliseconds;
  };
  EXPECT_EQ(times(0), (std::vector<double>{0, 2}));
  EXPECT_EQ(times(1), (std::vector<double>{1, 3, 5}));
  EXPECT_EQ(times(2), (std::vector<double>{6})) << "the first pointer comes down again";
  EXPECT_EQ(counts.lifted, 2u);
}

TEST_F(PointerText, TakesAMouseWithoutPressure) {
  const Recording recording = import(R"({"x": [0,1], "y": [0,2], "time": [5,5]})");
  EXPECT_EQ(recording.strokes.at(0).fields, PenFields{.time = true});
  EXPECT_EQ(recording.strokes[0].samples.at(1).pen.pressure, 1);
}

TEST_F(PointerText, TurnsDegreesIntoRadians) {
  const Recording recording = import(
      R"({"x": [0,1], "y": [0,2], "time": [5,5], "tiltX": [90,45], "tiltY": [-30,0], "twist": [359,0]})");
  const Pen& pen = recording.strokes.at(0).samples.at(0).pen;
  EXPECT_FLOAT_EQ(pen.tilt_x, std::numbers::pi_v<float> / 2);
  EXPECT_FLOAT_EQ(pen.tilt_y, -std::numbers::pi_v<float> / 6);
  EXPECT_FLOAT_EQ(pen.twist, 359 * std::numbers::pi_v<float> / 180);
}

TEST_F(PointerText, RejectsBadInput) {
  EXPECT_EQ(complaint("{\"x\": [0,1],\n \"y\": [0,1],\n \"time\": [0,]}"), "3: malformed JSON at column 13");
  EXPECT_EQ(complaint("{\"x\": [0,1"), "1: malformed JSON at column 11");
  EXPECT_EQ(complaint("[1, 2]"), " expected an object of arrays x, y, time");
  EXPECT_EQ(complaint(R"({"x": [0,1], "time": [0,1]})"), " lacks 'y'");
  EXPECT_EQ(complaint(R"({"y": [0,1], "time": [0,1]})"), " lacks 'x'");
  EXPECT_EQ(complaint(R"({"x": [0,1], "y": [0], "time": [0,1]})"), " y: has 1 values, x has 2");
  EXPECT_EQ(complaint(R"({"x": [0,1], "y": [0,null], "time": [0,1]})"), " y[1]: must be a number, not null");
  EXPECT_EQ(complaint(R"({"x": [0,1], "y": [0,1], "time": [0,1], "twist": 3})"),
            " twist: must be an array of numbers, not 3");
  EXPECT_EQ(complaint(R"({"x": [0,1], "y": [0,1e999], "time": [0,1]})"), " a number is too large");
  EXPECT_EQ(complaint(R"({"x": [0,1], "y": [0,1e99], "time": [0,1]})"),
            " event 1: the position is not finite, or too large");
  EXPECT_EQ(complaint(R"({"x": [0,1], "y": [0,1], "time": [0,1], "pressure": [0,2]})"),
            " event 1: pressure must lie in 0..1");
  EXPECT_EQ(complaint(R"({"x": [], "y": [], "time": []})"), " holds no stroke");
  EXPECT_EQ(complaint(""), "1: malformed JSON at column 1");
}

}  // namespace
}  // namespace burin
