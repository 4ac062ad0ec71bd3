#pragma once
#include <burin/host/brush_library.h>
#include <burin/stroke/given_settings.h>

#include <string>

namespace burin {

/// The settings of a case of the suite at `path`, with files among the brush's parameters, which it names
/// from its own folder, as they are seen from the working directory; "" stays no file.
GivenSettings settings_of_suite(const std::string& path, const GivenSettings& settings,
                                const BrushLibrary& brushes);

}  // namespace burin
