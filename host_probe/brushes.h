#pragma once
#include <burin/abi/brush.h>

#include <atomic>
#include <cstdint>

namespace burin_probe {

/// A brush of the probe, in an array of fixed size: one that is destroyed can still be looked at.
struct Brush {
  burin_brush abi{};
  std::atomic<std::uint64_t> number{0};  ///< from 1; 0 while there is none
  const burin_brush_descriptor* descriptor = nullptr;
  const burin_host* host = nullptr;
  burin_host host_then{};               ///< what the host was at create
  std::atomic<std::uint32_t> state{7};  ///< what save writes
};

/// Takes a free place, whose number is new; null if there is none.
Brush* take_brush();

/// The brush that the host passes, or null if it does not live.
Brush* find_brush(const burin_brush* brush);

/// The number of brushes that live.
int living_brushes();

}  // namespace burin_probe
