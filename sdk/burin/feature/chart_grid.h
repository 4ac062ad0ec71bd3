#pragma once
#include <burin/base/vector.h>

#include <cstddef>
#include <vector>

namespace burin {

/// The pixels of an image over the (t, d) plane of a chart, nearly square. Places in the image are given in
/// pixels: (x, y) is `x` columns along t and `y` rows along d from the centre of the first pixel. Columns
/// before t = 0 and after the stroke's end, `margin` on either side, repeat the other end of a closed stroke.
struct ChartGrid {
  double step_t = 1, step_d = 1;  ///< size of a pixel, object units
  int columns = 0, rows = 0;      ///< rows: an odd number; the one in the middle is the stroke, d = 0
  int margin = 0;                 ///< columns
  bool closed = false;

  double t(double x) const { return (x - margin) * step_t; }        ///< arc length at x, object units
  double d(double y) const { return (y - stroke_row()) * step_d; }  ///< distance at y, object units
  double x(double t) const { return t / step_t + margin; }          ///< place of an arc length, pixels
  double y(double d) const { return d / step_d + stroke_row(); }    ///< place of a distance, pixels
  int stroke_row() const { return (rows - 1) / 2; }                 ///< of d = 0
  int inner_columns() const { return columns - 2 * margin; }        ///< from t = 0 to the end
  /// Number of pixels.
  std::size_t size() const { return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows); }
  /// Index of a pixel in an image; columns are contiguous.
  std::size_t pixel(int column, int row) const {
    return static_cast<std::size_t>(column) * static_cast<std::size_t>(rows) + static_cast<std::size_t>(row);
  }
};

/// A function of a surface over the (t, d) plane of a chart.
struct LevelImage {
  ChartGrid grid;
  std::vector<float> values;  ///< [pixel]; NaN where the function is not known

  /// The value of a pixel.
  float at(int column, int row) const { return values[grid.pixel(column, row)]; }
};

/// The grid for a stroke of this length with pixels of about `step` that reaches `radius` to either side, and
/// `margin` beyond the ends; all in object units, above 0.
ChartGrid chart_grid(double length, bool closed, double radius, double step, double margin);

}  // namespace burin
