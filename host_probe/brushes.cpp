// Keeps the probe's brushes in an array of fixed size, so that a host's call for a brush that does not
// live can be recognised without reading freed memory. Takes no lock, since hosts create brushes on any
// thread.
#include "brushes.h"

#include <functional>

namespace burin_probe {
namespace {

constexpr std::uint64_t most_brushes = 4096;
Brush brushes[most_brushes];
std::atomic<std::uint64_t> created{0};

}  // namespace

Brush* take_brush() {
  for (std::uint64_t attempt = 0; attempt < most_brushes; ++attempt) {
    const std::uint64_t number = ++created;
    Brush& brush = brushes[number % most_brushes];
    std::uint64_t none = 0;
    if (brush.number.compare_exchange_strong(none, number)) return &brush;
  }
  return nullptr;
}

Brush* find_brush(const burin_brush* brush) {
  // A brush that the probe made is its own `self`; of another nothing may be read.
  const void* place = brush;
  const std::less<> before;
  if (before(place, brushes) || !before(place, brushes + most_brushes)) return nullptr;
  auto* found = static_cast<Brush*>(brush->self);
  return found->number > 0 ? found : nullptr;
}

int living_brushes() {
  int living = 0;
  for (const Brush& brush : brushes)
    if (brush.number > 0) ++living;
  return living;
}

}  // namespace burin_probe
