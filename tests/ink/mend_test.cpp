#include <burin/base/error.h>
#include <burin/ink/mend.h>
#include <burin/ink/pen_strokes.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "ink/pen_files.h"
#include "stroke/recordings.h"

namespace burin {
namespace {

using Lines = std::vector<std::string>;

Sample sample_at(double time, double x, double y) {
  Sample sample;
  sample.time = time;
  sample.position = {x, y, 0};
  return sample;
}

/// Forty samples along a wave, 10 ms apart.
RecordedStroke wave() {
  RecordedStroke stroke;
  stroke.fields = {.time = true, .pressure = true};
  for (int i = 0; i < 40; ++i) stroke.samples.push_back(sample_at(i * 0.01, 2 * i, 8 * std::sin(i * 0.2)));
  return stroke;
}

Recording recording_of_stroke(RecordedStroke stroke) {
  Recording recording;
  recording.space = StrokeSpace::object;
  recording.strokes.push_back(std::move(stroke));
  return recording;
}

/// Whether mending gives the wave; `did` becomes what was said.
bool gives_the_wave(RecordedStroke stroke, Lines& did) {
  Recording recording = recording_of_stroke(std::move(stroke));
  did = mend(recording);
  return test::same_bits(recording, recording_of_stroke(wave()));
}

TEST(Mend, LeavesTheBitsOfACleanRecording) {
  Lines did;
  EXPECT_TRUE(gives_the_wave(wave(), did));
  EXPECT_EQ(did, Lines());
}

TEST(Mend, PutsSamplesInTheOrderOfTheirTimes) {
  RecordedStroke stroke = wave();
  std::swap(stroke.samples[10], stroke.samples[12]);
  Lines did;
  EXPECT_TRUE(gives_the_wave(stroke, did));
  EXPECT_EQ(
      did,
      (Lines{"stroke 1, sample 12: its time 0.11 is before that of the one before; it goes to place 12",
             "stroke 1, sample 13: its time 0.1 is before that of the one before; it goes to place 11"}));
}

TEST(Mend, RaisesTimesOfAClockThatWentBack) {
  Recording recording = recording_of_stroke(wave());
  for (std::size_t i = 20; i < 40; ++i) recording.strokes[0].samples[i].time -= 0.05;
  const Lines did = mend(recording);
  const std::vector<Sample>& samples = recording.strokes[0].samples;
  ASSERT_EQ(samples.size(), 40u);
  for (std::size_t i = 0; i < 40; ++i) EXPECT_EQ(samples[i].position.x(), 2. * static_cast<double>(i));
  for (std::size_t i = 1; i < 40; ++i) EXPECT_GT(samples[i].time, samples[i - 1].time);
  ASSERT_GE(did.size(), 1u);
  EXPECT_EQ(did[0], "stroke 1, sample 21: its time 0.15000000000000002 falls; raised to 0.19");
}

TEST(Mend, RemovesDuplicatesAndKeepsAPenThatRests) {
  RecordedStroke stroke = wave();
  stroke.samples.insert(stroke.samples.begin() + 5, stroke.samples[5]);
  Lines did;
  EXPECT_TRUE(gives_the_wave(stroke, did));
  EXPECT_EQ(did, Lines{"stroke 1, sample 7: a duplicate of the one before; left out"});
  RecordedStroke resting = wave();
  resting.samples[6].position = resting.samples[5].position;
  Recording rests = recording_of_stroke(resting);
  EXPECT_EQ(mend(rests), Lines());
}

TEST(Mend, SpreadsPackets) {
  RecordedStroke stroke = wave();
  stroke.samples[10].time = stroke.samples[11].time = stroke.samples[12].time;
  Recording recording = recording_of_stroke(stroke);
  EXPECT_EQ(mend(recording),
            Lines{"stroke 1, samples 11 to 13: share the time 0.12; spread over the time before"});
  EXPECT_NEAR(recording.strokes[0].samples[10].time, 0.10, 1e-9);
  EXPECT_NEAR(recording.strokes[0].samples[11].time, 0.11, 1e-9);
  for (Sample& sample : stroke.samples) sample.time = 3;
  Recording standing = recording_of_stroke(stroke);
  EXPECT_EQ(mend(standing), Lines{"stroke 1, samples 1 to 40: all have the same time; times left out"});
  EXPECT_FALSE(standing.strokes[0].fields.time);
}

TEST(Mend, RemovesWildSamples) {
  RecordedStroke stroke = wave();
  stroke.samples.insert(stroke.samples.begin() + 20, sample_at(0.195, 400, -300));
  Lines did;
  EXPECT_TRUE(gives_the_wave(stroke, did));
  EXPECT_EQ(did, Lines{"stroke 1, sample 21: far beside the way; left out"});
}

TEST(Mend, NumbersSamplesAsTheRecordingDoes) {
  RecordedStroke stroke = wave();
  stroke.samples.insert(stroke.samples.begin() + 20, sample_at(0.195, 400, -300));
  stroke.samples.insert(stroke.samples.begin() + 5, stroke.samples[5]);
  std::swap(stroke.samples[2], stroke.samples[3]);
  Lines did;
  EXPECT_TRUE(gives_the_wave(stroke, did));
  EXPECT_EQ(did,
            (Lines{"stroke 1, sample 4: its time 0.02 is before that of the one before; it goes to place 3",
                   "stroke 1, sample 7: a duplicate of the one before; left out",
                   "stroke 1, sample 22: far beside the way; left out"}));
}

TEST(Mend, RemovesHooksOfThePenThatLandsAndLifts) {
  RecordedStroke stroke = wave();
  for (Sample& sample : stroke.samples) sample.time += 0.02;
  const RecordedStroke clean = stroke;
  stroke.samples.insert(stroke.samples.begin(), {sample_at(0, 1.5, 1.7), sample_at(0.01, 0.8, 0.9)});
  const Sample last = clean.samples.back();
  stroke.samples.push_back(sample_at(0.45, last.position.x() - 1.5, last.position.y() - 1.5));
  Recording recording = recording_of_stroke(stroke);
  EXPECT_EQ(mend(recording), (Lines{"stroke 1, sample 43: a hook of the pen that lifts; left out",
                                    "stroke 1, samples 1 to 2: a hook of the pen that lands; left out"}));
  EXPECT_TRUE(test::same_bits(recording, recording_of_stroke(clean)));
}

TEST(Mend, KeepsCorners) {
  RecordedStroke zigzag;
  zigzag.fields = {.time = true};
  for (int i = 0; i < 60; ++i)
    zigzag.samples.push_back(sample_at(i * 0.01, i, i / 10 % 2 ? 10 - i % 10 : i % 10));
  Recording recording = recording_of_stroke(zigzag);
  EXPECT_EQ(mend(recording), Lines());
}

/// A line with a short piece at its end that leaves it at this angle, 180 degrees for one that goes on.
Recording line_with_end(double degrees, double step_of_end) {
  RecordedStroke stroke;
  for (int i = 0; i < 100; ++i) stroke.samples.push_back(sample_at(0, i, 0));
  const double angle = degrees * std::numbers::pi / 180;
  for (int i = 1; i <= 3; ++i)
    stroke.samples.push_back(
        sample_at(0, 99 - i * step_of_end * std::cos(angle), i * step_of_end * std::sin(angle)));
  return recording_of_stroke(stroke);
}

TEST(Mend, TellsHooksFromStrokesThatAreDrawnOnPurpose) {
  Recording back = line_with_end(20, 1), aside = line_with_end(75, 1), trembling = line_with_end(20, 0.1);
  EXPECT_EQ(mend(back), Lines{"stroke 1, samples 101 to 103: a hook of the pen that lifts; left out"});
  EXPECT_EQ(mend(aside), Lines()) << "the last piece of a letter";
  EXPECT_EQ(mend(trembling), Lines()) << "shorter than the pen's steps";
}

/// The end of a hook may look like a hook of its own.
bool tells_of_a_hook(const std::string& line) { return line.find("a hook") != line.npos; }

TEST(Mend, MendsRealFilesAndFindsNothingButHooksInThemAgain) {
  for (const char* name : {"evemu_cintiq_12wx.events", "uim_31_math_structures.uim", "bdalab_signal.svc",
                           "inkml_inkmljs_ink1.inkml", "isf_multi_stroke_gesture.isf"}) {
    BURIN_SHARED_DATA_OR_SKIP(path, std::string("strokes/") + name);
    Recording recording = recording_of(read_pen_file(path));
    const std::size_t strokes = recording.strokes.size();
    EXPECT_FALSE(mend(recording).empty()) << name;
    EXPECT_EQ(recording.strokes.size(), strokes) << name;
    const Lines again = mend(recording);
    EXPECT_TRUE(std::ranges::all_of(again, tells_of_a_hook)) << name;
  }
}

TEST(SplitAndJoin, AreEachOthersInverse) {
  Recording recording = recording_of_stroke(wave());
  for (std::size_t i = 15; i < 40; ++i) recording.strokes[0].samples[i].time += 0.5;
  recording.strokes[0].settings[&StrokeSettings::radius] = 0.25;
  const Recording whole = recording;
  EXPECT_EQ(split(recording, 0.2).size(), 1u);
  ASSERT_EQ(recording.strokes.size(), 2u);
  EXPECT_EQ(recording.strokes[0].samples.size(), 15u);
  EXPECT_EQ(*recording.strokes[1].settings.find(&StrokeSettings::radius), 0.25);
  EXPECT_EQ(join(recording, 0.2), Lines());
  EXPECT_EQ(join(recording, 0.52).size(), 1u);
  EXPECT_TRUE(test::same_bits(recording, whole));
}

TEST(Join, KeepsApartWhatDiffersOrHasNoTimes) {
  Recording recording = recording_of_stroke(wave());
  recording.strokes.push_back(wave());
  for (Sample& sample : recording.strokes[1].samples) sample.time += 0.4;
  recording.strokes[1].fields.pressure = false;
  EXPECT_EQ(join(recording, 1), Lines());
  recording.strokes[0].fields = recording.strokes[1].fields = {};
  EXPECT_EQ(join(recording, 1), Lines());
  EXPECT_EQ(recording.strokes.size(), 2u);
}

TEST(Resample, GivesEvenTimesOnTheWay) {
  Recording recording = recording_of_stroke(wave());
  EXPECT_EQ(resample(recording, 250), Lines{"stroke 1: 40 samples became 99"});
  const std::vector<Sample>& samples = recording.strokes[0].samples;
  for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
    EXPECT_NEAR(samples[i].time, static_cast<double>(i) / 250, 1e-12);
    EXPECT_NEAR(samples[i].position.x(), 200 * samples[i].time, 1e-9);
  }
  EXPECT_EQ(samples.back().position, wave().samples.back().position);
  EXPECT_EQ(samples.back().time, wave().samples.back().time);
}

TEST(Resample, RefusesTimesThatFallAndEndlessStrokes) {
  Recording recording = recording_of_stroke(wave());
  EXPECT_THROW(resample(recording, 1e9), Error);
  std::swap(recording.strokes[0].samples[3], recording.strokes[0].samples[5]);
  EXPECT_THROW(resample(recording, 100), Error);
  RecordedStroke untimed = wave();
  untimed.fields.time = false;
  Recording still = recording_of_stroke(untimed);
  EXPECT_EQ(resample(still, 100), Lines{"stroke 1: has no times that rise; left as it is"});
}

}  // namespace
}  // namespace burin
