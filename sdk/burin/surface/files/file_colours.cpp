// Collects the colours of vertices until all are known, since only all together tell whether channels range
// to 1 or to 255. Costs O(n).
#include <burin/surface/files/colour_byte.h>
#include <burin/surface/files/file_colours.h>

#include <algorithm>

namespace burin {

void FileColours::add(std::size_t vertex, const Colour& colour) {
  colours_.resize(vertex);
  colours_.emplace_back(colour);
}

void FileColours::add_four(std::size_t vertex, const Colour& numbers) {
  add(vertex, numbers);
  fours_.push_back(vertex);
}

void FileColours::settle_fours() {
  const auto all = [&](std::size_t place, const auto& is) {
    return std::ranges::all_of(fours_, [&](std::size_t vertex) { return is((*colours_[vertex])[place]); });
  };
  const auto is_1 = [](double number) { return number == 1; };
  const bool weighted = all(0, is_1) && !all(3, is_1);
  shares_ = !weighted && !fours_.empty() && all(3, [](double number) { return number <= 1; });
  if (!weighted) return;
  for (const std::size_t vertex : fours_) {
    Colour& colour = *colours_[vertex];
    colour = {colour[1], colour[2], colour[3], covering};
  }
}

void FileColours::give(VertexPaint& paint, std::size_t vertices, std::optional<double> full,
                       UnusedCount& unused) {
  if (colours_.empty()) return;
  settle_fours();
  const auto any = [&](const auto& is) {
    return std::ranges::any_of(colours_, [&](const auto& colour) {
      return colour && std::any_of(colour->begin(), colour->begin() + 3, is);
    });
  };
  const double greatest =
      full.value_or(any([](double channel) { return channel > 1 + colour_rounding; }) ? 255 : 1);
  if (any([&](double channel) {
        return !(channel >= -colour_rounding && channel <= greatest + colour_rounding);
      }))
    return unused.add("colour out of range", "colours out of range", colours_.size());
  paint.colours.assign(vertices, {0, 0, 0, 0});
  for (std::size_t i = 0; i < colours_.size(); ++i)
    for (std::size_t channel = 0; channel < 4 && colours_[i]; ++channel)
      paint.colours[i][channel] =
          colour_byte((*colours_[i])[channel] / (channel == 3 && shares_ ? 1 : greatest));
}

}  // namespace burin
