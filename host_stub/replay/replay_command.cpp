// The command `burin replay`: draws recorded strokes on a surface, and writes the results: a summary, the
// mesh, solids, a displacement map, pictures and a report.
#include <burin/abi/brush.h>
#include <burin/base/error.h>
#include <burin/host/plugin/brush_params.h>
#include <burin/host/replay.h>
#include <burin/level_set/solid_mesh.h>
#include <burin/stroke/move_origin.h>
#include <burin/surface/mesh_file.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "command.h"
#include "fuzz/bundle.h"
#include "input/brush_folder.h"
#include "input/name_file.h"
#include "input/radius_fit.h"
#include "input/stroke_input.h"
#include "options/axes_option.h"
#include "options/bake_option.h"
#include "options/options.h"
#include "options/setting_options.h"
#include "options/view.h"
#include "pictures/painted.h"
#include "pictures/result_picture.h"
#include "replay/merge_text.h"
#include "replay/replay_mesh.h"
#include "replay/replay_report.h"
#include "replay/solid_parts.h"
#include "report/report_folder.h"
#include "system/output_file.h"
#include "system/platform.h"
#include "watch/watch.h"

namespace burin::command {
namespace {

struct ReplayOptions {
  std::vector<std::string> strokes, params;
  ReplayMeshOptions mesh;
  AxesOptions axes;
  BakeOptions bake;
  GivenSettings settings;  ///< instead of the recorded ones
  ViewOptions view;
  std::string save_mesh, save_vdb, png, report;
  std::optional<int> watch;  ///< changes of the module to watch for; 0: without end
  bool isolate = false, json = false;
};

std::vector<Recording> read_recordings(const ReplayOptions& options) {
  const Eigen::Matrix3d rotation = turn_of_strokes(options.axes, options.mesh.mesh.path);
  std::vector<Recording> recordings;
  for (const std::string& path : options.strokes) {
    recordings.push_back(read_whole_strokes(path));
    turn(recordings.back(), rotation);
  }
  return recordings;
}

/// The radius of a stroke, object units; 0 for none.
double radius_of(const ReplayOptions& options, const RecordedStroke& stroke) {
  ReplaySettings settings = stroke.settings.complete();
  options.settings.apply_to(settings);
  return settings.radius;
}

/// The radii of all strokes that have one, object units.
std::vector<double> radii(const ReplayOptions& options, const std::vector<Recording>& recordings) {
  std::vector<double> radii;
  for (const Recording& recording : recordings)
    for (const RecordedStroke& stroke : recording.strokes)
      if (const double radius = radius_of(options, stroke); radius > 0) radii.push_back(radius);
  return radii;
}

/// Strokes refine the surface where it is too coarse for them, unless it is said how, or what follows needs
/// the triangles that there are.
void refine_by_default(ReplayOptions& options) {
  if (options.settings.find(&StrokeSettings::refining) || options.bake.asked() || options.mesh.sculpt_level)
    return;
  options.settings[&StrokeSettings::refining] = {.kind = Refining::Kind::automatic};
}

/// Whether strokes get as many vertices as they need.
bool refines(const ReplayOptions& options) {
  const Refining* refining = options.settings.find(&StrokeSettings::refining);
  return refining && refining->kind != Refining::Kind::off;
}

void warn_of_strokes(const ReplayOptions& options, const Surface& surface, const std::vector<double>& radii) {
  if (!refines(options)) warn_of_small_radii(options.mesh.mesh.path, surface, radii);
  warn_of_great_radii(options.mesh.mesh.path, surface, radii);
}

bool draws(const ReplayOptions& options) { return !options.png.empty() || !options.report.empty(); }

ReplaySummary replay_all(Session& session, const ReplayOptions& options,
                         const std::vector<Recording>& recordings, StrokeRecorder& recorder) {
  ReplaySummary summary{
      options.strokes, {}, session.surface().vertex_count(), seconds_since_process_start(), 0};
  ProgressBar bar;
  ReplayObserver observer{bar.progress(), {}};
  if (draws(options)) observer.piece_ended = [&](const Session& done) { recorder.piece_ended(done); };
  for (std::size_t i = 0; i < recordings.size(); ++i) {
    with_file_context(options.strokes[i], [&] {
      add_result(summary, replay(session, recordings[i], options.settings, observer));
    });
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
  if (result.standing_clocks > 0) {
    warn(fmt::format("strokes whose time stamps are all equal, taken as without times: {}",
                     result.standing_clocks));
  }
  if (result.samples_drawn == 0) warn("no stroke meets the surface");
}

void warn_of_lost_paint(const Session& session, const ReplayMesh& mesh) {
  if (mesh.has_levels() && !paint_in_source_order(session.surface(), session.paint()).empty())
    warn("--sculpt-level is below the finest level, which takes no colours and masks: they are lost");
}

/// Throws Error for what cannot be done with triangles that are not those of the mesh any more.
void check_replaced(const Session& session, const ReplayMesh& mesh, const ReplayOptions& options) {
  if (session.generation() == 0) return;
  if (mesh.has_levels())
    throw Error(
        "solids can be merged with the surface on the finest level only, see --sculpt-level; and it can "
        "be refined there only");
  if (options.bake.asked())
    throw Error("a surface that solids were merged with, or that was refined, cannot be baked");
}

void check_mesh_path(const std::string& path) {
  check_output_path(path);
  if (!path.empty()) check_mesh_format(path);
}

/// The rotation from the axes of the mesh file to those of the saved file.
Eigen::Matrix3d turn_to_save(const ReplayOptions& options) {
  return turn_of_saved(options.axes, options.mesh.mesh.path, options.save_mesh);
}

void check_options(const ReplayOptions& options) {
  check_mesh_path(options.save_mesh);
  turn_to_save(options);
  check_output_path(options.save_vdb);
  check_output_path(options.png);
  check_report_folder(options.report);
  check_bake_path(options.bake);
}

/// Loads the brush that --brush names, or all that strokes may have been recorded with.
void load(ReplayOptions& options, BrushLibrary& library) {
  const std::string* named = options.settings.find(&StrokeSettings::brush);
  if (!named) return load_brushes(library);
  with_file_context("--brush", [&] {
    const BrushEntry& brush = load_named_brush(library, *named);
    options.settings[&StrokeSettings::brush] = brush.descriptor->id;
  });
}

/// Goes on with the last stroke. A report has undone all, so they are drawn once more.
void watch_last(const ReplayOptions& options, Session& session, BrushLibrary& library,
                const std::vector<Recording>& recordings, const std::optional<Camera>& camera) {
  flush_results();
  while (session.undo()) {
  }
  for (const Recording& recording : recordings) replay(session, recording, options.settings);
  const auto show = [&](const WatchedStroke& before, const WatchedStroke& after) {
    write_watch_page(options.report, before, after);
  };
  watch({session, library, recordings.back(), options.settings,
         options.report.empty() ? std::nullopt : camera, show, *options.watch});
}

/// Completes the finest level of a mesh with levels; the summary then describes that level.
void finish(ReplayMesh& mesh, const Session& session, ReplaySummary& summary) {
  summary.surface_vertices =
      std::max<std::size_t>(summary.surface_vertices, session.surface().vertex_count());
  if (!mesh.has_levels()) return;
  mesh.finish(session);
  summary.result.hash = mesh.result_hash();
  summary.surface_vertices = mesh.before().positions.size();
  summary.peak_memory = peak_memory();
}

/// The picture of the result; of a mesh with levels it shows the finest level, on which nothing is painted.
Picture draw_finest(const Session& session, const ReplayMesh& mesh, const SolidParts& parts,
                    const Camera& camera, const Progress& progress) {
  if (!mesh.has_levels()) return draw_result(session, parts.meshes(), camera, progress);
  TriangleMesh result = mesh.result(session);
  VertexPaint paint;
  parts.append_to(result, paint);
  return draw_mesh(std::move(result), camera, progress);
}

/// Writes the pictures; on a mesh with levels they show the finest level, on which nothing is painted.
void write_pictures(const ReplayOptions& options, Session& session, const ReplayMesh& mesh,
                    const SolidParts& parts, const StrokeRecorder& recorder, const Camera& camera,
                    const ReplaySummary& summary, const Json& json) {
  ProgressBar bar;
  const Picture result = draw_finest(session, mesh, parts, camera, bar.progress());
  if (!options.png.empty()) write_png(options.png, result);
  if (options.report.empty()) return;
  ReplayPictures pictures = draw_replay(session, recorder, camera, bar.progress());
  pictures.after = result;
  if (mesh.has_levels()) pictures.before = draw_mesh(mesh.before(), camera, bar.progress());
  write_report(options.report, summary, json, pictures);
}

void save_mesh(const ReplayOptions& options, const Session& session, const ReplayMesh& mesh,
               const SolidParts& parts) {
  if (options.save_mesh.empty()) return;
  const Eigen::Matrix3d rotation = turn_to_save(options);
  TriangleMesh saved = mesh.saved(session);
  VertexPaint paint = mesh.saved_paint(session);
  parts.append_to(saved, paint);
  if (!rotation.isIdentity(0))
    for (Vec3f& position : saved.positions) position = (rotation.cast<float>() * position).eval();
  write_mesh(options.save_mesh, saved, paint, rotation * mesh.origin());
}

/// Parses parameter settings. A value that looks like a number stays text if the brush's parameter is text.
ParamSettings read_params(const ReplayOptions& options, const BrushLibrary& library) {
  return parse_param_settings(options.params, [&](const std::string& name) {
    return takes_text(library, options.settings.find(&StrokeSettings::brush), name);
  });
}

/// Whether a bundle of `burin validate --fuzz` is to be repeated, which has all that a replay needs.
bool is_bundle(const ReplayOptions& options) {
  return options.strokes.size() == 1 && std::filesystem::is_directory(options.strokes[0]);
}

void run(ReplayOptions& options) {
  BrushLibrary library = brush_library(options.isolate);
  load(options, library);
  check_options(options);
  options.settings[&StrokeSettings::params] = read_params(options, library);
  refine_by_default(options);
  std::vector<Recording> recordings = read_recordings(options);
  // From a copy, so that the file may be overwritten before the watch begins.
  if (options.watch) library.reload(module_of_last(library, recordings.back(), options.settings));
  ReplayMesh mesh(
      options.mesh,
      {.baked = options.bake.asked(), .saved = !options.save_mesh.empty(), .refined = refines(options)});
  for (Recording& recording : recordings) move_origin(recording, mesh.origin());
  options.settings[&StrokeSettings::symmetry].centre -= mesh.origin();
  Session session(mesh.take_surface(), library, merge_solid);
  session.set_paint(mesh.take_paint());
  // Reports and watches undo. A stroke that refined the surface can be undone as long as the one before it is
  // kept whole.
  if (options.report.empty() && !options.watch) session.limit_undo(0);
  warn_of_strokes(options, session.surface(), radii(options, recordings));
  StrokeRecorder recorder;
  ReplaySummary summary = replay_all(session, options, recordings, recorder);
  with_file_context(options.mesh.mesh.path, [&] { check_replaced(session, mesh, options); });
  finish(mesh, session, summary);
  warn_of_left_out(summary);
  warn_of_lost_paint(session, mesh);
  for (const std::string& line : session.warnings()) warn(line);
  Json json = {{"mesh", mesh.json()}};
  json.update(summary_json(summary));
  const SolidParts parts(session);
  if (!parts.empty()) json["parts"] = parts.json();
  if (!session.merges().empty()) json["merges"] = merges_json(session.merges());
  if (!session.refinements().empty()) json["refined"] = refinements_json(session.refinements());
  save_mesh(options, session, mesh, parts);
  if (!options.save_vdb.empty()) write_vdb(options.save_vdb, session.parts());
  if (options.bake.asked()) {
    json["bake"] = write_map(options.bake, mesh.before(), mesh.result(session).positions);
  }
  // Pictures undo the strokes.
  const std::string changes = merges_text(session.merges()) + refinements_text(session.refinements());
  std::optional<Camera> camera;
  if (draws(options)) {
    camera = replay_view(session.surface(), recorder.extent(), recordings, options.view);
    write_pictures(options, session, mesh, parts, recorder, *camera, summary, json);
  }
  write_result(options.json ? json_text(json)
                            : mesh.text() + "\n" + summary_text(summary) + parts.text() + changes + "\n");
  if (options.watch) watch_last(options, session, library, recordings, camera);
}

}  // namespace

void add_replay(CLI::App& app) {
  const auto options = std::make_shared<ReplayOptions>();
  CLI::App& command = *app.add_subcommand("replay", "draw recorded strokes on a surface with a brush");
  command
      .add_option("stroke_files", options->strokes,
                  "recorded strokes; or a folder that `burin validate --fuzz` wrote, to repeat the failure")
      ->required()
      ->type_name("FILE.stroke");
  add_replay_mesh_options(command, options->mesh);
  command.get_option("--mesh")->required(false);
  add_axes_options(command, options->axes);
  add_all_setting_options(command, options->settings, options->params);
  command.get_option("--brush")
      ->description(fmt::format("{} (as recorded)", named_brushes_help))
      ->type_name("BRUSH");
  command
      .add_option("--save-mesh", options->save_mesh,
                  "surface to write, with what is painted on it: .ply, .glb, .obj or .off")
      ->type_name("FILE");
  command
      .add_option("--save-vdb", options->save_vdb, "OpenVDB file to write, with the solids that strokes made")
      ->type_name("FILE.vdb");
  add_bake_options(command, options->bake);
  command.add_option("--png", options->png, "picture of the result, the strokes filling it")
      ->type_name("FILE");
  add_view_options(command, options->view);
  command.add_option("--report", options->report, "folder for a report with pictures")->type_name("FOLDER");
  CLI::Option* watch =
      command
          .add_flag(
              "--watch{0}", options->watch,
              "draw the last stroke again whenever the module of its brush changes, until interrupted, "
              "or with --watch=N for N changes; with --report, watch.html in the folder shows it before "
              "and after")
          ->check(whole_number_from_0());
  command.add_flag("--isolate", options->isolate, isolate_help);
  command.add_flag("--json", options->json, "write JSON to the standard output")->excludes(watch);
  command.callback([options, watch] {
    // CLI11 gives a flag its default where it is absent, too.
    if (watch->count() == 0) options->watch.reset();
    if (is_bundle(*options)) return replay_bundle(options->strokes[0]);
    if (options->mesh.mesh.path.empty()) throw CLI::RequiredError("--mesh");
    run(*options);
  });
}

}  // namespace burin::command
