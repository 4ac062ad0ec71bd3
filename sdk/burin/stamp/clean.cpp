// Fills values that are not finite from the border of the finite region inwards, one ring of texels per
// round. Each texel is visited a constant number of times: O(texels).
#include <burin/stamp/clean.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace burin {
namespace {

class ChannelFill {
 public:
  ChannelFill(StampImage& image, int channel) : image_(image), channel_(channel) {}

  std::size_t run() {
    const std::ptrdiff_t texels = std::ptrdiff_t{image_.width} * image_.height;
    std::vector<std::ptrdiff_t> bad;
    for (std::ptrdiff_t i = 0; i < texels; ++i)
      if (!std::isfinite(value(i))) bad.push_back(i);
    if (std::ssize(bad) == texels)
      for (const std::ptrdiff_t i : bad) value(i) = 0;
    for (std::vector<std::ptrdiff_t> front = with_neighbours(bad); !front.empty();) front = fill(front);
    return bad.size();
  }

 private:
  float& value(std::ptrdiff_t texel) {
    return image_.texels[static_cast<std::size_t>(texel * image_.channels + channel_)];
  }

  template <class Visit>
  void for_each_neighbour(std::ptrdiff_t texel, const Visit& visit) {
    for (std::ptrdiff_t dy = -1; dy <= 1; ++dy)
      for (std::ptrdiff_t dx = -1; dx <= 1; ++dx) {
        const std::ptrdiff_t x = wrapped_index(texel % image_.width + dx, image_.width, image_.wrap_u);
        const std::ptrdiff_t y = wrapped_index(texel / image_.width + dy, image_.height, image_.wrap_v);
        if (x != no_texel && y != no_texel) visit(y * image_.width + x);
      }
  }

  /// The bad texels that have finite neighbours.
  std::vector<std::ptrdiff_t> with_neighbours(const std::vector<std::ptrdiff_t>& bad) {
    std::vector<std::ptrdiff_t> front;
    for (const std::ptrdiff_t texel : bad) {
      bool found = false;
      for_each_neighbour(texel, [&](std::ptrdiff_t other) { found = found || std::isfinite(value(other)); });
      if (found) front.push_back(texel);
    }
    return front;
  }

  /// Fills the texels of the front from values that were finite before, and returns the next front.
  std::vector<std::ptrdiff_t> fill(const std::vector<std::ptrdiff_t>& front) {
    std::vector<float> means;
    for (const std::ptrdiff_t texel : front) {
      double sum = 0;
      int count = 0;
      for_each_neighbour(texel, [&](std::ptrdiff_t other) {
        if (!std::isfinite(value(other))) return;
        sum += double{value(other)};
        ++count;
      });
      means.push_back(static_cast<float>(sum / count));
    }
    for (std::size_t i = 0; i < front.size(); ++i) value(front[i]) = means[i];
    std::vector<std::ptrdiff_t> next;
    for (const std::ptrdiff_t texel : front)
      for_each_neighbour(texel, [&](std::ptrdiff_t other) {
        if (!std::isfinite(value(other))) next.push_back(other);
      });
    std::ranges::sort(next);
    next.erase(std::unique(next.begin(), next.end()), next.end());
    return next;
  }

  StampImage& image_;
  int channel_;
};

}  // namespace

std::size_t fill_not_finite(StampImage& image) {
  std::size_t filled = 0;
  for (int channel = 0; channel < image.channels; ++channel) filled += ChannelFill(image, channel).run();
  return filled;
}

}  // namespace burin
