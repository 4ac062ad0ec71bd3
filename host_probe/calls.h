#pragma once
#include <cstdint>
#include <cstdio>

namespace burin_probe {

/// The calls of a host, in their order.
enum class Call : unsigned {
  init,
  deinit,
  get_factory,
  create,
  destroy,
  get_extension,
  begin,
  evaluate,
  end,
  plan_solid,
  distance,
  reach,
  filter,
  save,
  load
};

/// Notes a call of this thread. `about`: number of the stroke, or of the brush outside of strokes; `nodes`:
/// of evaluate, distance and filter.
void note_call(Call call, std::uint64_t about = 0, std::uint64_t nodes = 0);

/// Notes how many evaluate calls run at once.
void note_running(int calls);

/// Writes how often each call came with how many nodes, and the first calls in their order.
void write_calls(std::FILE* file);

}  // namespace burin_probe
