#pragma once
#include <burin/solid_module/solid_module.h>

namespace burin {

/// What level_set does with solids, by the module burin-solids.so, which the first call loads. Throws
/// FileError if it cannot be loaded. Any thread, also on several at once.
const SolidTools& solid_tools();

}  // namespace burin
