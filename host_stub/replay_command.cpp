#include <burin/host/replay.h>
#include <burin/surface/mesh_file.h>
#include <fmt/format.h>

#include <memory>

#include "brush_folder.h"
#include "command.h"
#include "mesh_input.h"
#include "name_file.h"
#include "options.h"
#include "output_file.h"
#include "platform.h"
#include "render.h"
#include "replay_report.h"
#include "report_folder.h"
#include "source_order.h"
#include "stroke_choices.h"
#include "stroke_input.h"
#include "view.h"

namespace burin::command {
namespace {

struct ReplayOptions {
  std::vector<std::string> strokes, params;
  MeshOptions mesh;
  StrokeOverrides overrides;
  ViewOptions view;
  std::string save_mesh, png, report;
  bool json = false;
};

std::vector<Recording> read_recordings(const std::vector<std::string>& paths) {
  std::vector<Recording> recordings;
  for (const std::string& path : paths) recordings.push_back(read_whole_strokes(path));
  return recordings;
}

bool draws(const ReplayOptions& options) { return !options.png.empty() || !options.report.empty(); }

ReplaySummary replay_all(Session& session, const ReplayOptions& options,
                         const std::vector<Recording>& recordings, StrokeWitness& witness) {
  ReplaySummary summary{
      options.strokes, {}, session.surface().vertex_count(), seconds_since_process_start(), 0};
  ProgressBar bar;
  ReplayObserver observer{bar.progress(), {}};
  if (draws(options)) observer.piece_ended = [&](const Session& done) { witness.piece_ended(done); };
  for (std::size_t i = 0; i < recordings.size(); ++i) {
    naming_file(options.strokes[i],
                [&] { add_result(summary, replay(session, recordings[i], options.overrides, observer)); });
  }
  summary.peak_memory = peak_memory();
  return summary;
}

void warn_of_left_out(const ReplaySummary& summary) {
  const ReplayResult& result = summary.result;
  if (result.left_open > 0) {
    warn(fmt::format(
        "closed strokes that stay open, as they leave the surface on the way or are too short: {}",
        result.left_open));
  }
  if (result.samples_drawn == 0) warn("no stroke meets the surface");
}

/// Of the first recording in screen space.
std::optional<Camera> recorded_camera(const std::vector<Recording>& recordings) {
  for (const Recording& recording : recordings) {
    if (recording.space == StrokeSpace::screen) return recording.camera;
  }
  return std::nullopt;
}

void check_options(const ReplayOptions& options, const BrushLibrary& library) {
  check_output_path(options.save_mesh);
  check_output_path(options.png);
  check_report_folder(options.report);
  if (options.overrides.brush) naming_file("--brush", [&] { library.find(*options.overrides.brush); });
}

void write_pictures(const ReplayOptions& options, Session& session, const StrokeWitness& witness,
                    const Camera& camera, const ReplaySummary& summary, const Json& json) {
  ProgressBar bar;
  if (!options.png.empty())
    write_png(options.png, render(session.surface(), session.picker(), camera, clay, bar.progress()));
  if (!options.report.empty())
    write_report(options.report, summary, json, draw_replay(session, witness, camera, bar.progress()));
}

void run(const ReplayOptions& options) {
  BrushLibrary library(log_on_console);
  library.load_search_path(own_brush_folder());
  check_options(options, library);
  const std::vector<Recording> recordings = read_recordings(options.strokes);
  LoadedSurface loaded = load_surface_on_console(options.mesh);
  const Json mesh = mesh_json(options.mesh, loaded);
  const std::string mesh_line = mesh_text(options.mesh, loaded);
  Session session(std::move(loaded.surface), library);
  StrokeWitness witness;
  const ReplaySummary summary = replay_all(session, options, recordings, witness);
  warn_of_left_out(summary);
  Json json = {{"mesh", mesh}};
  json.update(summary_json(summary));
  if (!options.save_mesh.empty()) {
    write_ply(options.save_mesh, in_source_order(session.surface(), session.positions()));
  }
  if (draws(options)) {
    const Camera camera = replay_view(session, witness, recorded_camera(recordings), options.view);
    write_pictures(options, session, witness, camera, summary, json);
  }
  fmt::print("{}\n", options.json ? json_text(json) : mesh_line + "\n" + summary_text(summary));
}

}  // namespace

void add_replay(CLI::App& app) {
  const auto options = std::make_shared<ReplayOptions>();
  CLI::App& command = *app.add_subcommand("replay", "draw recorded strokes on a surface with a brush");
  command.add_option("stroke_files", options->strokes, "recorded strokes")
      ->required()
      ->type_name("FILE.stroke");
  add_mesh_options(command, options->mesh);
  StrokeOverrides& overrides = options->overrides;
  command.add_option("--brush", overrides.brush, "instead of the recorded brush")->type_name("ID");
  command.add_option("--radius", overrides.radius, "object units, instead of the recorded one")
      ->check(positive_number());
  command.add_option("--strength", overrides.strength, "factor on the brush's displacement")
      ->check(finite_number());
  command
      .add_option_function<std::string>(
          "--overlap",
          [&overrides](const std::string& name) { overrides.overlap = overlap_names().at(name); },
          "where a stroke overlaps itself: latest (the default), max, min, add or average")
      ->check(CLI::IsMember({"latest", "max", "min", "add", "average"}));
  add_stroke_options(command, overrides.closure, overrides.pressure_width, overrides.join);
  command
      .add_option("--show-every", overrides.show_every,
                  "show every so many samples, as where several come at a time; 0: each stroke at its end")
      ->capture_default_str();
  command.add_option("--param", options->params, "parameter of the brush, repeatable")
      ->type_name("NAME=VALUE")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command.add_option("--save-mesh", options->save_mesh, "surface to write")->type_name("FILE.ply");
  command.add_option("--png", options->png, "picture of the result, the strokes filling it")
      ->type_name("FILE");
  add_view_options(command, options->view);
  command.add_option("--report", options->report, "folder for a report with pictures")->type_name("FOLDER");
  command.add_flag("--json", options->json, "write JSON to the standard output");
  command.callback([options] {
    options->overrides.params = parse_param_settings(options->params);
    run(*options);
  });
}

}  // namespace burin::command
