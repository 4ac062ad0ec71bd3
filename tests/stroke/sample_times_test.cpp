#include <burin/stroke/sample_times.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <vector>

#include "stroke/recordings.h"

namespace burin {
namespace {

std::vector<Sample> samples_at(const std::vector<double>& times) {
  std::vector<Sample> samples(times.size());
  for (std::size_t i = 0; i < times.size(); ++i) {
    samples[i].time = times[i];
    samples[i].position.x() = static_cast<double>(i);
  }
  return samples;
}

std::vector<double> spread(const std::vector<double>& times) {
  std::vector<Sample> samples = samples_at(times);
  spread_times(samples);
  std::vector<double> spread;
  for (const Sample& sample : samples) spread.push_back(sample.time);
  return spread;
}

void expect_near(const std::vector<double>& times, const std::vector<double>& expected) {
  ASSERT_EQ(times.size(), expected.size());
  for (std::size_t i = 0; i < times.size(); ++i) EXPECT_NEAR(times[i], expected[i], 1e-12) << i;
}

TEST(SpreadTimes, LeavesStampsThatDifferAsTheyAre) {
  const std::vector<double> times{-3, 0.1, 0.1000001, 7, 7.3, 1e9};
  EXPECT_EQ(spread(times), times);
  EXPECT_EQ(spread({}), std::vector<double>{});
  EXPECT_EQ(spread({4}), std::vector<double>{4});
}

TEST(SpreadTimes, GivesTheSamplesOfPacketsTheirOwn) {
  expect_near(spread({0, 4, 4, 4, 4, 8, 8, 8, 8, 12, 12, 12, 12}),
              {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12});
  expect_near(spread({3, 3, 3, 6, 6, 6}), {1, 2, 3, 4, 5, 6});
}

TEST(SpreadTimes, KeepsPacketsTogetherAfterAPause) {
  expect_near(spread({2, 2, 4, 4, 6, 6, 90, 90, 92, 92}), {1, 2, 3, 4, 5, 6, 89, 90, 91, 92});
}

TEST(SpreadTimes, NeverLetsTimesFallOrStand) {
  // Whole milliseconds of a pen sampled every 0.3 or 1.7 of them, and now and then not at all.
  for (const double step : {0.3, 1.7}) {
    std::vector<double> times;
    for (int i = 0; i < 300; ++i)
      times.push_back(std::floor(step * i + (i > 100 ? 40 : 0) + (i > 200 ? 0.9 : 0)));
    const std::vector<double> own = spread(times);
    for (std::size_t i = 1; i < own.size(); ++i) EXPECT_GT(own[i], own[i - 1]) << step << " " << i;
    for (std::size_t i = 0; i < own.size(); ++i)
      EXPECT_LE(std::abs(own[i] - times[i]), 1) << step << " " << i;
  }
}

TEST(ClockStands, WhereAllStampsOfSeveralSamplesAreEqual) {
  EXPECT_TRUE(has_constant_time(samples_at({5, 5, 5})));
  EXPECT_FALSE(has_constant_time(samples_at({5, 5, 6})));
  EXPECT_FALSE(has_constant_time(samples_at({5}))) << "a tap";
  EXPECT_FALSE(has_constant_time({}));
}

TEST(MendTimes, TakesAStandingClockForNone) {
  Recording recording;
  recording.strokes.resize(3);
  for (RecordedStroke& stroke : recording.strokes) stroke.fields.time = true;
  recording.strokes[0].samples = samples_at({5, 5, 5});
  recording.strokes[1].samples = samples_at({2, 2, 4, 4});
  recording.strokes[2].samples = samples_at({2, 2, 4, 4});
  recording.strokes[2].fields.time = false;
  EXPECT_EQ(repair_times(recording), 1u);
  EXPECT_FALSE(recording.strokes[0].fields.time);
  EXPECT_TRUE(recording.strokes[1].fields.time);
  EXPECT_EQ(recording.strokes[1].samples[2].time, 3);
  EXPECT_EQ(recording.strokes[2].samples[2].time, 4) << "not a time at all";
}

}  // namespace
}  // namespace burin
