#pragma once
#include <burin/stamp/files/picture.h>

#include <filesystem>
#include <string>

namespace burin {

/// A stroke that a session drew with a brush on a plane of 90000 triangles.
struct DrawnStroke {
  double share = 0;  ///< of the brush in the time of all events, its inputs included
  Picture picture;
};

/// Draws it. `stamp`: the image of parameters that must name one. Throws Error.
DrawnStroke draw_stroke(const std::filesystem::path& module, const std::string& brush,
                        const std::filesystem::path& stamp);

}  // namespace burin
