// Spreads the equal time stamps of tablets that deliver samples in packets, in O(samples).
#include <burin/math/median.h>
#include <burin/stroke/sample_times.h>

#include <algorithm>
#include <vector>

namespace burin {
namespace {

using Packet = std::span<Sample>;

std::vector<Packet> packets_of(std::span<Sample> samples) {
  std::vector<Packet> packets;
  for (std::size_t begin = 0; begin < samples.size();) {
    std::size_t end = begin + 1;
    while (end < samples.size() && samples[end].time == samples[begin].time) ++end;
    packets.push_back(samples.subspan(begin, end - begin));
    begin = end;
  }
  return packets;
}

/// The interval in seconds of samples that would fill the time from the packet before to this one evenly.
double interval_within(const Packet& before, const Packet& packet) {
  return (packet.front().time - before.front().time) / static_cast<double>(packet.size());
}

double median_interval(const std::vector<Packet>& packets) {
  std::vector<double> intervals;
  for (std::size_t i = 1; i < packets.size(); ++i)
    intervals.push_back(interval_within(packets[i - 1], packets[i]));
  return math::median(intervals);
}

}  // namespace

bool has_constant_time(std::span<const Sample> samples) {
  return samples.size() > 1 && samples.front().time == samples.back().time;
}

void spread_times(std::span<Sample> samples) {
  const std::vector<Packet> packets = packets_of(samples);
  if (packets.size() < 2 || packets.size() == samples.size()) return;
  const double usual = median_interval(packets);
  std::vector<double> intervals{usual};
  for (std::size_t i = 1; i < packets.size(); ++i)
    intervals.push_back(std::min(interval_within(packets[i - 1], packets[i]), usual));
  for (std::size_t i = 0; i < packets.size(); ++i)
    for (std::size_t k = 0; k < packets[i].size(); ++k)
      packets[i][k].time -= static_cast<double>(packets[i].size() - 1 - k) * intervals[i];
}

std::size_t repair_times(Recording& recording) {
  std::size_t standing = 0;
  for (RecordedStroke& stroke : recording.strokes) {
    if (!stroke.fields.time) continue;
    stroke.fields.time = !has_constant_time(stroke.samples);
    if (!stroke.fields.time) ++standing;
    spread_times(stroke.samples);
  }
  return standing;
}

}  // namespace burin
