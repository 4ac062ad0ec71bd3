#pragma once
#include <burin/stamp/mip_pyramid.h>

namespace burin {

/// The area whose mean is a sample: the ellipse inscribed in the parallelogram with these sides, in units of
/// u and v.
struct SampleArea {
  float along_u, along_v;
  float across_u, across_v;
};

/// The mean of a channel of the bilinear image (sample_bilinear) over an area around (u, v). If the ellipse
/// is at most one texel long, the result is that of sample_bilinear, bit for bit; from one to two texels it
/// changes gradually into the mean. The result is continuous in u, v and the area. It is exact, except for
/// the quadrature across rows (see the source), if the ellipse is at most 4 texels wide and 32 long; larger
/// ones are computed from levels of the pyramid on which they are 2 to 8 texels wide or 16 to 64 long. So
/// an ellipse of more than 32 texels of length whose width is below an eighth of it is blurred across.
/// Returns NaN if a number is not finite. Any thread; the cost is bounded whatever the area.
float sample_area(const MipPyramid& pyramid, int channel, float u, float v, const SampleArea& area);

}  // namespace burin
