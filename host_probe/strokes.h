#pragma once
#include <burin/abi/brush.h>

#include <atomic>
#include <cstdint>

namespace burin_probe {

inline constexpr std::uint32_t most_params = 16;

/// An open stroke, as begin saw it.
struct Stroke {
  std::atomic<std::uint64_t> number{0};  ///< from 1; 0 while there is none
  const burin_brush* brush = nullptr;
  unsigned thread = 0;
  burin_stroke_context context{};
  burin_stroke_plan plan{};
  float numbers[most_params] = {};  ///< of the parameters that have one
  std::atomic<int> running{0};      ///< evaluate calls
  std::atomic<std::uint64_t> evaluated{0};
  std::atomic<bool> final_seen{false};
};

/// Opens a stroke; null if too many are open. `handle` is what the host is to pass.
Stroke* open_stroke(const burin_brush& brush, void*& handle);

/// The open stroke of this brush with a handle, or null.
Stroke* find_stroke(const burin_brush& brush, const void* handle);

/// Closes it, and counts what became of it.
void close_stroke(Stroke& stroke);

/// The number of strokes of a brush that are open.
int open_strokes(const burin_brush& brush);

/// Strokes that were evaluated and ended, and those of them that no evaluate call saw finished.
struct EndedStrokes {
  std::uint64_t all, unfinished;
};
EndedStrokes ended_strokes();

}  // namespace burin_probe
