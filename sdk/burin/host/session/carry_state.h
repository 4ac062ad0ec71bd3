#pragma once
#include <burin/abi/brush.h>
#include <burin/abi/ext/state.h>

#include <cstddef>
#include <string>
#include <vector>

namespace burin {

/// The ability of a brush to keep state; null if it, or one of its functions, is missing.
const burin_state* state_of(const burin_brush& brush);

/// The state of a brush, or why it cannot be saved, with the status of the brush if that says so.
struct SavedState {
  burin_status status = BURIN_OK;
  std::string problem;
  std::vector<std::byte> bytes;
};

/// Saves the state of a brush, at most 1 GiB. `state` is its ability; none of its strokes may be open.
SavedState save_state(const burin_brush& brush, const burin_state& state);

/// Gives a brush the state of another that was made of the same module, perhaps of an older version of it
/// (abi/ext/state.h). Does nothing if one of them has none. Returns why the state is lost, or an empty
/// string. No stroke of either may be open.
std::string carry_state(const burin_brush& from, const burin_brush& to);

}  // namespace burin
