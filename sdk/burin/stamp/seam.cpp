// Compares steps across the border of an image with steps inside, to find whether the image tiles.
#include <burin/stamp/seam.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace burin {
namespace {

/// A channel whose columns and rows may be exchanged, so that both seams are measured in x.
class Channel {
 public:
  Channel(const StampImage& image, int channel, bool exchanged)
      : image_(image), channel_(channel), exchanged_(exchanged) {}

  int width() const { return exchanged_ ? image_.height : image_.width; }
  int height() const { return exchanged_ ? image_.width : image_.height; }
  double value(int x, int y) const {
    const std::size_t column = static_cast<std::size_t>(exchanged_ ? y : x);
    const std::size_t row = static_cast<std::size_t>(exchanged_ ? x : y);
    const std::size_t texel = row * static_cast<std::size_t>(image_.width) + column;
    return double{image_.texels[texel * static_cast<std::size_t>(image_.channels) +
                                static_cast<std::size_t>(channel_)]};
  }
  double step(int x, int next, int y) const { return std::abs(value(next, y) - value(x, y)); }

 private:
  const StampImage& image_;
  int channel_;
  bool exchanged_;
};

double ratio(double step, double other) { return step == 0 || other == 0 ? 0 : step / other; }

SeamStep seam_step(const Channel& channel) {
  const int last = channel.width() - 1;
  if (last < 1) return {};
  double wrap = 0, interior = 0, beside = 0;
  for (int y = 0; y < channel.height(); ++y) {
    wrap += channel.step(last, 0, y);
    beside += channel.step(0, 1, y) + channel.step(last - 1, last, y);
    for (int x = 0; x < last; ++x) interior += channel.step(x, x + 1, y);
  }
  return {ratio(wrap, interior / last), ratio(wrap, beside / 2)};
}

double border_spread(const Channel& channel, double range) {
  double least = channel.value(0, 0), greatest = least;
  const auto see = [&](int x, int y) {
    least = std::min(least, channel.value(x, y));
    greatest = std::max(greatest, channel.value(x, y));
  };
  for (int x = 0; x < channel.width(); ++x) see(x, 0), see(x, channel.height() - 1);
  for (int y = 0; y < channel.height(); ++y) see(0, y), see(channel.width() - 1, y);
  return ratio(greatest - least, range);
}

void take_greater(SeamStep& worst, const SeamStep& step) {
  worst.over_interior = std::max(worst.over_interior, step.over_interior);
  worst.over_beside = std::max(worst.over_beside, step.over_beside);
}

bool is_visible(const SeamStep& step) { return std::min(step.over_interior, step.over_beside) > 2; }

}  // namespace

Seam measure_seam(const StampImage& image) {
  Seam seam;
  bool seen = false;
  for (int c = 0; c < image.channels; ++c) {
    const Channel channel(image, c, false);
    const SeamStep x = seam_step(channel), y = seam_step(Channel(image, c, true));
    const auto [least, greatest] = channel_range(image, c);
    seam.border_spread =
        std::max(seam.border_spread, border_spread(channel, double{greatest} - double{least}));
    seen = seen || is_visible(x) || is_visible(y);
    take_greater(seam.x, x);
    take_greater(seam.y, y);
  }
  seam.verdict = seam.border_spread <= 0.02 ? SeamVerdict::padded
                 : seen                     ? SeamVerdict::does_not_tile
                                            : SeamVerdict::tiles;
  return seam;
}

std::string_view verdict_name(SeamVerdict verdict) {
  switch (verdict) {
    case SeamVerdict::tiles:
      return "tiles";
    case SeamVerdict::does_not_tile:
      return "does not tile";
    default:
      return "padded";
  }
}

}  // namespace burin
