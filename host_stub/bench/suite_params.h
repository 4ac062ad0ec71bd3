#pragma once
#include <burin/host/replay.h>

#include <string>

namespace burin {

/// Parameters that the suite at `path` gives, with files, which it names from its own folder, as they are
/// seen from the working directory; "" stays no file.
ParamSettings params_of_suite(const std::string& path, const StrokeOverrides& overrides,
                              const BrushLibrary& brushes);

}  // namespace burin
