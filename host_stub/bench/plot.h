#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// An axis of a plot. Values beyond its ends are drawn at the ends.
struct Axis {
  std::string label;
  double low = 0, high = 1;  ///< low < high; both above 0 if logarithmic
  bool logarithmic = false;

  double share(double value) const;  ///< 0 at low, 1 at high
  std::vector<double> ticks() const;
};

/// A logarithmic axis that holds all values, which must be positive, with a margin at both ends. It spans at
/// least a decade, so that small differences look small.
Axis logarithmic_axis(std::string label, const std::vector<double>& values);

struct PlotPoint {
  double x, y;
};

/// An SVG plot of curves over two axes. Colours are defined by the page's CSS classes: c0 to c6 for stroke
/// and fill, `grid`, `text`. Texts are escaped.
class Plot {
 public:
  Plot(Axis x, Axis y);

  void line(const std::vector<PlotPoint>& points, std::string_view colour);
  void dashes(const PlotPoint& from, const PlotPoint& to);

  /// Draws a dot with a tooltip.
  void dot(const PlotPoint& at, std::string_view colour, const std::string& title);

  /// Writes a text that starts at a point, a little above it.
  void note(const PlotPoint& at, const std::string& text);

  std::string svg() const;

 private:
  double px(double x) const;
  double py(double y) const;
  std::string grid() const;

  Axis x_, y_;
  std::string marks_;
};

/// The CSS rules that a page with plots needs: the colours c0 to c6 for light and dark, --soft of texts,
/// --grid and --card of the surroundings of plots. The class bN has the colour cN as background.
std::string plot_style();

/// A number in short form: "0.02", "5", "300k", "20M".
std::string short_number(double value);

}  // namespace burin
