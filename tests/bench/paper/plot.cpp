#include "plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "page.h"

namespace burin::paper {
namespace {

constexpr double width = 560, height = 380, left = 70, right = 20, top = 20, bottom = 50;

/// Whole decades around the values, and where a value lies on the page.
struct LogAxis {
  double first = 1e300, last = -1e300;  ///< powers of ten
  double from = 0, to = 0;              ///< pixels

  void include(const std::vector<double>& values) {
    for (const double value : values) {
      first = std::min(first, std::floor(std::log10(value)));
      last = std::max(last, std::ceil(std::log10(value)));
    }
  }
  double at(double value) const {
    return from + (to - from) * (std::log10(value) - first) / std::max(1., last - first);
  }
};

std::string label(double x, double y, const std::string& text, const char* more) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" {}>{}</text>\n", x, y, more, escaped(text));
}

std::string grid_line(double x1, double y1, double x2, double y2) {
  return fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"#ddd\"/>\n", x1,
                     y1, x2, y2);
}

std::string axes(const LogAxis& x, const LogAxis& y) {
  std::string svg;
  for (double power = x.first; power <= x.last; ++power) {
    const double at = x.at(std::pow(10, power));
    svg += grid_line(at, y.from, at, y.to) +
           label(at, y.from + 18, fmt::format("{:g}", std::pow(10, power)), "text-anchor=\"middle\"");
  }
  for (double power = y.first; power <= y.last; ++power) {
    const double at = y.at(std::pow(10, power));
    svg += grid_line(x.from, at, x.to, at) +
           label(x.from - 6, at + 4, fmt::format("{:g}", std::pow(10, power)), "text-anchor=\"end\"");
  }
  return svg;
}

std::string polyline(const PlotLine& line, const LogAxis& x, const LogAxis& y) {
  std::string points;
  for (std::size_t i = 0; i < line.x.size(); ++i)
    points += fmt::format("{:.1f},{:.1f} ", x.at(line.x[i]), y.at(line.y[i]));
  return fmt::format("<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.5\"/>\n", points,
                     line.colour);
}

}  // namespace

std::string log_plot(const std::string& x_title, const std::string& y_title,
                     const std::vector<PlotLine>& lines) {
  LogAxis x, y;
  for (const PlotLine& line : lines) {
    x.include(line.x);
    y.include(line.y);
  }
  x.from = left, x.to = width - right;
  y.from = height - bottom, y.to = top;
  std::string svg =
      fmt::format("<svg width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" font-size=\"12\">\n", width,
                  height) +
      axes(x, y);
  double row = top + 14;
  for (const PlotLine& line : lines) {
    svg += polyline(line, x, y) +
           label(left + 10, row, line.name, fmt::format("fill=\"{}\"", line.colour).c_str());
    row += 16;
  }
  svg += label((left + width) / 2, height - 10, x_title, "text-anchor=\"middle\"");
  svg += label(16, height / 2, y_title,
               fmt::format("text-anchor=\"middle\" transform=\"rotate(-90 16 {})\"", height / 2).c_str());
  return svg + "</svg>\n";
}

}  // namespace burin::paper
