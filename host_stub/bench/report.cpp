// Writes the report of a bench run: result.json, and index.html, one page that contains its tables, plots and
// pictures.
#include "bench/report.h"

#include <burin/base/file.h>
#include <burin/base/text/base64.h>
#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "bench/plot.h"
#include "bench/report_figures.h"
#include "bench/scaling.h"
#include "report/html_text.h"
#include "report/report_folder.h"

namespace burin {
namespace {

constexpr const char* style = R"(
:root{--page:#fcfcfb;--ink:#1d1d1b}
@media(prefers-color-scheme:dark){:root{--page:#1a1a19;--ink:#f3f2ee}}
body{font:15px/1.5 system-ui,sans-serif;margin:2.5em auto;max-width:80em;padding:0 1.5em;background:var(--page);
color:var(--ink)}
h1{font-size:1.6em;margin:0}h2{font-size:1.15em;margin:2.4em 0 .4em}p{color:var(--soft);margin:.3em 0 1em}
.wide{overflow-x:auto}table{border-collapse:collapse;font-size:12px;white-space:nowrap}
th,td{padding:.35em .6em;text-align:right;border-bottom:1px solid var(--grid);font-variant-numeric:tabular-nums}
th{color:var(--soft);font-weight:500}th:first-child,td:first-child{text-align:left;padding-left:0}
td:last-child{font-family:ui-monospace,monospace}
.plots{display:grid;grid-template-columns:repeat(auto-fill,minmax(21em,1fr));gap:1em}
figure{margin:0;background:var(--card);border:1px solid var(--grid);border-radius:6px;padding:.8em}
figcaption{font-weight:600;font-size:13px}img,svg{width:100%;height:auto;display:block}
.legend span{margin-right:1.2em;white-space:nowrap}
.legend i{display:inline-block;width:.8em;height:.8em;border-radius:2px;margin-right:.4em}
)";

std::string table_row(const CaseResult& one) {
  const Percentiles& at = one.event.whole.at;
  std::string html = fmt::format("<tr><td>{}</td>", escaped(one.name));
  for (const double value : {one.counter("triangles"), one.counter("events"), one.counter("region")})
    html += fmt::format("<td>{:.0f}</td>", value);
  for (const double value : {at.p50, at.p95, at.p99, at.max, one.end.whole.mean, one.undo.whole.mean})
    html += fmt::format("<td>{:.3f}</td>", value);
  const double vertices = one.counter("vertices");
  html += fmt::format("<td>{:.3g}</td><td>{:.2f}</td><td>{:.0f}</td><td>{:.0f}</td>", one.vertices_per_second,
                      one.load_seconds, static_cast<double>(one.memory.ready) / vertices,
                      static_cast<double>(one.memory.peak) / vertices);
  return html + fmt::format("<td>{}</td></tr>\n", one.hash);
}

std::string table(const SuiteResult& result) {
  std::string html = "<div class='wide'><table><tr>";
  for (const char* head : {"case", "triangles", "events", "nodes", "p50 ms", "p95 ms", "p99 ms", "max ms",
                           "end ms", "undo ms", "vertices/s", "load s", "B/vertex", "peak B/vertex", "hash"})
    html += fmt::format("<th>{}</th>", head);
  html += "</tr>\n";
  for (const CaseResult& one : result.cases) html += table_row(one);
  return html + "</table></div>\n";
}

std::string section(const char* title, const char* explanation, const std::string& body) {
  return fmt::format("<h2>{}</h2><p>{}</p>\n{}", title, explanation, body);
}

std::string picture_section(const SuiteResult& result) {
  std::string figures;
  for (const CaseResult& one : result.cases) {
    if (one.picture.empty()) continue;
    figures += fmt::format(
        "<figure><figcaption>{0}</figcaption><img alt='{0}' src='data:image/png;base64,{1}'></figure>\n",
        escaped(one.name), base64(read_file(one.picture)));
  }
  if (figures.empty()) return "";
  return section("Results", "The surface with the strokes of each case.",
                 "<div class='plots'>\n" + figures + "</div>\n");
}

std::string scaling_section(const SuiteResult& result) {
  std::string figures;
  for (const Scaling& scaling : scalings(result)) figures += scaling_figure(scaling);
  if (figures.empty()) return "";
  return section(
      "Growth of cost",
      "Cost over size with the power law that fits; stroke: all events and ends, median of the repeats.",
      "<div class='plots'>\n" + figures + "</div>\n");
}

std::string history_section(const std::vector<NamedResult>& results) {
  if (results.size() < 2) return "";
  std::string names;
  std::vector<SuiteResult> all;
  for (const NamedResult& one : results) {
    names += fmt::format("<li>{}</li>", escaped(one.name));
    all.push_back(one.result);
  }
  return section("History", "Events of one result after the other.",
                 "<ol>" + names + "</ol>\n" + history_figures(all));
}

std::string page(const std::vector<NamedResult>& results) {
  const SuiteResult& last = results.back().result;
  return fmt::format(
             "<!doctype html>\n<html lang='en'><meta charset='utf-8'>"
             "<meta name='viewport' content='width=device-width'><title>burin bench: {0}</title>\n"
             "<style>{2}{1}</style>\n<h1>burin bench: {0}</h1>\n<p>An event is one sample of the pen.</p>\n",
             escaped(last.suite), style, plot_style()) +
         table(last) + picture_section(last) +
         section("Latency of events",
                 "How many of a case's events take at most so long; p50, p95, p99 marked.",
                 latency_figures(last)) +
         section("Stages of an event", "Shares of the mean time of an event.",
                 stage_figure(last, &CaseResult::event)) +
         section("Stages of a stroke's end", "Shares of the mean time of the call that ends a stroke.",
                 stage_figure(last, &CaseResult::end)) +
         scaling_section(last) + history_section(results) + "</html>\n";
}

}  // namespace

void write_bench_report(const std::string& folder, const std::vector<NamedResult>& results) {
  make_report_folder(folder);
  const std::filesystem::path root = folder;
  Json json = result_json(results.back().result);
  json["scaling"] = scalings_json(scalings(results.back().result));
  write_text(root / "result.json", json_text(json));
  write_text(root / "index.html", page(results));
}

}  // namespace burin
