// Draws the figures of a bench report as SVG: distributions of latencies, bars of stages, costs over sizes,
// and the history of results.
#include "bench/report_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bench/plot.h"
#include "report/html_text.h"

namespace burin {
namespace {

/// The time between two events of a pen that reports at 240 Hz.
constexpr double pen_interval_ms = 1e3 / 240;

std::string figure(const std::string& caption, const std::string& svg) {
  return fmt::format("<figure><figcaption>{}</figcaption>{}</figure>\n", escaped(caption), svg);
}

/// A time axis from the fastest to the slowest event of all cases.
Axis time_axis(const SuiteResult& result) {
  std::vector<double> times;
  for (const CaseResult& one : result.cases)
    for (const double time : one.distribution) times.push_back(std::max(time, 1e-4));
  if (times.empty()) times = {1};
  return logarithmic_axis("ms", times);
}

std::string latency_figure(const CaseResult& one, const Axis& times) {
  Plot plot(times, {"percent of events", 0, 100});
  if (pen_interval_ms > times.low && pen_interval_ms < times.high) {
    plot.dashes({pen_interval_ms, 0}, {pen_interval_ms, 100});
    plot.note({pen_interval_ms, 0}, "240 Hz");
  }
  std::vector<PlotPoint> points;
  for (std::size_t percent = 0; percent < one.distribution.size(); ++percent)
    points.push_back({one.distribution[percent], static_cast<double>(percent)});
  plot.line(points, "c0");
  const Percentiles& at = one.event.whole.at;
  plot.dot({at.p50, 50}, "c0", fmt::format("p50 {:.3f} ms", at.p50));
  plot.dot({at.p95, 95}, "c0", fmt::format("p95 {:.3f} ms", at.p95));
  plot.dot({at.p99, 99}, "c0", fmt::format("p99 {:.3f} ms", at.p99));
  return figure(one.name, plot.svg());
}

constexpr double bar_width = 560, bar_height = 18, bar_step = 28, bar_left = 220;

std::string stage_bar(const CallFigures& calls, double y) {
  double sum = 0;
  for (const TimeFigures& stage : calls.stages) sum += stage.mean;
  std::string svg;
  double x = bar_left;
  for (std::size_t stage = 0; stage < stage_count && sum > 0; ++stage) {
    const double share = calls.stages[stage].mean / sum;
    svg += fmt::format(
        "<rect class='c{}' x='{:.1f}' y='{:.1f}' width='{:.1f}' height='{}'><title>{}: {:.3f} ms, {:.0f} %"
        "</title></rect>\n",
        stage, x, y, std::max(share * bar_width - 1, 0.0), bar_height, stage_names[stage],
        calls.stages[stage].mean, 100 * share);
    x += share * bar_width;
  }
  return svg + fmt::format("<text x='{}' y='{:.1f}'>{:.3f} ms</text>\n", bar_left + bar_width + 8, y + 13,
                           calls.whole.mean);
}

std::string stage_legend() {
  std::string html = "<p class='legend'>";
  for (std::size_t stage = 0; stage < stage_count; ++stage)
    html += fmt::format("<span><i class='b{}'></i>{}</span>", stage, stage_names[stage]);
  return html + "</p>\n";
}

/// The results that have the case, with their numbers counted from 1.
std::vector<std::pair<double, const CaseResult*>> past_of(const std::string& name,
                                                          const std::vector<SuiteResult>& results) {
  std::vector<std::pair<double, const CaseResult*>> past;
  for (std::size_t i = 0; i < results.size(); ++i) {
    for (const CaseResult& one : results[i].cases)
      if (one.name == name) past.emplace_back(static_cast<double>(i + 1), &one);
  }
  return past;
}

std::string history_figure(const std::string& name, const std::vector<SuiteResult>& results) {
  const auto past = past_of(name, results);
  double most = 1e-6;
  for (const auto& [number, one] : past) most = std::max(most, one->event.whole.at.p95);
  Plot plot({"result", 0.5, static_cast<double>(results.size()) + 0.5}, {"ms", 0, 1.15 * most});
  const auto draw = [&](double Percentiles::*percentile, const char* label, const char* colour) {
    std::vector<PlotPoint> points;
    for (const auto& [number, one] : past) {
      points.push_back({number, one->event.whole.at.*percentile});
      plot.dot(points.back(), colour,
               fmt::format("result {}: {} {:.3f} ms, hash {}", number, label, points.back().y, one->hash));
    }
    plot.line(points, colour);
    plot.note(points.front(), label);
  };
  draw(&Percentiles::p50, "p50", "c0");
  draw(&Percentiles::p95, "p95", "c5");
  return figure(name, plot.svg());
}

}  // namespace

std::string latency_figures(const SuiteResult& result) {
  const Axis times = time_axis(result);
  std::string html;
  for (const CaseResult& one : result.cases) html += latency_figure(one, times);
  return "<div class='plots'>\n" + html + "</div>\n";
}

std::string stage_figure(const SuiteResult& result, CallFigures CaseResult::*calls) {
  std::string svg;
  double y = 0;
  for (const CaseResult& one : result.cases) {
    svg += fmt::format("<text text-anchor='end' x='{}' y='{:.1f}'>{}</text>\n", bar_left - 8, y + 13,
                       escaped(one.name));
    svg += stage_bar(one.*calls, y);
    y += bar_step;
  }
  return fmt::format("{}<svg viewBox='0 0 {} {}' role='img'>\n{}</svg>\n", stage_legend(),
                     bar_left + bar_width + 90, y, svg);
}

std::string scaling_figure(const Scaling& scaling) {
  const std::vector<double>& ms = scaling.costs;
  Plot plot(logarithmic_axis(std::string(size_name(scaling.axis)), scaling.sizes),
            logarithmic_axis("ms, " + scaling.cost, ms));
  const auto [least, most] = std::minmax_element(scaling.sizes.begin(), scaling.sizes.end());
  const auto fitted = [&](double size) {
    return PlotPoint{size, scaling.law.factor * std::pow(size, scaling.law.exponent)};
  };
  plot.dashes(fitted(*least), fitted(*most));
  for (std::size_t i = 0; i < ms.size(); ++i) {
    plot.dot({scaling.sizes[i], ms[i]}, "c0",
             fmt::format("{}: {:.3f} ms over {:.0f}", scaling.cases[i], ms[i], scaling.sizes[i]));
  }
  return figure(fmt::format("{}: exponent {:.3f} ± {:.3f}, target {:.1f} ± {:.2f}: {}", scaling.cost,
                            scaling.law.exponent, scaling.law.standard_error, target_exponent(scaling.axis),
                            scaling_tolerance, on_target(scaling) ? "on target" : "off target"),
                plot.svg());
}

std::string history_figures(const std::vector<SuiteResult>& results) {
  std::string html;
  for (const CaseResult& one : results.back().cases) html += history_figure(one.name, results);
  return "<div class='plots'>\n" + html + "</div>\n";
}

}  // namespace burin
