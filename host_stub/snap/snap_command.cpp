// The command `burin snap`: moves recorded strokes to ridges, silhouettes and other features of a surface.
#include <burin/base/error.h>
#include <burin/base/text/quoted_word.h>
#include <burin/feature/feature.h>
#include <burin/stroke/move_origin.h>
#include <burin/stroke/sample_times.h>
#include <burin/subdiv/refined_creases.h>
#include <burin/surface/source_numbers.h>
#include <burin/surface/vertex_scalar.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <charconv>
#include <memory>
#include <nlohmann/json.hpp>

#include "command.h"
#include "input/mesh_input.h"
#include "input/name_file.h"
#include "input/stroke_input.h"
#include "options/axes_option.h"
#include "options/options.h"
#include "options/setting_options.h"
#include "options/view.h"
#include "recordings/written_strokes.h"
#include "snap/snap_picture.h"
#include "snap/snap_view.h"
#include "snap/snapped_recording.h"
#include "system/output_file.h"

namespace burin::command {
namespace {

struct SnapCommandOptions {
  std::string out, png, feature, camera, ends = "free";
  SnapJob job;
  MeshOptions mesh;
  AxesOptions axes;
  ViewOptions view;
  bool json = false;
};

constexpr std::string_view scalar_prefix = "scalar:", crease_prefix = "crease:";

/// A feature, and the name of the values of vertices that it is a crest of, if any.
struct NamedFeature {
  Feature feature;
  std::string values;
};

std::optional<NamedFeature> scalar_named(std::string_view name) {
  const bool is_low = name.starts_with('-');
  if (is_low) name.remove_prefix(1);
  if (name.empty()) return std::nullopt;
  return NamedFeature{{.kind = is_low ? FeatureKind::low : FeatureKind::high}, std::string(name)};
}

std::optional<NamedFeature> crease_of(std::string_view degrees) {
  NamedFeature crease{{.kind = FeatureKind::crease}, {}};
  double& angle = crease.feature.least_angle;
  const char* const end = degrees.data() + degrees.size();
  const auto [stop, error] = std::from_chars(degrees.data(), end, angle);
  if (error != std::errc() || stop != end || !(angle > 0 && angle < 180)) return std::nullopt;
  return crease;
}

std::optional<NamedFeature> feature_named(std::string_view name) {
  if (name == "ridge") return NamedFeature{{.kind = FeatureKind::ridge}, {}};
  if (name == "valley") return NamedFeature{{.kind = FeatureKind::valley}, {}};
  if (name == "silhouette") return NamedFeature{{.kind = FeatureKind::silhouette}, {}};
  if (name == "suggestive") return NamedFeature{{.kind = FeatureKind::suggestive}, {}};
  if (name == "border") return NamedFeature{{.kind = FeatureKind::border}, {}};
  if (name == "crease") return NamedFeature{{.kind = FeatureKind::crease}, {}};
  if (name.starts_with(crease_prefix)) return crease_of(name.substr(crease_prefix.size()));
  if (name.starts_with(scalar_prefix)) return scalar_named(name.substr(scalar_prefix.size()));
  return std::nullopt;
}

/// The values of the surface's vertices.
std::vector<float> values_of(const SnapCommandOptions& options, const LoadedSurface& loaded,
                             const std::string& name) {
  const std::vector<float> of_file = read_vertex_scalar(options.mesh.path, name);
  const Surface& surface = loaded.surface;
  const std::vector<Index>& vertex_of = loaded.from.vertex_of;
  std::vector<float> of_mesh = of_file;
  // A joined vertex has the value of its first one.
  for (std::size_t vertex = vertex_of.size(); vertex-- > 0;) of_mesh[vertex_of[vertex]] = of_file[vertex];
  std::vector<float> values(surface.vertex_count());
  for (Index vertex = 0; vertex < surface.vertex_count(); ++vertex)
    values[vertex] = of_mesh[surface.source_vertex[vertex]];
  return values;
}

/// The creases of a cage as edges of the surface that it was refined to; see Feature::creases.
std::vector<std::array<Index, 2>> in_surface_order(std::vector<std::array<Index, 2>> edges,
                                                   const Surface& surface) {
  if (edges.empty()) return edges;
  const std::vector<Index> number = numbers_of_source(surface);
  for (auto& [a, b] : edges) {
    const auto [least, most] = std::minmax({number[a], number[b]});
    a = least;
    b = most;
  }
  std::ranges::sort(edges);
  return edges;
}

/// The camera that features are seen by, if one is given or the strokes were drawn before one.
std::optional<Camera> chosen_camera(const SnapCommandOptions& options, const Recording& recording,
                                    const Vec3d& origin) {
  if (options.view.direction) return std::nullopt;
  if (options.camera.empty()) return recording.camera;
  return read_camera(options.camera, turn_of_strokes(options.axes, options.mesh.path), origin);
}

Viewpoint chosen_view(const SnapCommandOptions& options, const std::optional<Camera>& camera) {
  if (options.view.direction) return {false, *options.view.direction};
  if (camera) return viewpoint_of(*camera);
  throw FileError(options.job.strokes,
                  "was recorded without a camera: give --view or --camera for what is seen");
}

void print_result(const SnapCommandOptions& options, const LoadedSurface& loaded,
                  const SnappedRecording& snapped) {
  const Json json = {{"mesh", mesh_json(options.mesh, loaded)},
                     {"feature", options.feature},
                     {"out", options.out},
                     {"strokes", snapped.json()}};
  write_result(options.json ? json_text(json) : mesh_text(options.mesh, loaded) + '\n' + snapped.text());
}

void write_picture(const SnapCommandOptions& options, const std::optional<Camera>& seen_by,
                   const LoadedSurface& loaded, const Picker& picker, const SnappedRecording& snapped) {
  std::vector<SurfaceCurve> curves;
  for (const SnappedStroke& stroke : snapped.strokes()) curves.push_back(stroke.stroke);
  const Camera camera = seen_by ? fit_into(*seen_by, options.view.width)
                                : stroke_view(loaded.surface, curves, snapped.radius(), options.view);
  constexpr double share_of_radius = 0.1;  // lines on silhouettes are half hidden
  write_png(options.png, snap_picture(loaded.surface, picker, camera, snapped.strokes(),
                                      share_of_radius * snapped.radius()));
}

void run(SnapCommandOptions& options) {
  options.job.snap.fixed_ends = options.ends == "fixed";
  const NamedFeature named = *feature_named(options.feature);
  check_output_path(options.out);
  check_output_path(options.png);
  Recording recording = read_whole_strokes(options.job.strokes);
  turn(recording, turn_of_strokes(options.axes, options.mesh.path));
  repair_times(recording);
  if (!named.values.empty() && (options.mesh.subdivide || options.mesh.target_triangles))
    throw CLI::ValidationError("--feature", "values of vertices are lost if --mesh is refined");
  Cage cage = read_cage(options.mesh);
  std::vector<std::array<Index, 2>> creases;
  if (named.feature.kind == FeatureKind::crease)
    creases = with_file_context(options.mesh.path,
                                [&] { return refined_creases(cage.polygons, cage.scheme, cage.level); });
  const LoadedSurface loaded = load_surface_on_console(options.mesh, std::move(cage));
  creases = in_surface_order(std::move(creases), loaded.surface);
  move_origin(recording, loaded.from.origin);
  Feature feature = named.feature;
  std::vector<float> values;
  if (!named.values.empty()) values = values_of(options, loaded, named.values);
  feature.values = values;
  feature.creases = creases;
  const std::optional<Camera> camera = chosen_camera(options, recording, loaded.from.origin);
  if (is_seen(feature.kind)) feature.view = chosen_view(options, camera);
  const Picker picker(loaded.surface);
  SnappedRecording snapped(options.job, loaded, picker, feature);
  for (std::size_t i = 0; i < recording.strokes.size(); ++i)
    if (!recording.strokes[i].samples.empty()) snapped.add(recording, i);
  write_stroke_file(options.out, snapped.recording());
  if (!options.png.empty()) write_picture(options, camera, loaded, picker, snapped);
  print_result(options, loaded, snapped);
}

void add_snap_options(CLI::App& command, SnapCommandOptions& options) {
  command
      .add_option(
          "--feature", options.feature,
          "what strokes are moved to: crests of the greatest (ridge) or least (valley) curvature, where the "
          "surface turns away from --view (silhouette) or nearly does so (suggestive contours), its open "
          "border, edges of at least 30 degrees "
          "and the creases of a cage (crease; crease:DEGREES), or crests of a value of a PLY file's vertices "
          "(scalar:NAME), "
          "scalar:-NAME for its lowest places")
      ->required()
      ->type_name("ridge|valley|silhouette|suggestive|border|crease|scalar:NAME")
      ->check([](const std::string& name) {
        return feature_named(name) ? std::string()
                                   : "must be one of ridge, valley, silhouette, suggestive, border, crease, "
                                     "scalar:NAME, not " +
                                         quoted_word(name);
      });
  command
      .add_option(
          "--scale", options.job.snap.scale,
          "standard deviation of the Gaussian that smooths the surface, object units; half the feature's "
          "width is best; default: a sixth of the radius, but for silhouettes, borders and creases 1.25 "
          "edges")
      ->check(positive_number());
  command.add_option("--iterations", options.job.snap.iterations, "charts, each around the result before")
      ->check(CLI::Range(1, 20))
      ->capture_default_str();
  command
      .add_option("--significance", options.job.snap.significance,
                  "least contrast of a feature, in units of the noise; the stroke stays where it is less")
      ->check(number_from_0())
      ->capture_default_str();
  choose(command.add_option("--ends", options.ends, "ends of strokes are moved too, or stay"),
         {"free", "fixed"})
      ->capture_default_str();
  command
      .add_option("--track", options.job.most_edges,
                  "strokes are lines that were snapped before the camera moved or the mesh changed: follow "
                  "them, without parts that would move by more edges than this, 2 for instance")
      ->type_name("EDGES")
      ->check(CLI::Range(0.01, 4.))
      ->excludes("--ends");
}

}  // namespace

void add_snap(CLI::App& app) {
  const auto options = std::make_shared<SnapCommandOptions>();
  CLI::App& command =
      *app.add_subcommand("snap", "move recorded strokes to ridges, silhouettes and other features");
  command.add_option("stroke_file", options->job.strokes, "recorded strokes")
      ->required()
      ->type_name("FILE.stroke");
  add_mesh_options(command, options->mesh);
  add_drawing_axes_options(command, options->axes);
  add_view_options(command, options->view);
  command
      .add_option("--camera", options->camera,
                  "recording whose camera silhouettes and suggestive contours are seen by; default: that of "
                  "the strokes, if any")
      ->type_name("FILE.stroke")
      ->excludes("--view");
  constexpr std::string_view keys[] = {"radius", "closed"};
  add_setting_options(command, options->job.settings, keys);
  add_snap_options(command, *options);
  command.add_option("--out", options->out, "file to write the moved strokes to, in the axes of the mesh")
      ->required()
      ->type_name("FILE.stroke");
  command.add_option("--png", options->png, "picture to write: strokes before (black) and after (red)")
      ->type_name("FILE");
  command.add_flag("--json", options->json, "write JSON to the standard output");
  command.callback([options] { run(*options); });
}

}  // namespace burin::command
