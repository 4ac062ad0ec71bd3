// Pads islands round by round, on all threads. Costs O(texels) per round.
#include <burin/base/parallel.h>
#include <burin/deform/bake/pad_islands.h>

#include <array>
#include <utility>

namespace burin {
namespace {

constexpr std::size_t rows_per_block = 32;

/// One round of padding: computes values for unknown texels from the texels known at the start of the round.
class PaddingRound {
 public:
  PaddingRound(FloatImage& image, const std::vector<std::uint8_t>& known) : image_(image), known_(known) {}

  /// Sets a texel by linear extrapolation along lines. Returns false, and leaves it 0, if no two texels in a
  /// line are known.
  bool continue_lines(int column, int row) {
    return set_to_mean(column, row, [&](int dx, int dy, const auto& add) {
      const float* next = known(column + dx, row + dy);
      const float* after = known(column + 2 * dx, row + 2 * dy);
      if (next && after) add([=](std::size_t channel) { return 2 * next[channel] - after[channel]; });
    });
  }

  /// Sets a texel to the mean of its neighbours. Returns false, and leaves it 0, if no neighbour is known.
  bool spread(int column, int row) {
    return set_to_mean(column, row, [&](int dx, int dy, const auto& add) {
      const float* next = known(column + dx, row + dy);
      if (next) add([=](std::size_t channel) { return next[channel]; });
    });
  }

 private:
  std::size_t texel(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(image_.width) +
           static_cast<std::size_t>(column);
  }

  float* values(int column, int row) {
    return image_.texels.data() + image_.channels.size() * texel(column, row);
  }

  /// The values of a texel; null if it is unknown or outside the image.
  const float* known(int column, int row) {
    const bool inside = column >= 0 && row >= 0 && column < image_.width && row < image_.height;
    return inside && known_[texel(column, row)] != 0 ? values(column, row) : nullptr;
  }

  /// Sets a texel to the mean of the values that propose(dx, dy, add) adds for the 8 directions.
  template <class Propose>
  bool set_to_mean(int column, int row, const Propose& propose) {
    constexpr std::array<std::pair<int, int>, 8> directions = {
        {{-1, -1}, {0, -1}, {1, -1}, {-1, 0}, {1, 0}, {-1, 1}, {0, 1}, {1, 1}}};
    float* sum = values(column, row);
    float count = 0;
    for (const auto& [dx, dy] : directions)
      propose(dx, dy, [&](const auto& value) {
        for (std::size_t channel = 0; channel < image_.channels.size(); ++channel)
          sum[channel] += value(channel);
        ++count;
      });
    if (count == 0) return false;
    for (std::size_t channel = 0; channel < image_.channels.size(); ++channel) sum[channel] /= count;
    return true;
  }

  FloatImage& image_;
  const std::vector<std::uint8_t>& known_;
};

}  // namespace

void pad_islands(FloatImage& image, std::vector<std::uint8_t>& known, int texels) {
  const auto height = static_cast<std::size_t>(image.height), width = static_cast<std::size_t>(image.width);
  std::vector<std::vector<std::size_t>> reached(height / rows_per_block + 1);  // [block]
  for (int round = 0; round < texels; ++round) {
    parallel_blocks(height, rows_per_block, [&](std::size_t begin, std::size_t end) {
      PaddingRound padding(image, known);
      std::vector<std::size_t>& found = reached[begin / rows_per_block];
      found.clear();
      for (std::size_t texel = begin * width; texel < end * width; ++texel) {
        if (known[texel] != 0) continue;
        const auto column = static_cast<int>(texel % width), row = static_cast<int>(texel / width);
        if ((round == 0 && padding.continue_lines(column, row)) || padding.spread(column, row))
          found.push_back(texel);
      }
    });
    for (const std::vector<std::size_t>& found : reached)
      for (const std::size_t texel : found) known[texel] = 1;
  }
}

}  // namespace burin
