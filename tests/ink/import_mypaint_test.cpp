#include <burin/base/error.h>
#include <burin/base/file.h>

#include <fstream>

#include "ink/imports.h"

namespace burin {
namespace {

struct Event {
  double time, x, y, pressure;
};

std::vector<Event> events_of(const std::filesystem::path& path) {
  std::ifstream in(path);
  std::vector<Event> events;
  for (Event event{}; in >> event.time >> event.x >> event.y >> event.pressure;) events.push_back(event);
  return events;
}

TEST(ImportMypaintEvents, TakesEveryEventInContactOfARealRecording) {
  BURIN_SHARED_DATA_OR_SKIP(path, "strokes/painting30sec.dat");
  const Recording recording = test::imported(path, "mypaint", test::import_camera(1280, 720)).recording;
  EXPECT_EQ(recording.space, StrokeSpace::screen);
  EXPECT_EQ(recording.strokes.size(), 30u);
  test::expect_fits(recording);

  const std::vector<Event> events = events_of(path);
  ASSERT_EQ(events.size(), 2937u);
  std::size_t stroke = 0, sample = 0;
  bool down = false;
  double start = -1;  // the time of the first event in contact
  for (const Event& event : events) {
    if (down && event.pressure == 0) {
      EXPECT_EQ(sample, recording.strokes[stroke].samples.size());
      ++stroke;
      sample = 0;
    }
    down = event.pressure > 0;
    if (!down) continue;
    if (start < 0) start = event.time;
    const Sample& imported = recording.strokes.at(stroke).samples.at(sample++);
    EXPECT_EQ(imported.time, event.time - start);
    EXPECT_EQ(imported.pen.pressure, static_cast<float>(event.pressure));
  }
  EXPECT_EQ(recording.strokes[0].fields, (PenFields{.time = true, .pressure = true}));
}

TEST(ImportMypaintEvents, KeepsShapesAndDuplicates) {
  BURIN_SHARED_DATA_OR_SKIP(path, "strokes/painting30sec.dat");
  const Recording recording = test::imported(path, "mypaint", test::import_camera(500, 900)).recording;
  test::expect_fits(recording);
  std::size_t samples = 0;
  double length = 0;
  for (const RecordedStroke& stroke : recording.strokes) {
    samples += stroke.samples.size();
    for (std::size_t i = 1; i < stroke.samples.size(); ++i)
      length += (stroke.samples[i].position - stroke.samples[i - 1].position).norm();
  }
  EXPECT_EQ(samples, 2253u);
  // The recording's box is 176..795 wide and its path 22180 px long.
  EXPECT_NEAR(length, 22180 * 400 / (795 - 176), 30);
}

TEST(ImportMypaintEvents, SurvivesAFile) {
  BURIN_SHARED_DATA_OR_SKIP(path, "strokes/painting30sec.dat");
  test::expect_survives_a_file(test::imported(path, "mypaint", test::import_camera(1280, 720)).recording);
}

class MypaintText : public test::ImportedText {
 protected:
  MypaintText() : ImportedText("mypaint") {}
};

TEST_F(MypaintText, KeepsTapsAndRaisesTimesThatFall) {
  const auto [recording, counts] = whole_import(
      "0 5 0 1\n0 5 5 0\n"                 // one place
      "1 7 0 1\r\n2 7 0 1\r\n2 0 0 0\r\n"  // twice the same place
      "3 0 0 .5\n2.5 10 0 1\n4 10 0 1");
  EXPECT_EQ(counts.events, 8u);
  EXPECT_EQ(counts.lifted, 2u);
  EXPECT_EQ(counts.times_raised, 1u);
  EXPECT_EQ(counts.pressures_dropped, 0u);
  ASSERT_EQ(recording.strokes.size(), 3u);
  EXPECT_EQ(recording.strokes[0].samples.size(), 1u);
  EXPECT_EQ(recording.strokes[0].samples[0].position, Vec3d(50, 50, 0));
  EXPECT_EQ(recording.strokes[1].samples.size(), 2u);
  const std::vector<Sample>& samples = recording.strokes[2].samples;
  ASSERT_EQ(samples.size(), 3u);
  EXPECT_EQ(samples[0].position, Vec3d(10, 50, 0));
  EXPECT_EQ(samples[1].position, Vec3d(90, 50, 0));
  EXPECT_EQ(samples[1].time, 3);
  EXPECT_EQ(samples[2].time, 4);
}

TEST_F(MypaintText, KeepsFiniteWhatIsHardlyApart) {
  const Recording recording = import("0 0 0 1\n1 5e-324 0 1\n");
  for (const Sample& sample : recording.strokes.at(0).samples) EXPECT_TRUE(sample.position.allFinite());
}

TEST_F(MypaintText, PutsALoneTapIntoTheMiddle) {
  const Recording recording = import("0 5 7 1\n");
  EXPECT_EQ(recording.strokes.at(0).samples.at(0).position, Vec3d(50, 50, 0));
}

TEST_F(MypaintText, RejectsBadLines) {
  const std::string good = "0 0 0 1\n1 1 1 1\n";
  EXPECT_EQ(complaint(good), "accepted");
  EXPECT_EQ(complaint(good + "1 2 3\n"), "3: expected four numbers: time x y pressure");
  EXPECT_EQ(complaint(good + "1 2 3 x\n"), "3: expected four numbers: time x y pressure");
  EXPECT_EQ(complaint(good + "1 2 3 1e999\n"), "3: expected four numbers: time x y pressure");
  EXPECT_EQ(complaint(good + "1,2,3,4\n"), "3: expected four numbers: time x y pressure");
  EXPECT_EQ(complaint("\n" + good), "1: expected four numbers: time x y pressure");
  EXPECT_EQ(complaint(good + "1 2 3 1 5\n"), "3: expected four numbers, found more");
  EXPECT_EQ(complaint(good + "nan 2 3 1\n"), "3: time is not finite");
  EXPECT_EQ(complaint(good + "1 inf 3 1\n"), "3: the position is not finite, or too large");
  EXPECT_EQ(complaint(good + "1 2 3 -1\n"), "3: pressure must lie in 0..1");
  EXPECT_EQ(complaint(""), " holds no stroke");
  EXPECT_EQ(complaint("0 0 0 0\n1 1 1 0\n"), " holds no stroke");
}

TEST_F(MypaintText, RefusesACameraWithoutViewport) {
  write_file_whole(path_, [](std::ostream& out) { out << "0 0 0 1\n1 1 1 1\n"; });
  EXPECT_THROW(test::imported(path_, "mypaint", Camera{}), ContractError);
}

}  // namespace
}  // namespace burin
