#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// A direction of a plot and what it shows. Values beyond its ends are drawn at them.
struct Axis {
  std::string label;
  double low = 0, high = 1;  ///< low < high, above 0 if logarithmic
  bool logarithmic = false;

  double share(double value) const;  ///< 0 at low, 1 at high
  std::vector<double> ticks() const;
};

/// The axis that holds all values, which are positive, with some room at both ends. It spans a decade at
/// least, so that small differences look small.
Axis logarithmic_axis(std::string label, const std::vector<double>& values);

struct PlotPoint {
  double x, y;
};

/// An SVG drawing of curves over two axes. Colours come from the page by class: c0 to c6 for stroke and
/// fill, `grid`, `text`. Texts are escaped.
class Plot {
 public:
  Plot(Axis x, Axis y);

  void line(const std::vector<PlotPoint>& points, std::string_view colour);
  void dashes(const PlotPoint& from, const PlotPoint& to);

  /// With its tooltip.
  void dot(const PlotPoint& at, std::string_view colour, const std::string& title);

  /// A text that begins at a place, a little above it.
  void note(const PlotPoint& at, const std::string& text);

  std::string svg() const;

 private:
  double px(double x) const;
  double py(double y) const;
  std::string grid() const;

  Axis x_, y_;
  std::string marks_;
};

/// "0.02", "5", "300k", "20M".
std::string short_number(double value);

}  // namespace burin
