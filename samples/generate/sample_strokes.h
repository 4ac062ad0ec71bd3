#pragma once
#include <burin/stroke/camera.h>
#include <burin/surface/surface.h>

#include <filesystem>

namespace burin::samples {

/// Looks at the belly of the ewer, 1280 x 960 pixels.
Camera side_camera(const Surface& ewer);

/// Writes the sample strokes on the ewer: meander.stroke (groove, once around the shoulder, down past the
/// handle and once around the foot), scale_band.stroke (scales, around the belly between the two),
/// wave.stroke (groove, a short S on the belly, visible from one side) and scroll.stroke (groove, an S-scroll
/// recorded in pixels of a camera that looks at the belly). `ewer`: the refined cage, on which the
/// object-space strokes lie.
void write_sample_strokes(const std::filesystem::path& folder, const Surface& ewer);

}  // namespace burin::samples
