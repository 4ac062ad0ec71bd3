#pragma once
#include <burin/host/brush_library.h>
#include <burin/stroke/recording.h>

#include <string>

namespace burin {

/// Parameters that the suite at `path` gives, with files, which it names from its own folder, as they are
/// seen from the working directory.
ParamSettings params_of_suite(const std::string& path, ParamSettings params, const BrushLibrary& brushes);

}  // namespace burin
