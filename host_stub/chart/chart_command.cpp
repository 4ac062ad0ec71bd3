// The command `burin chart`: computes the chart of one recorded stroke, and writes it as a table or a picture
// or checks it.
#include <burin/base/file.h>
#include <burin/chart/stroke_chart_builder.h>
#include <burin/stroke/curve/stroke_trace.h>
#include <burin/stroke/move_origin.h>
#include <burin/stroke/sample_times.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <tuple>

#include "chart/chart_check.h"
#include "command.h"
#include "input/mesh_input.h"
#include "input/name_file.h"
#include "input/radius_fit.h"
#include "input/stroke_input.h"
#include "options/axes_option.h"
#include "options/options.h"
#include "options/setting_options.h"
#include "options/view.h"
#include "pictures/checkerboard.h"
#include "pictures/curve_overlay.h"
#include "pictures/render.h"
#include "system/output_file.h"

namespace burin::command {
namespace {

struct ChartCommandOptions {
  std::string strokes, csv, png;
  std::size_t stroke = 1;  // from 1
  GivenSettings settings;
  int order = 2;
  bool check = false;
  MeshOptions mesh;
  AxesOptions axes;
  ViewOptions view;
  bool json = false;
};

const RecordedStroke& chosen_stroke(const ChartCommandOptions& options, const Recording& recording) {
  if (options.stroke <= recording.strokes.size()) return recording.strokes[options.stroke - 1];
  throw FileError(options.strokes,
                  fmt::format("has no stroke {}: it holds {}", options.stroke, recording.strokes.size()));
}

/// The longest piece of the stroke, since a chart has only one arc length t.
SurfaceCurve chosen_curve(const ChartCommandOptions& options, const std::vector<SurfaceCurve>& pieces,
                          Closure closure) {
  if (pieces.empty()) {
    throw FileError(options.strokes, fmt::format("stroke {} does not meet the surface", options.stroke));
  }
  if (pieces.size() > 1) {
    warn(fmt::format("{}: stroke {} leaves the surface: took the longest of its {} pieces", options.strokes,
                     options.stroke, pieces.size()));
  }
  if (closure == Closure::closed && (pieces.size() > 1 || !pieces[0].closed)) {
    warn(fmt::format("{}: stroke {} stays open: it leaves the surface on the way or is too short",
                     options.strokes, options.stroke));
  }
  return *std::max_element(pieces.begin(), pieces.end(), [](const SurfaceCurve& a, const SurfaceCurve& b) {
    return a.length() < b.length();
  });
}

/// Pairs of a vertex of the file and a node of the surface's vertex that it became, sorted by vertex and
/// sheet.
std::vector<std::pair<Index, std::size_t>> nodes_by_vertex(const LoadedSurface& loaded, const Chart& chart) {
  const Surface& surface = loaded.surface;
  std::vector<std::vector<Index>> of_joined(loaded.from.joined > 0 ? surface.vertex_count() : 0);
  for (Index vertex = 0; vertex < loaded.from.vertex_of.size(); ++vertex)
    of_joined[loaded.from.vertex_of[vertex]].push_back(vertex);
  std::vector<std::pair<Index, std::size_t>> nodes;
  for (std::size_t node = 0; node < chart.size(); ++node) {
    const Index source = surface.source_vertex[chart.vertex[node]];
    if (loaded.from.vertex_of.empty()) {
      nodes.emplace_back(source, node);
    } else {
      for (const Index vertex : of_joined[source]) nodes.emplace_back(vertex, node);
    }
  }
  std::ranges::sort(
      nodes, {}, [&](const auto& row) { return std::tuple(row.first, chart.sheet[row.second], row.second); });
  return nodes;
}

/// Writes one row per node and vertex of the file, with the fewest digits that read back as the same bits.
void write_csv(const std::string& path, const LoadedSurface& loaded, const Chart& chart) {
  write_file_whole(path, [&](std::ostream& out) {
    std::string line = "vertex,sheet,t,d,e1x,e1y,e1z\n";
    for (const auto& [vertex, node] : nodes_by_vertex(loaded, chart)) {
      out << line;
      const Vec3f& e1 = chart.e1[node];
      line.clear();
      fmt::format_to(std::back_inserter(line), "{},{},{},{},{},{},{}\n", vertex, chart.sheet[node],
                     chart.t[node], chart.d[node], e1.x(), e1.y(), e1.z());
    }
    out << line;
  });
}

Picture draw_chart(const Surface& surface, const Picker& picker, const SurfaceCurve& curve,
                   const Chart& chart, double radius, const Camera& camera) {
  Checkerboard checkerboard(surface);
  checkerboard.add(chart, radius);
  ProgressBar bar;
  Picture picture = render(surface, picker, camera, checkerboard, bar.progress());
  draw_curve(picture, camera, picker, curve, radius);  // the depth of a radius shows the curve below bumps
  return picture;
}

Json check_json(const ChartCheck& check) {
  Json json = {{"under_pen", check.under_pen}, {"holes", check.holes}, {"distances", nullptr}};
  if (const auto& d = check.distances)
    json["distances"] = {{"surface", d->sphere ? "sphere" : "plane"},
                         {"mean_percent", 100 * d->mean},
                         {"worst_percent", 100 * d->worst},
                         {"off_by_2_percent", d->off_2},
                         {"off_by_10_percent", d->off_10}};
  return json;
}

std::string check_text(const ChartCheck& check) {
  std::string text =
      fmt::format("{} vertices under the pen, {} of them without a node\n", check.under_pen, check.holes);
  if (const auto& d = check.distances)
    text += fmt::format(
        "distances on the {}: off by {:.3g} % of the radius in the mean, {:.3g} % at most, {} by over 2 %, "
        "{} by "
        "over 10 %\n",
        d->sphere ? "sphere" : "plane", 100 * d->mean, 100 * d->worst, d->off_2, d->off_10);
  return text;
}

void print_result(const ChartCommandOptions& options, const LoadedSurface& loaded, const SurfaceCurve& curve,
                  const Chart& chart, double radius, const std::optional<ChartCheck>& check) {
  const Index sheets = chart.size() == 0 ? 0 : std::ranges::max(chart.sheet) + 1;
  if (options.json) {
    Json json = {{"mesh", mesh_json(options.mesh, loaded)},
                 {"stroke", options.stroke},
                 {"radius", radius},
                 {"length", curve.length()},
                 {"closed", chart.closed},
                 {"vertices", std::ranges::count(chart.sheet, 0u)},
                 {"nodes", chart.size()},
                 {"sheets", sheets}};
    if (check) json["check"] = check_json(*check);
    write_result(json_text(json));
  } else {
    write_result(
        fmt::format("{}\nstroke {} of {}: length {:.6g}, radius {:.6g}, chart of {} vertices in {}\n",
                    mesh_text(options.mesh, loaded), options.stroke, options.strokes, curve.length(), radius,
                    std::ranges::count(chart.sheet, 0u),
                    sheets == 1 ? std::string("one sheet") : fmt::format("up to {} sheets", sheets)) +
        (check ? check_text(*check) : ""));
  }
}

void run(const ChartCommandOptions& options) {
  check_output_path(options.csv);
  check_output_path(options.png);
  Recording recording = read_whole_strokes(options.strokes);
  turn(recording, turn_of_strokes(options.axes, options.mesh.path));
  repair_times(recording);
  const RecordedStroke& stroke = chosen_stroke(options, recording);
  const ReplaySettings settings =
      settings_to_trace(options.strokes, stroke, options.stroke - 1, options.settings);
  const TraceOptions trace = trace_options(settings, stroke.fields, options.stroke - 1);
  const double radius = settings.radius;
  const LoadedSurface loaded = load_mesh_or_points_on_console(options.mesh);
  move_origin(recording, loaded.from.origin);
  if (loaded.surface.is_point_set() && !options.png.empty()) {
    throw FileError(options.mesh.path, "holds points without faces, which --png cannot draw");
  }
  if (loaded.surface.is_point_set() && options.check)
    throw FileError(options.mesh.path, "holds points without faces, which --check cannot measure");
  warn_of_small_radii(options.mesh.path, loaded.surface, {radius});
  warn_of_great_radii(options.mesh.path, loaded.surface, {radius});
  const Picker picker(loaded.surface);
  const ChartOptions how{.radius = radius,
                         .cap = settings.cap,
                         .order = options.order,
                         .join = settings.join,
                         .follow = settings.follow};
  const SurfaceLevels levels(loaded.surface);
  StrokeChartBuilder builder(loaded.surface, &levels);
  builder.begin(how);
  const CurveGround ground(loaded.surface, picker, builder.base());
  const SurfaceCurve curve =
      chosen_curve(options, trace_stroke(ground, recording, stroke, trace), trace.closure);
  const Chart chart = builder.chart(curve, how);
  if (!options.png.empty()) {
    const Camera camera = recorded_view({&recording, 1}, loaded.surface, {&curve, 1}, radius, options.view);
    write_png(options.png, draw_chart(loaded.surface, picker, curve, chart, radius, camera));
  }
  if (!options.csv.empty()) write_csv(options.csv, loaded, chart);
  std::optional<ChartCheck> check;
  if (options.check) check = check_chart(loaded.surface, picker, curve, chart, radius, settings.join);
  print_result(options, loaded, curve, chart, radius, check);
}

}  // namespace

void add_chart(CLI::App& app) {
  const auto options = std::make_shared<ChartCommandOptions>();
  CLI::App& command = *app.add_subcommand("chart", "compute the coordinates (t, d) around a recorded stroke");
  command.add_option("stroke_file", options->strokes, "recorded strokes")
      ->required()
      ->type_name("FILE.stroke");
  command.add_option("--stroke", options->stroke, "which stroke of the file, from 1")
      ->check(whole_number_from_1())
      ->capture_default_str();
  add_mesh_options(command, options->mesh);
  add_drawing_axes_options(command, options->axes);
  command.get_option("--mesh")->description(
      "surface, cage or point set (PLY without faces, with nx, ny, nz)");
  add_view_options(command, options->view);
  constexpr std::string_view keys[] = {"radius", "cap", "join", "closed", "pressure_width", "follow"};
  add_setting_options(command, options->settings, keys);
  choose(command.add_option("--order", options->order,
                            "of the chart: 1, as published, or 2, on curved strokes and surfaces"),
         {"1", "2"})
      ->capture_default_str();
  command.add_option("--csv", options->csv, "table to write")->type_name("FILE");
  command.add_option("--png", options->png, "picture to write: a checkerboard of (t, d)")->type_name("FILE");
  command.add_flag("--check", options->check,
                   "tell how many vertices under the pen have no coordinates, and for joins round and "
                   "overlap on planes and spheres how far distances are off; for round ends");
  command.add_flag("--json", options->json, "write JSON to the standard output");
  command.callback([options] {
    const ReplaySettings settings = options->settings.complete();
    if (options->check && settings.cap != Cap::round)
      throw CLI::ValidationError("--check", "needs round ends: --cap round");
    run(*options);
  });
}

}  // namespace burin::command
