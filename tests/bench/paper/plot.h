#pragma once
#include <string>
#include <vector>

namespace burin::paper {

struct PlotLine {
  std::string name, colour;
  std::vector<double> x, y;  ///< above 0
};

/// Lines over two logarithmic axes as inline SVG.
std::string log_plot(const std::string& x_title, const std::string& y_title,
                     const std::vector<PlotLine>& lines);

}  // namespace burin::paper
