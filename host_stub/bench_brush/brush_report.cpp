// Writes what `burin bench-brush` measured as JSON, as lines for people and as a page of bars.
#include "bench_brush/brush_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "bench/plot.h"
#include "report/html_text.h"
#include "report/report_folder.h"

namespace burin {
namespace {

std::string interval(const Estimate& estimate) {
  return fmt::format("{:.3g} ({:.3g} to {:.3g})", estimate.value, estimate.low, estimate.high);
}

Json estimate_json(const Estimate& estimate) {
  return {{"low", estimate.low}, {"value", estimate.value}, {"high", estimate.high}};
}

/// One row of bars: the ratio as a bar from 1, its interval as a line.
std::string bar(const std::string& name, const Estimate& ratio, const Axis& axis, std::size_t row) {
  constexpr double left = 220, width = 560, high = 22;
  const auto at = [&](double value) { return left + width * axis.share(value); };
  const double top = high * static_cast<double>(row), from = std::min(at(1), at(ratio.value)),
               to = std::max(at(1), at(ratio.value));
  return fmt::format(
      "<text x='0' y='{:.0f}'>{}</text><rect class='c0' x='{:.1f}' y='{:.0f}' width='{:.1f}' height='14'/>"
      "<line class='grid' x1='{:.1f}' x2='{:.1f}' y1='{:.0f}' y2='{:.0f}'/><text x='{:.0f}' "
      "y='{:.0f}'>{}</text>\n",
      top + 14, escaped(name), from, top + 3, std::max(to - from, 1.0), at(ratio.low), at(ratio.high),
      top + 10, top + 10, left + width + 10, top + 14, escaped(interval(ratio)));
}

std::string bars(const BrushReport& report) {
  std::vector<double> ends = {1};
  for (const auto& [id, ratio] : report.stock) ends.insert(ends.end(), {ratio.low, ratio.high});
  const Axis axis = logarithmic_axis("", ends);
  std::string rows;
  for (std::size_t i = 0; i < report.stock.size(); ++i)
    rows += bar(report.stock[i].id, report.stock[i].ratio, axis, i);
  return fmt::format("<svg viewBox='0 0 960 {}' role='img'>\n{}</svg>\n", 22 * report.stock.size() + 8, rows);
}

std::string section(const BrushReport& report) {
  std::string html =
      fmt::format("<h2>{}</h2>\n<pre>{}</pre>\n", escaped(report.brush.id), escaped(brush_text(report)));
  if (report.stroke)
    html += fmt::format("<figure><img src='{0}.png' alt='{0}'></figure>\n", escaped(report.brush.id));
  return html + "<p>Its time as a multiple of each stock brush's; a bar to the left is faster.</p>\n" +
         bars(report);
}

}  // namespace

std::string brush_text(const BrushReport& report) {
  std::string text = fmt::format("{}\n  times of copying its inputs         {}\n", report.brush.id,
                                 interval(multiple_of(report.brush)));
  if (report.brush.budget > 0)
    text += fmt::format("  budget                              {:.3g}, {}\n", report.brush.budget,
                        report.keeps_budget() ? "kept" : "exceeded");
  if (report.stroke)
    text += fmt::format("  share of an event                   {:.2f}\n", report.stroke->share);
  if (report.against)
    text += fmt::format("  times of the other version          {}\n", interval(*report.against));
  for (const auto& [id, ratio] : report.stock)
    text += fmt::format("  times of {:<26} {}\n", id, interval(ratio));
  return text;
}

Json brush_json(const BrushReport& report) {
  Json json = {{"brush", report.brush.id}, {"copies", estimate_json(multiple_of(report.brush))}};
  if (report.brush.budget > 0) json["budget"] = report.brush.budget;
  if (report.stroke) json["share_of_event"] = report.stroke->share;
  if (report.against) json["against"] = estimate_json(*report.against);
  for (const auto& [id, ratio] : report.stock) json["stock"][id] = estimate_json(ratio);
  return json;
}

void write_brush_page(const std::string& folder, const std::vector<BrushReport>& reports) {
  make_report_folder(folder);
  const std::filesystem::path root = folder;
  std::string html =
      "<!doctype html>\n<html lang='en'><meta charset='utf-8'><title>burin bench-brush</title>\n<style>" +
      plot_style() +
      "body{font:15px sans-serif;margin:2em auto;max-width:64em}img,svg{width:100%}svg text{font-size:13px}"
      "</style>\n<h1>burin bench-brush</h1>\n";
  for (const BrushReport& report : reports) {
    if (report.stroke) write_png(root / (report.brush.id + ".png"), report.stroke->picture);
    html += section(report);
  }
  write_text(root / "index.html", html + "</html>\n");
}

}  // namespace burin
