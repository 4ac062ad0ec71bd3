#pragma once
#include <burin/stroke/files/setting_table.h>
#include <burin/stroke/recording.h>

#include <bit>
#include <cstdint>
#include <nlohmann/json.hpp>

namespace burin::test {

inline std::uint64_t bits(double value) { return std::bit_cast<std::uint64_t>(value); }
inline std::uint32_t bits(float value) { return std::bit_cast<std::uint32_t>(value); }

/// Equal to the last bit, signs of zeros included.
inline bool same_bits(const Sample& a, const Sample& b) {
  return bits(a.time) == bits(b.time) && bits(a.position.x()) == bits(b.position.x()) &&
         bits(a.position.y()) == bits(b.position.y()) && bits(a.position.z()) == bits(b.position.z()) &&
         bits(a.pen.pressure) == bits(b.pen.pressure) && bits(a.pen.tilt_x) == bits(b.pen.tilt_x) &&
         bits(a.pen.tilt_y) == bits(b.pen.tilt_y) && bits(a.pen.twist) == bits(b.pen.twist) &&
         a.barrel == b.barrel;
}

inline bool same_bits(const RecordedStroke& a, const RecordedStroke& b) {
  auto of_a = nlohmann::ordered_json::object(), of_b = of_a;
  write_settings(a.settings, of_a);
  write_settings(b.settings, of_b);
  if (a.drawn_by != b.drawn_by) return false;
  if (of_a != of_b || a.fields != b.fields || a.samples.size() != b.samples.size()) return false;
  for (std::size_t i = 0; i < a.samples.size(); ++i)
    if (!same_bits(a.samples[i], b.samples[i])) return false;
  return true;
}

inline bool same_bits(const Recording& a, const Recording& b) {
  if (a.space != b.space || a.device != b.device || a.cut_off_at != b.cut_off_at ||
      a.camera.has_value() != b.camera.has_value() || a.strokes.size() != b.strokes.size())
    return false;
  if (a.camera && (a.camera->view != b.camera->view || a.camera->projection != b.camera->projection ||
                   a.camera->width != b.camera->width || a.camera->height != b.camera->height))
    return false;
  for (std::size_t i = 0; i < a.strokes.size(); ++i)
    if (!same_bits(a.strokes[i], b.strokes[i])) return false;
  return true;
}

}  // namespace burin::test
