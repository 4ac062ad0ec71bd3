// Draws plots of a fixed size as SVG. Ticks are at 1, 2 and 5 times powers of ten on logarithmic axes (the
// powers alone on long ones), and at multiples of such a number on linear axes.
#include "bench/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/html_text.h"

namespace burin {
namespace {

constexpr double width = 380, height = 230;
constexpr double left = 48, right = 14, top = 12, bottom = 42;

/// The ticks of a logarithmic axis: 1, 2 and 5 times powers of ten, or the powers alone on a long axis.
std::vector<double> logarithmic_ticks(double low, double high) {
  const bool powers_alone = high / low > 500;
  std::vector<double> ticks;
  for (double power = std::pow(10, std::floor(std::log10(low))); power <= high; power *= 10) {
    for (const double factor : {1.0, 2.0, 5.0}) {
      const double tick = power * factor;
      if (tick >= low * 0.999 && tick <= high * 1.001 && (factor == 1 || !powers_alone))
        ticks.push_back(tick);
    }
  }
  return ticks;
}

std::vector<double> linear_ticks(double low, double high) {
  const double power = std::pow(10, std::floor(std::log10((high - low) / 3)));
  double step = power;
  for (const double factor : {2.0, 5.0, 10.0})
    if ((high - low) / step > 6) step = power * factor;
  std::vector<double> ticks;
  for (double tick = std::ceil(low / step) * step; tick <= high + step / 1e3; tick += step)
    ticks.push_back(tick);
  return ticks;
}

}  // namespace

double Axis::share(double value) const {
  const double inside = std::clamp(value, low, high);
  return logarithmic ? std::log(inside / low) / std::log(high / low) : (inside - low) / (high - low);
}

std::vector<double> Axis::ticks() const {
  return logarithmic ? logarithmic_ticks(low, high) : linear_ticks(low, high);
}

Axis logarithmic_axis(std::string label, const std::vector<double>& values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const double room = std::max(1.3, std::sqrt(10 / (*high / *low)));
  return {std::move(label), *low / room, *high * room, true};
}

std::string plot_style() {
  std::string css = R"(
:root{color-scheme:light dark;--soft:#6b6a65;--grid:#e6e5e0;--card:#fff;
--c0:#2a78d6;--c1:#1baf7a;--c2:#eda100;--c3:#008300;--c4:#4a3aa7;--c5:#e34948;--c6:#e87ba4}
@media(prefers-color-scheme:dark){:root{--soft:#a3a29b;--grid:#3a3936;--card:#232322;
--c0:#3987e5;--c1:#199e70;--c2:#c98500;--c3:#4a9a3f;--c4:#9085e9;--c5:#e66767;--c6:#d55181}}
svg text{font:11px system-ui,sans-serif;fill:var(--soft)}
.grid{stroke:var(--grid)}.line{fill:none;stroke-width:2;stroke-linejoin:round}
.dashes{stroke:var(--soft);stroke-dasharray:4 4}.dot{stroke:var(--card);stroke-width:2}
)";
  for (int i = 0; i < 7; ++i)
    css += fmt::format(
        ".c{0}{{fill:var(--c{0});stroke:var(--c{0})}}rect.c{0}{{stroke:none}}"
        ".line.c{0}{{fill:none}}.dot.c{0}{{stroke:var(--card)}}.b{0}{{background:var(--c{0})}}\n",
        i);
  return css;
}

std::string short_number(double value) {
  if (value >= 1e6) return fmt::format("{:g}M", value / 1e6);
  if (value >= 1e3) return fmt::format("{:g}k", value / 1e3);
  return fmt::format("{:.4g}", value);
}

Plot::Plot(Axis x, Axis y) : x_(std::move(x)), y_(std::move(y)) {}

double Plot::px(double x) const { return left + x_.share(x) * (width - left - right); }
double Plot::py(double y) const { return height - bottom - y_.share(y) * (height - top - bottom); }

void Plot::line(const std::vector<PlotPoint>& points, std::string_view colour) {
  std::string path;
  for (const PlotPoint& point : points) path += fmt::format(" {:.1f},{:.1f}", px(point.x), py(point.y));
  marks_ += fmt::format("<polyline class='line {}' points='{}'/>\n", colour, path);
}

void Plot::dashes(const PlotPoint& from, const PlotPoint& to) {
  marks_ += fmt::format("<line class='dashes' x1='{:.1f}' y1='{:.1f}' x2='{:.1f}' y2='{:.1f}'/>\n",
                        px(from.x), py(from.y), px(to.x), py(to.y));
}

void Plot::dot(const PlotPoint& at, std::string_view colour, const std::string& title) {
  marks_ += fmt::format("<circle class='dot {}' cx='{:.1f}' cy='{:.1f}' r='4.5'><title>{}</title></circle>\n",
                        colour, px(at.x), py(at.y), escaped(title));
}

void Plot::note(const PlotPoint& at, const std::string& text) {
  marks_ += fmt::format("<text x='{:.1f}' y='{:.1f}'>{}</text>\n", px(at.x) + 5, py(at.y) - 5, escaped(text));
}

std::string Plot::grid() const {
  std::string svg;
  for (const double tick : x_.ticks()) {
    svg += fmt::format("<line class='grid' x1='{0:.1f}' y1='{1}' x2='{0:.1f}' y2='{2}'/>", px(tick), top,
                       height - bottom);
    svg += fmt::format("<text text-anchor='middle' x='{:.1f}' y='{}'>{}</text>\n", px(tick),
                       height - bottom + 15, short_number(tick));
  }
  for (const double tick : y_.ticks()) {
    svg += fmt::format("<line class='grid' x1='{1}' y1='{0:.1f}' x2='{2}' y2='{0:.1f}'/>", py(tick), left,
                       width - right);
    svg += fmt::format("<text text-anchor='end' x='{}' y='{:.1f}'>{}</text>\n", left - 6, py(tick) + 4,
                       short_number(tick));
  }
  svg += fmt::format("<text text-anchor='middle' x='{}' y='{}'>{}</text>\n", (left + width - right) / 2,
                     height - 8, escaped(x_.label));
  svg += fmt::format("<text text-anchor='middle' transform='translate(12 {}) rotate(-90)'>{}</text>\n",
                     (top + height - bottom) / 2, escaped(y_.label));
  return svg;
}

std::string Plot::svg() const {
  return fmt::format("<svg viewBox='0 0 {} {}' role='img'>\n{}{}</svg>\n", width, height, grid(), marks_);
}

}  // namespace burin
