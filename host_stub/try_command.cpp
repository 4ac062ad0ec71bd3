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
#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include "command.h"
#include "input/brush_folder.h"
#include "input/grid_mesh.h"
#include "options/options.h"
#include "options/setting_options.h"
#include "options/view.h"
#include "pictures/result_picture.h"
#include "replay/replay_pictures.h"
#include "system/console.h"
#include "system/output_file.h"
#include "validate/work_folder.h"
#include "watch/watch.h"

namespace burin::command {
namespace {

struct TryOptions {
  std::string brush, png = "try.png";
  std::vector<std::string> params;
  GivenSettings solid;  ///< what becomes of the solid of a brush that makes one
  double radius = 0.15;
  std::optional<int> watch;
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

/// Sets files that the user must choose and did not to an image of soft hills, in the folder.
void choose_files(const burin_brush_descriptor& brush, std::optional<validate::WorkFolder>& folder,
                  ParamSettings& params) {
  for (const burin_param_info* info : std::span(brush.params, brush.param_count)) {
    if (info->type != BURIN_PARAM_FILE || info->default_file || params.contains(info->id)) continue;
    if (!folder) folder.emplace();
    params[info->id] = folder->stamp().string();
    warn(fmt::format("no --param {}=FILE was given: it is an image of soft hills", info->id));
  }
}

Camera view_of(const Session& session, const StrokeExtent& extent) {
  ViewOptions view;
  view.direction = Vec3d(-0.2, 0.6, -1);
  view.width = 512;
  view.height = 320;
  return replay_view(session.surface(), extent, {}, view);
}

/// Goes on with the stroke as the last one.
void watch_stroke(const TryOptions& options, Session& session, BrushLibrary& library,
                  const Recording& recording, const Camera& camera, Picture picture) {
  flush_results();
  watch({session, library, recording, options.solid, camera,
         [&](const WatchedStroke&, const WatchedStroke& after) { write_png(options.png, after.picture); },
         *options.watch, std::move(picture)});
}

void run(const TryOptions& options) {
  check_output_path(options.png);
  BrushLibrary library = brush_library(options.isolate);
  const BrushEntry& entry = load_named_brush(library, options.brush);
  const std::string brush = entry.descriptor->id;
  ParamSettings params = parse_param_settings(
      options.params, [&](const std::string& name) { return takes_text(library, &brush, name); });
  std::optional<validate::WorkFolder> folder;
  choose_files(*entry.descriptor, folder, params);
  // From a copy, so that the file may be overwritten before the watch begins.
  if (options.watch) library.reload(std::filesystem::path(entry.module));
  Session session(make_surface(make_sheet()), library, merge_solid);
  StrokeExtent extent;
  ReplayObserver observer;
  observer.piece_ended = [&](const Session& done) { extent.piece_ended(done); };
  const Recording recording = make_recording(brush, options, params);
  const ReplayResult result = replay(session, recording, options.solid, observer);
  for (const std::string& line : session.warnings()) warn(line);
  const Camera camera = view_of(session, extent);
  Picture picture = draw_result(session, part_meshes(session), camera);
  write_png(options.png, picture);
  write_result(fmt::format("{}: {} events, {:.2f} ms at the median\n{}\n", brush, result.samples_drawn,
                           1000 * percentiles(result.latencies).p50, options.png));
  if (options.watch) watch_stroke(options, session, library, recording, camera, std::move(picture));
}

}  // namespace

void add_try(CLI::App& app) {
  const auto options = std::make_shared<TryOptions>();
  CLI::App& command = *app.add_subcommand("try", "draw one stroke on a small surface, and a picture of it");
  command.add_option("brush", options->brush, named_brushes_help)->required()->type_name("BRUSH");
  command.add_option("--png", options->png, "picture to write")->type_name("FILE")->capture_default_str();
  command.add_option("--radius", options->radius, "of the stroke; the surface is 2 wide")
      ->check(CLI::Range(0.02, 0.4))
      ->capture_default_str();
  command.add_option("--param", options->params, "parameter of the brush; may be given repeatedly")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false);
  constexpr std::array<std::string_view, 2> of_solids = {"solid", "voxel"};
  add_setting_options(command, options->solid, of_solids);
  CLI::Option* watch = command
                           .add_flag("--watch{0}", options->watch,
                                     "draw the stroke and the picture again whenever the module changes, "
                                     "until interrupted, or with --watch=N for N changes")
                           ->check(whole_number_from_0());
  command.add_flag("--isolate", options->isolate, isolate_help);
  command.callback([options, watch] {
    // CLI11 gives a flag its default where it is absent, too.
    if (watch->count() == 0) options->watch.reset();
    run(*options);
  });
}

}  // namespace burin::command
