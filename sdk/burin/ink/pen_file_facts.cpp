// Counts and measures the samples of a pen file.
#include <burin/ink/pen_file_facts.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace burin {
namespace {

void extend(std::optional<ValueRange>& range, double value) {
  if (!range) range = ValueRange{value, value};
  range->least = std::min(range->least, value);
  range->most = std::max(range->most, value);
}

/// The middle one of some values, the lower of two; 0 of none.
template <class Value>
Value median_of(std::vector<Value> values) {
  if (values.empty()) return {};
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

void add_ranges(const PenStroke& stroke, PenFileFacts& facts) {
  for (const Sample& sample : stroke.samples) {
    extend(facts.x, sample.position.x());
    extend(facts.y, sample.position.y());
    if (stroke.fields.pressure) {
      extend(facts.pressure, sample.pen.pressure);
      if (sample.pen.pressure == 0) ++facts.without_pressure;
    }
    if (stroke.fields.tilt) {
      extend(facts.tilt_x, sample.pen.tilt_x);
      extend(facts.tilt_y, sample.pen.tilt_y);
    }
  }
}

/// Compares each sample with the one before and adds the intervals between them.
void add_steps(const PenStroke& stroke, PenFileFacts& facts, std::vector<double>& intervals) {
  for (std::size_t i = 1; i < stroke.samples.size(); ++i) {
    const Sample &before = stroke.samples[i - 1], &sample = stroke.samples[i];
    if (sample.position == before.position) ++facts.duplicates;
    if (!stroke.fields.time) continue;
    const double interval = sample.time - before.time;
    if (interval == 0) ++facts.equal_stamps;
    if (interval < 0) ++facts.falling_times;
    extend(facts.interval, interval);
    facts.ink_seconds += interval;
    intervals.push_back(interval);
  }
}

void add_rate(std::vector<double> intervals, PenFileFacts& facts) {
  constexpr double long_gap = 5;
  if (intervals.empty()) return;
  facts.median_interval = median_of(intervals);
  facts.gaps = static_cast<std::size_t>(std::ranges::count_if(
      intervals, [&](double interval) { return interval > long_gap * facts.median_interval; }));
  if (facts.ink_seconds > 0) facts.rate = static_cast<double>(intervals.size()) / facts.ink_seconds;
  for (double& interval : intervals) interval = std::abs(interval - facts.median_interval);
  facts.jitter = median_of(std::move(intervals));
}

}  // namespace

PenFileFacts facts_of(const PenFile& file) {
  PenFileFacts facts;
  std::vector<double> intervals;
  std::vector<std::size_t> lengths;
  for (const PenStroke& stroke : file.strokes) {
    facts.samples += stroke.samples.size();
    facts.pages = std::max(facts.pages, stroke.page);
    facts.layers = std::max(facts.layers, stroke.layer);
    lengths.push_back(stroke.samples.size());
    if (stroke.made_pressure) ++facts.made_pressure;
    if (stroke.estimated_y) ++facts.estimated_y;
    add_ranges(stroke, facts);
    add_steps(stroke, facts, intervals);
  }
  facts.strokes = lengths.size();
  if (!lengths.empty()) {
    facts.shortest = std::ranges::min(lengths);
    facts.longest = std::ranges::max(lengths);
  }
  facts.median_length = median_of(std::move(lengths));
  add_rate(std::move(intervals), facts);
  return facts;
}

}  // namespace burin
