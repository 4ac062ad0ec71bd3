// Follows touches through frames that tell all of them anew [kernel.org, Multi-touch Protocol, type A].
#include <burin/ink/decode/evdev_packets.h>

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>

namespace burin {
namespace {

constexpr std::size_t most_packets = 64;  // of a frame; far more than devices have

/// Drivers of this type also tell fingers that were lifted, by a size of 0, or those above the screen.
bool packet_touches(const EvdevValues& values) {
  const auto size = values.find(abs_mt_touch_major);
  return is_on_surface(values) && (size == values.end() || size->second > 0);
}

}  // namespace

void EvdevPackets::end_packet() {
  has_packets_ = true;
  if (packet_touches(packet_) && frame_.size() < most_packets) frame_.push_back({std::move(packet_), {}});
  packet_.clear();
}

/// Whether all of them tell an id, and none the same.
bool EvdevPackets::have_ids(const std::vector<Touch>& touches) {
  std::set<int> ids;
  return std::ranges::all_of(touches, [&](const Touch& touch) {
    const auto id = touch.values.find(abs_mt_tracking_id);
    return id != touch.values.end() && id->second >= 0 && ids.insert(id->second).second;
  });
}

void EvdevPackets::follow_ids(std::vector<Touch>& now) const {
  const auto id_of = [](const Touch& touch) { return touch.values.at(abs_mt_tracking_id); };
  for (Touch& touch : now) {
    const auto before = std::ranges::find(touches_, id_of(touch), id_of);
    if (before != touches_.end()) touch.stroke = before->stroke;
  }
}

/// Joins pairs of touches, the nearest first.
void EvdevPackets::follow_places(std::vector<Touch>& now) const {
  std::vector<std::tuple<double, std::size_t, std::size_t>> pairs;  // distance squared, before, now
  for (std::size_t i = 0; i < touches_.size(); ++i)
    for (std::size_t j = 0; j < now.size(); ++j) {
      const auto way = [&](unsigned axis) {
        return static_cast<double>(now[j].values.at(axis)) - touches_[i].values.at(axis);
      };
      const double x = way(abs_mt_position_x), y = way(abs_mt_position_y);
      pairs.emplace_back(x * x + y * y, i, j);
    }
  std::ranges::sort(pairs);
  std::set<std::size_t> followed;
  for (const auto& [distance, before, touch] : pairs)
    if (!now[touch].stroke && followed.insert(before).second) now[touch].stroke = touches_[before].stroke;
}

bool EvdevPackets::end_frame(double time, PenFile& content) {
  packet_.clear();
  if (!std::exchange(has_packets_, false)) return !touches_.empty();
  std::vector<Touch> now = std::exchange(frame_, {});
  if (have_ids(now) && have_ids(touches_))
    follow_ids(now);
  else
    follow_places(now);
  for (Touch& touch : now) add_touch_sample(axes_, touch.values, time, touch.stroke, content);
  touches_ = std::move(now);
  return !touches_.empty();
}

}  // namespace burin
