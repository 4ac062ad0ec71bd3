#pragma once
#include <burin/base/vector.h>
#include <burin/surface/vertex_paint.h>

namespace burin {

/// Diffuse reflectance of unpainted clay, linear RGB, 0..1. Used for pictures, and below partly covering
/// colours in files for other programs.
inline const Vec3f clay_colour(0.56f, 0.41f, 0.32f);

/// The appearance of a colour over clay, linear RGB. A fully covering colour does not change.
Vec3f over_clay(const PaintBytes& colour);

/// The appearance of a colour over clay as sRGB with full coverage. A fully covering colour keeps its bits.
PaintBytes bytes_over_clay(const PaintBytes& colour);

/// Whether any colour covers the clay only in part, so that it cannot be derived from its appearance.
bool shows_clay(const std::vector<PaintBytes>& colours);

/// The colours of a file that holds both their appearance, `shown`, and the colours themselves, `ink`. Where
/// the two contradict each other another program has painted since, and the appearance is used.
std::vector<PaintBytes> ink_unless_painted_over(const std::vector<PaintBytes>& shown,
                                                std::vector<PaintBytes> ink);

}  // namespace burin
