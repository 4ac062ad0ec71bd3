// Computes the shares of a vertex's sheets. Sheets are stacked by the operator `over` [Porter and Duff 1984]
// with their weights as opacities, and the shares are divided by their sum.
#include <burin/deform/blend/sheet_shares.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <tuple>

namespace burin {
namespace {

/// Share of the half width over which sheets fade in.
constexpr double feather = 0.75;

/// The smallest weight of a sheet, so that the sum of weights is never 0.
constexpr double least = 1e-12;

double smooth_step(double x) {
  x = std::clamp(x, 0.0, 1.0);
  return x * x * (3 - 2 * x);
}

double weight(const Sheet& sheet) { return std::max(smooth_step(sheet.inside / feather), least); }

void normalise(Shares& shares) {
  const double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
  for (double& share : shares) share /= sum;
}

/// Sets the shares of these sheets, the first on top, as if there were no other sheets.
void stack(std::span<const Sheet> sheets, std::span<const std::size_t> order, Shares& shares) {
  double left = 1, sum = 0;
  for (const std::size_t i : order) {
    shares[i] = left * weight(sheets[i]);
    left -= shares[i];
    sum += shares[i];
  }
  for (const std::size_t i : order) shares[i] /= sum;
}

std::vector<std::size_t> indices_below(std::size_t count) {
  std::vector<std::size_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), std::size_t{0});
  return numbers;
}

}  // namespace

Shares mean_shares(std::span<const Sheet> sheets) {
  Shares shares;
  for (const Sheet& sheet : sheets) shares.push_back(weight(sheet));
  normalise(shares);
  return shares;
}

Shares stacked_shares(std::span<const Sheet> sheets, std::span<const double> keys) {
  std::vector<std::size_t> order = indices_below(sheets.size());
  std::ranges::stable_sort(order, std::ranges::greater{}, [&](std::size_t i) { return keys[i]; });
  Shares shares(sheets.size());
  stack(sheets, order, shares);
  return shares;
}

Shares softly_stacked_shares(std::span<const Sheet> sheets, std::span<const double> keys, double soft) {
  Shares shares;
  for (std::size_t i = 0; i < sheets.size(); ++i) {
    double share = weight(sheets[i]);
    for (std::size_t above = 0; above < sheets.size(); ++above)
      if (above != i)
        share *= 1 - weight(sheets[above]) * smooth_step((1 + (keys[above] - keys[i]) / soft) / 2);
    shares.push_back(share);
  }
  normalise(shares);
  return shares;
}

Shares latest_shares(std::span<const Sheet> sheets) {
  std::vector<std::size_t> order = indices_below(sheets.size());
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
    return std::tuple(sheets[a].image, sheets[b].piece, sheets[b].t) <
           std::tuple(sheets[b].image, sheets[a].piece, sheets[a].t);
  });
  Shares shares(sheets.size());
  for (auto first = order.begin(); first != order.end();) {
    const auto last = std::find_if(first, order.end(),
                                   [&](std::size_t i) { return sheets[i].image != sheets[*first].image; });
    const std::span<const std::size_t> of_image(first, last);
    stack(sheets, of_image, shares);
    double near = least;
    for (const std::size_t i : of_image) near += shares[i] * sheets[i].inside * sheets[i].inside;
    for (const std::size_t i : of_image) shares[i] *= near;
    first = last;
  }
  normalise(shares);
  return shares;
}

}  // namespace burin
