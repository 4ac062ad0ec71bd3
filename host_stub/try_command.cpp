// The command `burin try`: one stroke of a brush on a small sheet with soft hills, and a picture of it within
// two seconds. The pen presses least at the ends of the stroke.
#include <burin/abi/plugin.h>
#include <burin/host/percentile.h>
#include <burin/host/plugin/brush_params.h>
#include <burin/host/replay.h>
#include <burin/level_set/solid_mesh.h>
#include <burin/math/elementary.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "command.h"
#include "input/brush_folder.h"
#include "input/grid_mesh.h"
#include "options/options.h"
#include "options/view.h"
#include "pictures/result_picture.h"
#include "replay/replay_pictures.h"
#include "system/console.h"
#include "system/output_file.h"

namespace burin::command {
namespace {

struct TryOptions {
  std::string brush, png = "try.png";
  std::vector<std::string> params;
  double radius = 0.15;
  bool isolate = false;
};

constexpr double half_width = 1, half_height = 0.6;  ///< of the sheet, object units
constexpr Index columns = 200, rows = 120;

/// The sheet at (x, y), normals upwards.
Vec3f sheet_at(double x, double y) {
  return Vec3d(x, y, 0.08 * math::sin(4 * x) * math::cos(5 * y)).cast<float>();
}

TriangleMesh make_sheet() {
  return grid_mesh(columns, rows,
                   [](double u, double v) { return sheet_at(half_width * u, half_height * v); });
}

/// One wave from left to right.
Recording make_recording(const std::string& brush, const TryOptions& options, const ParamSettings& params) {
  RecordedStroke stroke;
  stroke.settings[&StrokeSettings::brush] = brush;
  stroke.settings[&StrokeSettings::radius] = options.radius;
  stroke.settings[&StrokeSettings::params] = params;
  stroke.fields = {.time = true, .pressure = true};
  constexpr int samples = 60;
  for (int i = 0; i <= samples; ++i) {
    const double along = static_cast<double>(i) / samples, x = 0.75 * half_width * (2 * along - 1);
    Sample sample{i / 120.0, sheet_at(x, 0.25 * math::sin(4 * x)).cast<double>(), {}};
    sample.pen.pressure = static_cast<float>(4 * along * (1 - along));
    stroke.samples.push_back(sample);
  }
  Recording recording;
  recording.strokes.push_back(std::move(stroke));
  return recording;
}

/// Loads what the user names, a module or the id of a brush of the search path; returns the id.
std::string load_brush(BrushLibrary& library, const std::string& name) {
  if (!std::filesystem::is_regular_file(name)) {
    load_brushes(library);
    return library.find(name).descriptor->id;
  }
  load_module(library, name);
  if (library.brushes().empty()) throw FileError(name, "has no brushes");
  return library.brushes().front().descriptor->id;
}

Camera view_of(const Session& session, const StrokeExtent& extent) {
  ViewOptions view;
  view.direction = Vec3d(-0.2, 0.6, -1);
  view.width = 512;
  view.height = 320;
  return replay_view(session.surface(), extent, {}, view);
}

void run(const TryOptions& options) {
  check_output_path(options.png);
  BrushLibrary library = brush_library(options.isolate);
  const std::string brush = load_brush(library, options.brush);
  const ParamSettings params = parse_param_settings(
      options.params, [&](const std::string& name) { return takes_text(library, &brush, name); });
  Session session(make_surface(make_sheet()), library, merge_solid);
  StrokeExtent extent;
  ReplayObserver observer;
  observer.piece_ended = [&](const Session& done) { extent.piece_ended(done); };
  const ReplayResult result = replay(session, make_recording(brush, options, params), {}, observer);
  for (const std::string& line : session.warnings()) warn(line);
  write_png(options.png, draw_result(session, part_meshes(session), view_of(session, extent)));
  write_result(fmt::format("{}: {} events, {:.2f} ms at the median\n{}\n", brush, result.samples_drawn,
                           1000 * percentiles(result.latencies).p50, options.png));
}

}  // namespace

void add_try(CLI::App& app) {
  const auto options = std::make_shared<TryOptions>();
  CLI::App& command = *app.add_subcommand("try", "draw one stroke on a small surface, and a picture of it");
  command
      .add_option("brush", options->brush, "module, NAME.burin, whose first brush is drawn, or id of a brush")
      ->required()
      ->type_name("BRUSH");
  command.add_option("--png", options->png, "picture to write")->type_name("FILE")->capture_default_str();
  command.add_option("--radius", options->radius, "of the stroke; the surface is 2 wide")
      ->check(CLI::Range(0.02, 0.4))
      ->capture_default_str();
  command.add_option("--param", options->params, "parameter of the brush; may be given repeatedly")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false);
  command.add_flag("--isolate", options->isolate, isolate_help);
  command.callback([options] { run(*options); });
}

}  // namespace burin::command
