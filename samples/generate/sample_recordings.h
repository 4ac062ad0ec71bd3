#pragma once
#include <burin/surface/surface.h>

#include <filesystem>

namespace burin::samples {

/// Writes 20 recordings in the manner of real ones (docs/recordings.md): each of ten devices and programs
/// draws two of ten gestures on the belly of the ewer, in pixels of side_camera().
void write_recordings(const std::filesystem::path& folder, const Surface& ewer);

}  // namespace burin::samples
