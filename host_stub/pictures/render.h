#pragma once
#include <burin/base/progress.h>
#include <burin/stamp/files/picture.h>
#include <burin/stroke/camera.h>
#include <burin/surface/picker.h>
#include <burin/surface/surface.h>

#include <functional>

namespace burin {

/// Diffuse reflectance at a point of the surface, linear RGB, 0..1. Any thread, concurrent.
using Albedo = std::function<Vec3f(const SurfacePoint&)>;

/// Of plain clay.
Vec3f clay(const SurfacePoint& point);

/// A picture of the surface as clay under a key light with shadows, a fill light, a rim light and a sky
/// that crevices occlude, before a neutral ground that varies from row to row only. Four samples a pixel.
/// `picker` is that of `surface`. The picture does not depend on the number of threads.
Picture render(const Surface& surface, const Picker& picker, const Camera& camera,
               const Albedo& albedo = clay, const Progress& progress = {});

}  // namespace burin
