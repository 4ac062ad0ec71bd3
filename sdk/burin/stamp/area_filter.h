#pragma once
#include <burin/stamp/mip_pyramid.h>

namespace burin {

/// The part of a stamp around a place that a sample is the mean of: the ellipse inscribed in the
/// parallelogram with these sides, in units of u and v.
struct SampleArea {
  float along_u, along_v;
  float across_u, across_v;
};

/// Mean of a channel, as sample_bilinear shows it, over an area around (u, v). Bit for bit sample_bilinear
/// where the area is nowhere longer than a texel; from one to two texels it passes from one to the other.
/// Continuous in the place and in the area. An area more than 4 texels across is taken from the pyramid's
/// averages, one more than 32 times as long as those are wide is blurred across. NaN where a number is not
/// finite. Any thread.
float sample_area(const MipPyramid& pyramid, int channel, float u, float v, const SampleArea& area);

}  // namespace burin
