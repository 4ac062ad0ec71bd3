#pragma once
#include <burin/stamp/files/picture.h>

#include "subject.h"

namespace burin::paper {

/// The region in squares of a quarter of the radius, with the stroke.
Picture checkerboard_picture(const Subject& subject, const Parameterization& places);

/// Vertices that were measured from white (no error) to red (`worst` percent of the radius and more).
Picture error_picture(const Subject& subject, const DistanceError& error, double worst);

}  // namespace burin::paper
