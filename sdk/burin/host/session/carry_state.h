#pragma once
#include <burin/abi/brush.h>

#include <string>

namespace burin {

/// Gives a brush the state of another that was made of the same module, perhaps of an older version of it
/// (abi/ext/state.h). Does nothing if one of them has none. Returns why the state is lost, or an empty
/// string. No stroke of either may be open.
std::string carry_state(const burin_brush& from, const burin_brush& to);

}  // namespace burin
