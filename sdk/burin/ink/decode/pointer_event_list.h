#pragma once
#include <burin/ink/pen_file.h>

#include <string_view>

namespace burin {

/// Whether a text begins as a list of objects with an x, or has one in each line: PointerEvents as they came,
/// flat but for lists of the events that the browser has put together in one.
bool begins_as_event_list(std::string_view text);

/// Whether a text begins as an object that has such a list as "events".
bool has_event_list(std::string_view text);

/// Reads a list of PointerEvents. One of each run in which a pointer touches is a stroke; whether it does is
/// told by `buttons`, else by `type`, else by the pressure. Events that were put together count instead of
/// the one that they were put into. Throws FileError.
PenFile read_event_list(const PenFileText& file);

}  // namespace burin
