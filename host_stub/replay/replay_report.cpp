// Writes the report of a replay: pictures, figures as JSON, and a page that shows them with a histogram of
// latencies.
#include "replay/replay_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <nlohmann/json.hpp>

#include "report/html_text.h"
#include "report/report_folder.h"

namespace burin {
namespace fs = std::filesystem;

namespace {

constexpr double bins_per_decade = 8;

/// The number of latencies in each bin of a logarithmic scale from the lowest to the highest.
std::vector<std::size_t> histogram(const std::vector<double>& sorted) {
  const auto bin = [&](double seconds) {
    return static_cast<std::size_t>(bins_per_decade *
                                    std::log10(std::max(seconds, 1e-9) / std::max(sorted[0], 1e-9)));
  };
  std::vector<std::size_t> counts(bin(sorted.back()) + 1);
  for (const double seconds : sorted) ++counts[bin(seconds)];
  return counts;
}

std::string histogram_svg(const std::vector<double>& sorted) {
  if (sorted.empty()) return "";
  const std::vector<std::size_t> counts = histogram(sorted);
  const double most = static_cast<double>(*std::max_element(counts.begin(), counts.end()));
  constexpr double width = 640, height = 140;
  const double step = width / static_cast<double>(counts.size());
  std::string svg = fmt::format("<svg width='{}' height='{}' role='img'>\n", width, height + 20);
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const double bar = height * static_cast<double>(counts[i]) / most;
    svg += fmt::format(
        "<rect x='{:.1f}' y='{:.1f}' width='{:.1f}' height='{:.1f}'><title>{} events</title></rect>\n",
        step * static_cast<double>(i), height - bar, 0.9 * step, bar, counts[i]);
  }
  svg += fmt::format(
      "<text x='0' y='{0}'>{1:.2f} ms</text><text x='{2}' y='{0}' text-anchor='end'>{3:.2f} ms</text>",
      height + 16, 1e3 * sorted.front(), width, 1e3 * sorted.back());
  return svg + "</svg>\n";
}

std::string page(const ReplaySummary& summary) {
  std::string html =
      "<!doctype html>\n<html lang='en'><meta charset='utf-8'><title>burin replay</title>\n"
      "<style>body{font:15px sans-serif;margin:2em auto;max-width:64em}img{max-width:100%}"
      "rect{fill:#a0583a}text{font-size:12px}figure{margin:1em 0}</style>\n<h1>burin replay</h1>\n";
  for (const std::string& file : summary.files) html += fmt::format("<p>{}</p>\n", escaped(file));
  html += fmt::format("<pre>{}</pre>\n<h2>Latency of events</h2>\n{}", summary_text(summary),
                      histogram_svg(summary.result.latencies));
  for (const char* name : {"before", "after", "chart"}) {
    html += fmt::format("<figure><img src='{0}.png' alt='{0}'><figcaption>{0}</figcaption></figure>\n", name);
  }
  return html + "</html>\n";
}

}  // namespace

void write_report(const std::string& folder, const ReplaySummary& summary, const Json& json,
                  const ReplayPictures& pictures) {
  make_report_folder(folder);
  const fs::path root = folder;
  write_png(root / "before.png", pictures.before);
  write_png(root / "after.png", pictures.after);
  write_png(root / "chart.png", pictures.chart);
  write_text(root / "report.json", json_text(json));
  write_text(root / "index.html", page(summary));
}

}  // namespace burin
