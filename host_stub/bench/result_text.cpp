// Formats the results of a suite as tables with columns of fixed width for the terminal.
#include "bench/result_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace burin {
namespace {

std::size_t name_width(const SuiteResult& result) {
  std::size_t width = 4;
  for (const CaseResult& one : result.cases) width = std::max(width, one.name.size());
  return width;
}

std::string row(const CaseResult& one, std::size_t width) {
  const Percentiles& at = one.event.whole.at;
  return fmt::format("{:<{}} {:9.0f} {:8.3f} {:8.3f} {:8.3f} {:8.3f} {:9.3g} {:7.0f} {:6.2f}  {}\n", one.name,
                     width, one.counter("triangles"), at.p50, at.p95, at.p99, at.max, one.vertices_per_second,
                     static_cast<double>(one.memory.ready) / one.counter("vertices"), one.load_seconds,
                     one.hash);
}

std::string stage_row(const CaseResult& one, std::size_t width) {
  std::string text = fmt::format("{:<{}}", one.name, width);
  for (const TimeFigures& stage : one.event.stages) text += fmt::format(" {:8.3f}", stage.mean);
  return text + fmt::format(" {:8.3f} {:8.3f}\n", one.end.whole.mean, one.undo.whole.mean);
}

std::string line(const Scaling& scaling) {
  return fmt::format("{} over {}: exponent {:.3f} +- {:.3f}, target {:.1f} +- {:.2f}: {}\n", scaling.cost,
                     size_name(scaling.axis), scaling.law.exponent, scaling.law.standard_error,
                     target_exponent(scaling.axis), scaling_tolerance,
                     on_target(scaling) ? "on target" : "off target");
}

}  // namespace

std::string result_text(const SuiteResult& result, const std::vector<Scaling>& scalings) {
  const std::size_t width = name_width(result);
  std::string text =
      fmt::format("{:<{}} {:>9} {:>8} {:>8} {:>8} {:>8} {:>9} {:>7} {:>6}  hash\n", "events", width,
                  "triangles", "p50 ms", "p95 ms", "p99 ms", "max ms", "vert./s", "B/vert.", "load s");
  for (const CaseResult& one : result.cases) text += row(one, width);
  text += fmt::format("\n{:<{}}", "mean ms", width);
  for (const std::string_view stage : stage_names) text += fmt::format(" {:>8}", stage);
  text += fmt::format(" {:>8} {:>8}\n", "end", "undo");
  for (const CaseResult& one : result.cases) text += stage_row(one, width);
  if (!scalings.empty()) text += "\n";
  for (const Scaling& scaling : scalings) text += line(scaling);
  return text;
}

}  // namespace burin
