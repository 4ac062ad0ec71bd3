#pragma once
#include <burin/base/vector.h>
#include <burin/surface/vertex_paint.h>

namespace burin {

/// Diffuse reflectance of clay that nothing is painted on, linear RGB, 0..1: in pictures, and below colours
/// that cover it in part where other programs shall see what it looks like.
inline const Vec3f clay_colour(0.56f, 0.41f, 0.32f);

/// What a colour looks like over clay, linear RGB; one that covers the clay is as it was.
Vec3f over_clay(const PaintBytes& colour);

/// The same as sRGB, and as it was bit for bit where it covers the clay. The coverage is then whole.
PaintBytes bytes_over_clay(const PaintBytes& colour);

/// Whether any colour lets the clay be seen, so that what it looks like does not tell it.
bool shows_clay(const std::vector<PaintBytes>& colours);

/// The colours of a file that holds both what they look like and themselves, the ink. Where the two do not go
/// together some other program has painted since: there it is what they look like.
std::vector<PaintBytes> ink_unless_painted_over(const std::vector<PaintBytes>& shown,
                                                std::vector<PaintBytes> ink);

}  // namespace burin
