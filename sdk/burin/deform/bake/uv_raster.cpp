// Rasterises triangles in texture space, band of rows by band, on all threads. Costs O(texels of the
// triangles' bounding boxes). The lowest triangle wins a texel, so the result does not depend on threads.
#include <burin/base/counting_sort.h>
#include <burin/deform/bake/uv_raster.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace burin {
namespace {

constexpr int rows_per_band = 16;

/// The least barycentric coordinate of a texel's centre that a triangle covers. Centres on a common edge are
/// covered by both triangles, so that there is no gap.
constexpr double least_share_inside = -1e-9;
/// The least barycentric coordinate of a centre that counts as an overlap; smaller overlaps may come from the
/// rounding of coordinates in files.
constexpr double least_share_deep_inside = 1e-3;

double cross(const Vec2d& a, const Vec2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// The range, first and one past the last, of the texels along an axis whose centres may lie in [low, high].
std::pair<int, int> texels_between(double low, double high, int size) {
  const auto within = [&](double texel) { return static_cast<int>(std::clamp<double>(texel, 0, size)); };
  return {within(std::floor(low * size - 0.5)), within(std::floor(high * size - 0.5) + 2)};
}

std::pair<int, int> columns(const TriangleUv& t, int size) {
  const auto [low, high] = std::minmax({t[0].x(), t[1].x(), t[2].x()});
  return texels_between(low, high, size);
}

std::pair<int, int> rows(const TriangleUv& t, int size) {
  const auto [low, high] = std::minmax({t[0].y(), t[1].y(), t[2].y()});
  return texels_between(1 - double{high}, 1 - double{low}, size);
}

/// For each band of rows, the triangles that intersect it, ascending.
struct Bands {
  std::vector<Index> offsets, triangles;
};

Bands sort_into_bands(std::span<const TriangleUv> triangles, int size) {
  const auto each_band = [&](std::size_t i, const auto& visit) {
    const auto [begin, end] = rows(triangles[i], size);
    if (begin >= end) return;
    for (int band = begin / rows_per_band; band <= (end - 1) / rows_per_band; ++band)
      visit(static_cast<std::size_t>(band));
  };
  std::size_t entries = 0;
  for (std::size_t i = 0; i < triangles.size(); ++i) each_band(i, [&](std::size_t) { ++entries; });
  Bands bands;
  bands.triangles.resize(entries);
  const auto count = static_cast<std::size_t>((size + rows_per_band - 1) / rows_per_band);
  bands.offsets = counting_sort(triangles.size(), count, each_band, [&](std::size_t i, std::size_t position) {
    bands.triangles[position] = static_cast<Index>(i);
  });
  return bands;
}

/// Fills one band of the image, triangle by triangle.
class BandFiller {
 public:
  BandFiller(std::span<const TriangleUv> triangles, UvRaster& raster, int first_row)
      : triangles_(triangles),
        raster_(raster),
        first_row_(first_row),
        end_row_(std::min(first_row + rows_per_band, raster.size)),
        overlaps_(static_cast<std::size_t>(rows_per_band) * static_cast<std::size_t>(raster.size)) {}

  void fill(Index triangle) {
    const TriangleUv& uv = triangles_[triangle];
    const auto [first_column, end_column] = columns(uv, raster_.size);
    const auto [first_row, end_row] = rows(uv, raster_.size);
    for (int row = std::max(first_row, first_row_); row < std::min(end_row, end_row_); ++row)
      for (int column = first_column; column < end_column; ++column) fill_texel(triangle, row, column);
  }

  std::size_t overlaps() const {
    return static_cast<std::size_t>(std::count(overlaps_.begin(), overlaps_.end(), true));
  }

 private:
  void fill_texel(Index triangle, int row, int column) {
    const auto size = static_cast<std::size_t>(raster_.size);
    const std::size_t texel = static_cast<std::size_t>(row) * size + static_cast<std::size_t>(column);
    const double share = least_share(triangle, texel);
    if (!(share >= least_share_inside)) return;
    Index& owner = raster_.triangle[texel];
    if (owner == no_index) {
      owner = triangle;
    } else if (share > least_share_deep_inside && least_share(owner, texel) > least_share_deep_inside) {
      overlaps_[texel - static_cast<std::size_t>(first_row_) * size] = true;
    }
  }

  double least_share(Index triangle, std::size_t texel) const {
    return barycentric(triangles_[triangle], raster_.centre(texel)).minCoeff<Eigen::PropagateNaN>();
  }

  std::span<const TriangleUv> triangles_;
  UvRaster& raster_;
  int first_row_, end_row_;
  std::vector<bool> overlaps_;  ///< [texel of the band]
};

}  // namespace

Vec2d UvRaster::centre(std::size_t texel) const {
  const auto side = static_cast<std::size_t>(size);
  const double column = static_cast<double>(texel % side), row = static_cast<double>(texel / side);
  return {(column + 0.5) / size, 1 - (row + 0.5) / size};
}

Vec3d barycentric(const TriangleUv& triangle, const Vec2d& point) {
  const Vec2d origin = triangle[0].cast<double>();
  const Vec2d along = triangle[1].cast<double>() - origin, across = triangle[2].cast<double>() - origin;
  const double area = cross(along, across);
  const double second = cross(point - origin, across) / area, third = cross(along, point - origin) / area;
  return {1 - second - third, second, third};
}

UvRaster rasterise(std::span<const TriangleUv> triangles, int size) {
  UvRaster raster;
  raster.size = size;
  raster.triangle.assign(static_cast<std::size_t>(size) * static_cast<std::size_t>(size), no_index);
  const Bands bands = sort_into_bands(triangles, size);
  std::vector<std::size_t> overlaps(bands.offsets.size() - 1);
  parallel_blocks(overlaps.size(), 1, [&](std::size_t band, std::size_t) {
    BandFiller filler(triangles, raster, static_cast<int>(band) * rows_per_band);
    for (Index i = bands.offsets[band]; i < bands.offsets[band + 1]; ++i) filler.fill(bands.triangles[i]);
    overlaps[band] = filler.overlaps();
  });
  for (const std::size_t count : overlaps) raster.overlaps += count;
  return raster;
}

}  // namespace burin
