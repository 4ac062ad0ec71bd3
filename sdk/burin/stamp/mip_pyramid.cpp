// Halves an image again and again by weighted means. O(texels) in all.
#include <burin/base/parallel.h>
#include <burin/stamp/mip_pyramid.h>

#include <algorithm>
#include <utility>

namespace burin {
namespace {

/// A texel of the finer row and its weight in the mean of a coarser texel.
struct Share {
  std::int64_t index;
  double weight;
};

/// The shares of each texel of a row of `to` texels that covers a row of `from` >= `to` texels, rings left
/// out.
std::vector<std::vector<Share>> shares_within(std::int64_t from, std::int64_t to) {
  std::vector<std::vector<Share>> shares(static_cast<std::size_t>(to));
  for (std::int64_t index = 0; index < to; ++index) {
    // In units of 1 / (from * to) of the row a finer texel is `to` wide and a coarser one `from`.
    const std::int64_t begin = index * from, end = begin + from;
    for (std::int64_t i = begin / to; i * to < end; ++i) {
      const std::int64_t covered = std::min((i + 1) * to, end) - std::max(i * to, begin);
      shares[static_cast<std::size_t>(index)].push_back(
          {i, static_cast<double>(covered) / static_cast<double>(from)});
    }
  }
  return shares;
}

/// The shares of each texel of a coarser row, its ring included. The ring is a copy of the ring of the finer
/// row, or of the stamp's border texels if the finer row has no ring.
std::vector<std::vector<Share>> shares(int from, int from_ring, int to, bool ring) {
  std::vector<std::vector<Share>> all = shares_within(from, to);
  for (std::vector<Share>& texel : all)
    for (Share& share : texel) share.index += from_ring;
  if (!ring) return all;
  all.insert(all.begin(), std::vector<Share>{{0, 1.0}});
  all.push_back(std::vector<Share>{{from + 2 * from_ring - 1, 1.0}});
  return all;
}

void average_row(const StampImage& fine, const std::vector<Share>& rows,
                 const std::vector<std::vector<Share>>& columns, float* texel) {
  for (const std::vector<Share>& column : columns)
    for (int channel = 0; channel < fine.channels; ++channel) {
      double sum = 0;
      for (const Share& y : rows)
        for (const Share& x : column) {
          const std::int64_t at = (y.index * fine.width + x.index) * fine.channels + channel;
          sum += y.weight * x.weight * double{fine.texels[static_cast<std::size_t>(at)]};
        }
      *texel++ = static_cast<float>(sum);
    }
}

MipLevel halved(const MipLevel& fine) {
  const bool ring_u = fine.image.wrap_u == Wrap::clamp, ring_v = fine.image.wrap_v == Wrap::clamp;
  const auto columns = shares(fine.width(), fine.ring_u, std::max(fine.width() / 2, 1), ring_u);
  const auto rows = shares(fine.height(), fine.ring_v, std::max(fine.height() / 2, 1), ring_v);
  StampImage image{.width = static_cast<int>(columns.size()),
                   .height = static_cast<int>(rows.size()),
                   .channels = fine.image.channels,
                   .texels = {},
                   .wrap_u = fine.image.wrap_u,
                   .wrap_v = fine.image.wrap_v};
  const std::size_t row_size = columns.size() * static_cast<std::size_t>(image.channels);
  image.texels.resize(row_size * rows.size());
  parallel_blocks(rows.size(), 32, [&](std::size_t begin, std::size_t end) {
    for (std::size_t y = begin; y < end; ++y)
      average_row(fine.image, rows[y], columns, image.texels.data() + y * row_size);
  });
  return {std::move(image), ring_u, ring_v};
}

}  // namespace

MipPyramid make_mip_pyramid(StampImage stamp) {
  MipPyramid pyramid;
  pyramid.levels.push_back({std::move(stamp)});
  while (pyramid.levels.back().width() > 1 || pyramid.levels.back().height() > 1)
    pyramid.levels.push_back(halved(pyramid.levels.back()));
  return pyramid;
}

}  // namespace burin
