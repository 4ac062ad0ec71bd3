// Mends the times of strokes, and samples that were delivered twice.
#include <burin/ink/mend/drawn_length.h>
#include <burin/ink/mend/mend_times.h>
#include <burin/stroke/sample_times.h>
#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace burin {
namespace {

bool time_falls(const Sample& before, const Sample& sample) { return sample.time < before.time; }

/// The places of the samples in the order of their times.
std::vector<std::size_t> order_of_times(const std::vector<Sample>& samples) {
  std::vector<std::size_t> order(samples.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](std::size_t place) { return samples[place].time; });
  return order;
}

/// `order`: places, in the order of times.
void put_in_order(std::vector<Sample>& samples, const std::vector<std::size_t>& order, MendLog& log) {
  const auto time_of = [&](std::size_t place) { return samples[place].time; };
  for (std::size_t i = 1; i < samples.size(); ++i) {
    if (!time_falls(samples[i - 1], samples[i])) continue;
    const auto place = std::ranges::lower_bound(order, samples[i].time, {}, time_of);
    log.add(i, i,
            fmt::format("its time {} is before that of the one before; it goes to place {}", samples[i].time,
                        1 + (place - order.begin())));
  }
  log.keep(order, samples);
}

void raise_times(std::vector<Sample>& samples, MendLog& log) {
  for (std::size_t i = 1; i < samples.size(); ++i) {
    if (!time_falls(samples[i - 1], samples[i])) continue;
    log.add(i, i, fmt::format("its time {} falls; raised to {}", samples[i].time, samples[i - 1].time));
    samples[i].time = samples[i - 1].time;
  }
}

bool repeats(const Sample& sample, const Sample& before) {
  const Pen &a = sample.pen, &b = before.pen;
  return sample.position == before.position && sample.time == before.time && a.pressure == b.pressure &&
         a.tilt_x == b.tilt_x && a.tilt_y == b.tilt_y && a.twist == b.twist && sample.barrel == before.barrel;
}

}  // namespace

void mend_order(RecordedStroke& stroke, MendLog& log) {
  std::vector<Sample>& samples = stroke.samples;
  if (!stroke.fields.time || std::ranges::is_sorted(samples, {}, &Sample::time)) return;
  const std::vector<std::size_t> order = order_of_times(samples);
  std::vector<Sample> ordered;
  for (const std::size_t place : order) ordered.push_back(samples[place]);
  if (drawn_length(ordered) <= drawn_length(samples))
    put_in_order(samples, order, log);
  else
    raise_times(samples, log);
}

void remove_duplicates(RecordedStroke& stroke, MendLog& log) {
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < stroke.samples.size(); ++i) {
    if (i > 0 && repeats(stroke.samples[i], stroke.samples[kept.back()]))
      log.add(i, i, "a duplicate of the one before; left out");
    else
      kept.push_back(i);
  }
  log.keep(kept, stroke.samples);
}

void mend_packets(RecordedStroke& stroke, MendLog& log) {
  std::vector<Sample>& samples = stroke.samples;
  if (!stroke.fields.time) return;
  if (has_constant_time(samples)) {
    log.add(0, samples.size() - 1, "all have the same time; times left out");
    stroke.fields.time = false;
    for (Sample& sample : samples) sample.time = 0;
    return;
  }
  for (std::size_t begin = 0; begin < samples.size();) {
    std::size_t end = begin + 1;
    while (end < samples.size() && samples[end].time == samples[begin].time) ++end;
    if (end - begin > 1)
      log.add(begin, end - 1,
              fmt::format("share the time {}; spread over the time before", samples[begin].time));
    begin = end;
  }
  spread_times(samples);
}

}  // namespace burin
