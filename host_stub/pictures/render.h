#pragma once
#include <burin/base/progress.h>
#include <burin/base/vector.h>
#include <burin/stamp/files/picture.h>
#include <burin/stroke/camera.h>
#include <burin/surface/picker.h>
#include <burin/surface/surface.h>

#include <functional>

namespace burin {

/// Diffuse reflectance at a point of the surface, linear RGB, 0..1. Called on several threads at once.
using Albedo = std::function<Vec3f(const SurfacePoint&)>;

/// The albedo of plain clay.
Vec3f clay(const SurfacePoint& point);

/// Renders the surface under a key light with shadows, a fill light, a rim light and a sky with ambient
/// occlusion, in front of a neutral background that varies from row to row only. Four samples per pixel.
/// `picker` is that of `surface`. The picture does not depend on the number of threads.
Picture render(const Surface& surface, const Picker& picker, const Camera& camera,
               const Albedo& albedo = clay, const Progress& progress = {});

}  // namespace burin
