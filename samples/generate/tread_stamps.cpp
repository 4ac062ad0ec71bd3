// Computes the stamps of a tyre's tread.
#include "tread_stamps.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "exr_file.h"
#include "smoothstep.h"

namespace burin::samples {

namespace {

constexpr int tread_size = 128;  // texels each way
constexpr int oversampling = 4;  // each way

// Lengths below are in half widths of the tread; y runs across it from -1 to 1, x along it with period 2.
constexpr double slope = .06;  // width of the sloping sides of blocks

/// A triangle wave: 0 at integer x, 1 half way between them.
double zigzag(double x) { return 2 * std::abs(x - std::round(x)); }

/// The distance from the middle of slanting lines, of which there are two per period.
double to_line(double x) { return std::abs(x - std::round(x)); }

/// The distance into a block of rubber, negative in the grooves between blocks.
double into_block(double x, double y) {
  const double side = std::abs(y);
  const double round_groove = std::abs(side - .36 - .07 * zigzag(x + (y > 0 ? .5 : 0))) - .065;
  const double sipes = to_line(x + .8 * y) - .05;
  const double lugs = .8 * to_line(x + .7 * side + (y > 0 ? .5 : 0)) - .1;
  const double edge = .96 - side;
  return std::min({round_groove, side < .4 ? sipes : lugs, edge});
}

double tread_height(double x, double y) { return smoothstep(into_block(x, y) / slope); }

/// The share of the height that a border bulging to the right leaves at x, 0..2 within the tile.
double bulging(double x, double y) { return smoothstep((1.75 - x - .9 * y * y) / .3); }

void write_tile(const std::filesystem::path& path, const std::function<double(double x, double y)>& height) {
  std::vector<float> texels;
  for (int row = 0; row < tread_size; ++row)
    for (int column = 0; column < tread_size; ++column) {
      double sum = 0;
      for (int i = 0; i < oversampling * oversampling; ++i) {
        const double u = column + (i % oversampling + .5) / oversampling;
        const double v = row + (i / oversampling + .5) / oversampling;
        sum += height(2 * u / tread_size, 1 - 2 * v / tread_size);
      }
      texels.push_back(static_cast<float>(sum / (oversampling * oversampling)));
    }
  write_exr(path, tread_size, tread_size, {"Y"}, texels);
}

}  // namespace

void write_treads(const std::filesystem::path& folder) {
  write_tile(folder / "tread.exr", tread_height);
  write_tile(folder / "tread_start.exr",
             [](double x, double y) { return tread_height(x, y) * bulging(2 - x, y); });
  write_tile(folder / "tread_end.exr", [](double x, double y) { return tread_height(x, y) * bulging(x, y); });
}

}  // namespace burin::samples
