// Checks that the sample recordings have the rates, packets, repeats and steps that docs/recordings.md
// states.
#include <burin/stroke/stroke_file.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace burin {
namespace {

/// What docs/recordings.md states of a recorder.
struct Stated {
  const char* recorder;
  double median_ms;  ///< between samples; 0: no times
  double step;       ///< of positions, pixels
  double packed;     ///< share of samples under the time of the next one
  double repeated;   ///< share of samples at the place of the one before
  bool pressure = true;
};

const Stated stated[] = {{"intuos4", 4, 0.04, 0, 0.04},      {"cintiq", 7.1, 0.05, 0, 0.01},
                         {"intuos_pro", 5.9, 0.05, 0, 0.02}, {"uclogic", 8, 0.03, 0, 0.02},
                         {"svc", 7.5, 0.1, 0, 0.14},         {"uim", 19, 0.01, 0.07, 0.24},
                         {"mypaint", 8, 0.5, 0, 0.005},      {"pointer", 16.1, 0.5, 0, 0.01},
                         {"mouse", 17, 1, 0, 0.02, false},   {"note", 0, 0.01, 0, 0}};

std::vector<RecordedStroke> strokes_of(const std::string& recorder) {
  std::vector<RecordedStroke> strokes;
  for (const auto& entry : std::filesystem::directory_iterator(BURIN_SAMPLES "/recordings")) {
    const std::string name = entry.path().stem().string();
    if (name.substr(0, name.rfind('_')) != recorder) continue;
    const Recording recording = read_strokes(entry.path());
    EXPECT_FALSE(recording.device.empty());
    strokes.insert(strokes.end(), recording.strokes.begin(), recording.strokes.end());
  }
  return strokes;
}

TEST(SampleRecordings, HaveWhatIsStatedOfTheirRecorders) {
  for (const Stated& expected : stated) {
    std::vector<double> intervals;
    double repeated = 0, packed = 0, pairs = 0;
    const std::vector<RecordedStroke> strokes = strokes_of(expected.recorder);
    ASSERT_EQ(strokes.size(), 2u) << expected.recorder;
    for (const RecordedStroke& stroke : strokes) {
      EXPECT_EQ(stroke.fields.pressure, expected.pressure) << expected.recorder;
      EXPECT_EQ(stroke.fields.time, expected.median_ms > 0) << expected.recorder;
      for (std::size_t i = 1; i < stroke.samples.size(); ++i) {
        const Sample &a = stroke.samples[i - 1], &b = stroke.samples[i];
        intervals.push_back(1000 * (b.time - a.time));
        packed += stroke.fields.time && a.time == b.time;
        repeated += a.position == b.position;
        ++pairs;
        const double steps = b.position.x() / expected.step;
        EXPECT_NEAR(steps, std::round(steps), 0.02) << expected.recorder;
      }
    }
    std::ranges::sort(intervals);
    EXPECT_NEAR(intervals[intervals.size() / 2], expected.median_ms, 0.15 * expected.median_ms + 0.1)
        << expected.recorder;
    EXPECT_NEAR(packed / pairs, expected.packed, 0.05) << expected.recorder;
    EXPECT_GE(repeated / pairs, expected.repeated / 2 - 0.01) << expected.recorder;
    EXPECT_LE(repeated / pairs, 2 * expected.repeated + 0.05) << expected.recorder;
  }
}

}  // namespace
}  // namespace burin
