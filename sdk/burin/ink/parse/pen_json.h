#pragma once
#include <burin/base/text/json_value.h>
#include <burin/ink/pen_file.h>

namespace burin {

/// Throws FileError for JSON that is nested deeper than 200 levels or whose values would need more than 56 MB
/// once they are parsed.
void check_json_bounds(const PenFileText& file);

/// The JSON of a pen file, within these bounds.
JsonValue pen_json(const PenFileText& file);

}  // namespace burin
