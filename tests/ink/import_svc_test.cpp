#include <burin/base/error.h>
#include <burin/base/file.h>
#include <burin/stroke/pen_angles.h>

#include <array>
#include <cmath>
#include <fstream>
#include <numbers>

#include "ink/imports.h"
#include "ink/pen_files.h"

namespace burin {
namespace {

constexpr float degree = static_cast<float>(std::numbers::pi / 180);

TEST(ImportSvc, TakesEveryEventInContactOfARealRecording) {
  BURIN_SHARED_DATA_OR_SKIP(path, "strokes/bdalab_signal.svc");
  const Recording recording = test::imported(path, "svc", test::import_camera(1280, 720)).recording;
  EXPECT_EQ(recording.strokes.size(), 5u);
  test::expect_fits(recording);
  std::ifstream in(path);
  std::size_t count = 0, stroke = 0, sample = 0;
  in >> count;
  ASSERT_EQ(count, 1378u);
  bool down = false;
  double start = -1;  // the time of the first event in contact
  std::array<double, 7> event{};
  for (std::size_t i = 0; i < count; ++i) {
    for (double& number : event) in >> number;
    if (down && event[3] == 0) {
      EXPECT_EQ(sample, recording.strokes.at(stroke).samples.size());
      ++stroke;
      sample = 0;
    }
    down = event[3] == 1;
    if (!down) continue;
    if (start < 0) start = event[2];
    const Sample& imported = recording.strokes.at(stroke).samples.at(sample++);
    EXPECT_EQ(imported.time, event[2] - start);
    EXPECT_EQ(imported.pen.pressure, static_cast<float>(event[6]));
    const double tilt = std::atan(std::hypot(std::tan(imported.pen.tilt_x), std::tan(imported.pen.tilt_y)));
    EXPECT_NEAR(tilt, (900 - event[5]) * std::numbers::pi / 1800, 1e-5);
  }
  EXPECT_EQ(recording.strokes[0].fields, (PenFields{.time = true, .pressure = true, .tilt = true}));
}

TEST(ImportSvc, SurvivesAFile) {
  BURIN_SHARED_DATA_OR_SKIP(path, "strokes/bdalab_signal.svc");
  test::expect_survives_a_file(test::imported(path, "svc", test::import_camera(1280, 720)).recording);
}

class SvcText : public test::ImportedText {
 protected:
  SvcText() : ImportedText("svc") {}
};

TEST_F(SvcText, TurnsTheTabletUprightAndAnglesIntoTilts) {
  const Recording recording = import(
      "5\n0 0 0 1 900 600 0.5\n0 10 1 1 0 600 0.5\n0 10 2 1 2700 450 1\n0 10 3 1 1800 450 1\n5 5 4 1 0 900 "
      "0");
  ASSERT_EQ(recording.strokes.size(), 1u);
  const std::vector<Sample>& samples = recording.strokes[0].samples;
  ASSERT_EQ(samples.size(), 5u);
  EXPECT_GT(samples[0].position.y(), samples[1].position.y()) << "pixels run downward";
  EXPECT_NEAR(samples[0].pen.tilt_x, 30 * degree, 1e-6F) << "to the right";
  EXPECT_NEAR(samples[0].pen.tilt_y, 0, 1e-6F);
  EXPECT_NEAR(samples[1].pen.tilt_y, -30 * degree, 1e-6F) << "to the top";
  EXPECT_NEAR(samples[2].pen.tilt_x, -45 * degree, 1e-6F);
  EXPECT_NEAR(samples[3].pen.tilt_y, 45 * degree, 1e-6F);
  EXPECT_NEAR(samples[4].pen.tilt_x, 0, 1e-6F);
}

TEST_F(SvcText, KnowsWhereAFlatPenPointsTo) {
  for (const double azimuth : {0., 30., 90., 200., 270., 359.}) {
    const std::string line = " 1 " + std::to_string(azimuth * 10) + " 0 1\n";
    const Pen pen = import("2\n0 0 0" + line + "1 0 1" + line).strokes.at(0).samples.at(0).pen;
    const Vec3d end = upper_end(pen);
    EXPECT_NEAR(end.x(), std::sin(azimuth * std::numbers::pi / 180), 1e-4) << azimuth;
    EXPECT_NEAR(end.y(), -std::cos(azimuth * std::numbers::pi / 180), 1e-4) << azimuth;
  }
}

TEST_F(SvcText, RejectsBadLines) {
  const std::string good = "0 0 0 1 0 900 0.5\n1 1 1 1 0 900 0.5\n";
  EXPECT_EQ(complaint("2\n" + good), "accepted");
  EXPECT_EQ(complaint("3\n" + good), "1: 3 lines are told, 2 follow");
  for (const char* count : {"1.5", "-1", "2e9"})
    EXPECT_EQ(complaint(count + ("\n" + good)), "1: the number of the lines that follow must be whole");
  EXPECT_EQ(complaint(good), "1: expected one number, found more");
  EXPECT_EQ(complaint("3\n" + good + "1 2 3 1 0 900\n"),
            "4: expected seven numbers: x y time pen_down azimuth altitude pressure");
  EXPECT_EQ(complaint("3\n" + good + "1 2 3 1 0 900 1 0\n"), "4: expected seven numbers, found more");
  EXPECT_EQ(complaint("3\n" + good + "1 2 3 2 0 900 1\n"), "4: pen_down must be 0 or 1");
  EXPECT_EQ(complaint("3\n" + good + "1 2 3 1 0 901 1\n"),
            "4: altitude must lie in 0..900 tenths of a degree");
  EXPECT_EQ(complaint("3\n" + good + "1 2 3 1 0 900 7\n"), "4: pressure must lie in 0..1");
  EXPECT_EQ(complaint("3\n" + good + "1 2 3 1 inf 900 1\n"), "4: tilt or twist is not finite");
  EXPECT_EQ(complaint("0\n"), " holds no stroke");
}

TEST(ReadSvc, KnowsWholeNumbersOfADevice) {
  const test::PenFileFolder folder;
  const PenFile file = folder.read(
      "3\n4034 7509 354642400 1 1190 720 10852\n4150 7582 354642408 1 1190 720 10997\n"
      "4150 7582 354642416 0 1190 720 0\n");
  EXPECT_EQ(file.kind, "svc");
  EXPECT_EQ(file.unit, "");
  ASSERT_EQ(file.strokes.size(), 1u);
  EXPECT_EQ(test::places(file.strokes[0]), "4034 -7509, 4150 -7582");
  EXPECT_EQ(file.strokes[0].fields, (PenFields{.time = true, .tilt = true}));
  EXPECT_NEAR(file.strokes[0].samples.at(1).time - file.strokes[0].samples[0].time, 0.008, 1e-6);
  EXPECT_EQ(file.not_used, std::vector<std::string>{"pressure of an unknown range"});
  EXPECT_TRUE(folder.read("1\n1 2 3 1 0 900 1\n").strokes.at(0).fields.pressure);
}

TEST(ReadSvc, ReadsTheJsonOfTheSameData) {
  const std::string columns =
      R"("x": [1.5, 2, 3], "y": [2, 3, 4], "time": [0, 0.007, 0.015], "pen_status": [1, 1, 0],
      "azimuth": [510, 510, 510], "tilt": [520, 520, 520], "pressure": [)";
  const test::PenFileFolder folder;
  const PenFile file = folder.read(R"({"meta_data": {"lpi": 1025}, "data": {)" + columns + "0.25, 0.5, 0]}}");
  EXPECT_EQ(file.kind, "svc");
  EXPECT_EQ(file.unit, "mm");
  ASSERT_EQ(file.strokes.size(), 1u);
  EXPECT_EQ(test::places(file.strokes[0]), "1.5 -2, 2 -3");
  EXPECT_EQ(file.strokes[0].samples.at(1).time, 0.007);
  EXPECT_EQ(file.strokes[0].samples[0].pen.pressure, 0.25F);
  EXPECT_EQ(folder.complaint(R"({"data": {)" + columns + "0.25, 1.5, 0]}}"),
            " data: event 1: pressure must lie in 0..1");
  EXPECT_EQ(folder.complaint(R"({"data": {)" + columns + "0.25]}}"), " data.pressure: has 1 values, x has 3");
}

}  // namespace
}  // namespace burin
