// Open strokes in an array of fixed size. A handle is a place in another array that holds nothing: it stays
// wrong for long after its stroke has ended, and no wrong handle is ever followed.
#include "strokes.h"

#include <functional>

namespace burin_probe {
namespace {

constexpr std::uint64_t most_strokes = 1024, most_handles = 65536;
Stroke strokes[most_strokes];
char handles[most_handles];
std::atomic<std::uint64_t> opened{0}, ended{0}, unfinished{0};

}  // namespace

Stroke* open_stroke(const burin_brush& brush, void*& handle) {
  for (std::uint64_t attempt = 0; attempt < most_strokes; ++attempt) {
    const std::uint64_t number = ++opened;
    Stroke& stroke = strokes[number % most_strokes];
    std::uint64_t none = 0;
    if (!stroke.number.compare_exchange_strong(none, number)) continue;
    stroke.brush = &brush;
    stroke.running = 0;
    stroke.evaluated = 0;
    stroke.final_seen = false;
    handle = &handles[number % most_handles];
    return &stroke;
  }
  return nullptr;
}

Stroke* find_stroke(const burin_brush& brush, const void* handle) {
  const std::less<> before;
  if (before(handle, handles) || !before(handle, handles + most_handles)) return nullptr;
  const auto place = static_cast<std::uint64_t>(static_cast<const char*>(handle) - handles);
  Stroke& stroke = strokes[place % most_strokes];
  const std::uint64_t number = stroke.number;
  return number > 0 && number % most_handles == place && stroke.brush == &brush ? &stroke : nullptr;
}

void close_stroke(Stroke& stroke) {
  if (stroke.evaluated > 0) {
    ++ended;
    if (!stroke.final_seen) ++unfinished;
  }
  stroke.number = 0;
}

int open_strokes(const burin_brush& brush) {
  int open = 0;
  for (const Stroke& stroke : strokes)
    if (stroke.number > 0 && stroke.brush == &brush) ++open;
  return open;
}

EndedStrokes ended_strokes() { return {ended, unfinished}; }

}  // namespace burin_probe
