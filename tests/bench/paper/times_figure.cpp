#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "arap.h"
#include "figures.h"
#include "stopwatch.h"
#include "support/gentle_stroke.h"

namespace burin::paper {
namespace {

constexpr int arap_iterations = 10;

/// Milliseconds.
struct Timing {
  std::string scene;
  double triangles, chart, dncp, arap_setup, arap_solve;
  double arap() const { return dncp + arap_setup + arap_solve; }
};

/// The best of three runs; finding the region is part of it.
double chart_time(const Subject& subject) {
  StrokeChartBuilder builder(subject.scene->surface);
  double best = 1e300;
  for (int run = 0; run < 3; ++run) {
    Stopwatch watch;
    builder.chart(subject.curve, {subject.radius, Cap::round});
    best = std::min(best, watch.lap());
  }
  return 1000 * best;
}

Timing timed(const Subject& subject) {
  const auto constraints = vertices_near_stroke(subject.region, subject.chart, subject.curve);
  const std::vector<FlatTriangle> triangles = flatten(subject.scene->surface, subject.region);
  SolveTimes conformal, rigid;
  const Parameterization initial = dncp(triangles, subject.region, constraints, conformal);
  arap(triangles, subject.region, constraints, initial, arap_iterations, rigid);
  return {subject.scene->name, static_cast<double>(triangles.size()),
          chart_time(subject), 1000 * (conformal.setup + conformal.solve),
          1000 * rigid.setup,  1000 * rigid.solve};
}

/// The first random stroke of about the wanted length.
SurfaceCurve drawn(const Scene& scene, double radius, std::mt19937& random) {
  constexpr double radii = 6;
  SurfaceCurve longest;
  for (int tries = 0; tries < 40 && longest.length() < 0.8 * radii * radius; ++tries) {
    SurfaceCurve curve = test::gentle_stroke(scene.surface, scene.picker, radius, radii * radius, random);
    if (curve.length() > longest.length()) longest = std::move(curve);
  }
  return longest;
}

std::vector<Timing> timings(const Scenes& scenes, int strokes, double largest_radius) {
  constexpr double smallest_radius = 6, share_of_scale = 0.1;
  std::mt19937 random(13);
  std::vector<Timing> result;
  for (int i = 0; i < strokes; ++i) {
    const Scene& scene = *scenes.all()[static_cast<std::size_t>(i) % scenes.all().size()];
    const double edges = smallest_radius * std::pow(largest_radius / smallest_radius, i / (strokes - 1.));
    const double radius =
        std::min(edges * test::mean_edge(scene.surface), share_of_scale * scene.surface.scale);
    result.push_back(timed(make_subject(scene, drawn(scene, radius, random), radius)));
  }
  std::ranges::sort(result, {}, &Timing::triangles);
  return result;
}

std::vector<double> column(const std::vector<Timing>& timings, auto value) {
  std::vector<double> values;
  for (const Timing& timing : timings) values.push_back(std::invoke(value, timing));
  return values;
}

struct Line {
  std::string name;
  std::vector<double> ms;
};

/// Each line has its name at its middle.
Plot time_plot(const std::vector<double>& triangles, const std::vector<Line>& lines) {
  std::vector<double> all;
  for (const Line& line : lines) all.insert(all.end(), line.ms.begin(), line.ms.end());
  Plot plot(logarithmic_axis("triangles", triangles), logarithmic_axis("milliseconds", all));
  for (std::size_t i = 0; i < lines.size(); ++i) {
    std::vector<PlotPoint> points;
    for (std::size_t k = 0; k < triangles.size(); ++k) points.push_back({triangles[k], lines[i].ms[k]});
    plot.line(points, fmt::format("c{}", i));
    plot.note(points[points.size() / 2], lines[i].name);
  }
  return plot;
}

}  // namespace

void times_figure(Page& page, const Scenes& scenes, int strokes, double largest_radius) {
  const std::vector<Timing> all = timings(scenes, strokes, largest_radius);
  page.heading("Figure 13: times");
  page.paragraph(fmt::format(
      "{} strokes by triangles of their region, milliseconds. Frame propagation (FP) includes finding the "
      "region; DNCP and ARAP ({} iterations from DNCP; its total holds DNCP's time) do not. One thread; "
      "sparse "
      "Cholesky factors by Eigen's SimplicialLDLT.",
      strokes, arap_iterations));
  const auto line = [&](const char* name, auto value) { return Line{name, column(all, value)}; };
  const std::vector<double> triangles = column(all, &Timing::triangles);
  page.plot(time_plot(
      triangles, {line("ARAP", &Timing::arap), line("DNCP", &Timing::dncp), line("FP", &Timing::chart)}));
  page.plot(time_plot(triangles,
                      {line("ARAP: setup", &Timing::arap_setup), line("ARAP: DNCP before", &Timing::dncp),
                       line("ARAP: solve", &Timing::arap_solve)}));
  std::vector<std::vector<std::string>> rows;
  for (const Timing& timing : all) {
    rows.push_back({timing.scene, fmt::format("{:.0f}", timing.triangles),
                    fmt::format("{:.2f}", timing.chart), fmt::format("{:.1f}", timing.dncp),
                    fmt::format("{:.1f}", timing.arap_setup), fmt::format("{:.1f}", timing.arap_solve),
                    fmt::format("{:.1f}", timing.arap()),
                    fmt::format("{:.0f}", timing.arap() / timing.chart)});
  }
  page.table({"mesh", "triangles", "FP", "DNCP", "ARAP setup", "ARAP solve", "ARAP total", "ARAP / FP"},
             rows);
}

}  // namespace burin::paper
