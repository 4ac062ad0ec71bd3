#pragma once
#include <burin/stroke/curve/surface_curve.h>
#include <burin/surface/base_surface/base_surface.h>
#include <burin/surface/surface.h>

#include <cstddef>

namespace burin::kernels {

/// A swinging stroke of six radii on a unit sphere of irregular triangles.
struct SphereStroke {
  const Surface& surface;
  double radius = 0;  ///< half width of the stroke, object units
  SurfaceCurve curve;
};

/// The stroke whose chart has about so many nodes, at most a million. The finer the surface the more nodes,
/// so that strokes look alike; the sphere has 2.6 million vertices at most. Made once, then kept. One thread.
const SphereStroke& sphere_stroke(std::size_t nodes);

/// The stroke's curve on a base surface.
SurfaceCurve on_base(const SphereStroke& stroke, BaseSurface* base);

}  // namespace burin::kernels
