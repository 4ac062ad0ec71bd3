// The command `burin snap`: moves recorded strokes to ridges, silhouettes and other features of a surface.
#include <burin/base/error.h>
#include <burin/feature/snap.h>
#include <burin/stroke/curve/stroke_trace.h>
#include <burin/stroke/move_origin.h>
#include <burin/stroke/sample_times.h>
#include <burin/surface/vertex_scalar.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "command.h"
#include "input/mesh_input.h"
#include "input/radius_fit.h"
#include "input/stroke_input.h"
#include "options/axes_option.h"
#include "options/options.h"
#include "options/setting_options.h"
#include "options/view.h"
#include "recordings/written_strokes.h"
#include "snap/snap_picture.h"
#include "snap/snap_view.h"
#include "system/output_file.h"

namespace burin::command {
namespace {

struct SnapCommandOptions {
  std::string strokes, out, png, feature, camera, ends = "free";
  GivenSettings settings;
  SnapOptions snap;
  std::optional<double> scale;
  MeshOptions mesh;
  AxesOptions axes;
  ViewOptions view;
  bool json = false;
};

constexpr std::string_view scalar_prefix = "scalar:";

/// A kind of feature, and the name of the values of vertices that it is a crest of, if any.
struct NamedFeature {
  FeatureKind kind;
  std::string values;
};

std::optional<NamedFeature> feature_named(std::string_view name) {
  if (name == "ridge") return NamedFeature{FeatureKind::ridge, {}};
  if (name == "valley") return NamedFeature{FeatureKind::valley, {}};
  if (name == "silhouette") return NamedFeature{FeatureKind::silhouette, {}};
  if (name == "border") return NamedFeature{FeatureKind::border, {}};
  if (!name.starts_with(scalar_prefix)) return std::nullopt;
  name.remove_prefix(scalar_prefix.size());
  const bool is_low = name.starts_with('-');
  if (is_low) name.remove_prefix(1);
  if (name.empty()) return std::nullopt;
  return NamedFeature{is_low ? FeatureKind::low : FeatureKind::high, std::string(name)};
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
  throw FileError(options.strokes, "was recorded without a camera: give --view or --camera for silhouettes");
}

/// Snaps all strokes; the result has one for each piece of a stroke that leaves the surface on the way.
class SnappedRecording {
 public:
  SnappedRecording(const SnapCommandOptions& options, const LoadedSurface& loaded, const Picker& picker,
                   const Feature& feature)
      : options_(options),
        loaded_(loaded),
        picker_(picker),
        snapper_(loaded.surface, picker),
        feature_(feature) {}

  void add(const Recording& recording, std::size_t number) {
    const RecordedStroke& stroke = recording.strokes[number];
    const ReplaySettings settings = settings_to_trace(options_.strokes, stroke, number, options_.settings);
    const CurveGround ground(loaded_.surface, picker_);
    const auto pieces =
        trace_stroke(ground, recording, stroke, trace_options(settings, stroke.fields, number));
    if (pieces.empty())
      throw FileError(options_.strokes, fmt::format("stroke {} does not meet the surface", number + 1));
    radius_ = std::max(radius_, settings.radius);
    SnapOptions how = options_.snap;
    how.radius = settings.radius;
    how.scale = options_.scale.value_or(0);
    how.fixed_ends = options_.ends == "fixed";
    for (const SurfaceCurve& piece : pieces) {
      snapped_.push_back({piece, snapper_.snap(piece, feature_, how)});
      numbers_.push_back(number + 1);
      add_to_recording(stroke, snapped_.back().result.curve);
    }
  }

  const std::vector<SnappedStroke>& strokes() const { return snapped_; }
  const Recording& recording() const { return recording_; }
  std::size_t number(std::size_t i) const { return numbers_[i]; }
  double radius() const { return radius_; }  ///< greatest of the strokes

 private:
  void add_to_recording(const RecordedStroke& stroke, const SurfaceCurve& curve) {
    RecordedStroke result{stroke.settings, stroke.fields, {}};
    for (const CurvePoint& point : curve.points) {
      const Vec3d position = point.at.position.cast<double>() + loaded_.from.origin;
      result.samples.push_back({point.time, position, point.pen});
    }
    recording_.strokes.push_back(std::move(result));
  }

  const SnapCommandOptions& options_;
  const LoadedSurface& loaded_;
  const Picker& picker_;
  StrokeSnapper snapper_;
  const Feature& feature_;
  std::vector<SnappedStroke> snapped_;
  std::vector<std::size_t> numbers_;  ///< [snapped stroke] number in the file, from 1
  Recording recording_;
  double radius_ = 0;
};

Json stroke_json(std::size_t number, const SnappedStroke& snapped) {
  const SnapResult& result = snapped.result;
  Json ranges = Json::array();
  for (const SnapRange& range : result.ranges)
    ranges.push_back({{"from", range.from}, {"to", range.to}, {"significance", range.significance}});
  return {{"stroke", number},
          {"length", snapped.stroke.length()},
          {"points", result.curve.points.size()},
          {"significance", result.significance},
          {"snapped_share", result.snapped_share},
          {"snapped", ranges},
          {"mean_move", result.mean_move},
          {"scale", result.scale},
          {"iterations", result.iterations}};
}

std::string stroke_text(std::size_t number, const SnappedStroke& snapped) {
  const SnapResult& result = snapped.result;
  if (result.ranges.empty())
    return fmt::format("stroke {}: stays, nothing stands out (significance {:.3g})\n", number,
                       result.significance);
  std::string parts;
  for (const SnapRange& range : result.ranges)
    parts += fmt::format("{}{:.4g} to {:.4g}", parts.empty() ? "" : ", ", range.from, range.to);
  return fmt::format(
      "stroke {}: snapped from {} of {:.4g}, moved by {:.3g} in the mean, significance {:.3g}\n", number,
      parts, snapped.stroke.length(), result.mean_move, result.significance);
}

void print_result(const SnapCommandOptions& options, const LoadedSurface& loaded,
                  const SnappedRecording& snapped) {
  Json strokes = Json::array();
  std::string text = mesh_text(options.mesh, loaded) + '\n';
  for (std::size_t i = 0; i < snapped.strokes().size(); ++i) {
    strokes.push_back(stroke_json(snapped.number(i), snapped.strokes()[i]));
    text += stroke_text(snapped.number(i), snapped.strokes()[i]);
  }
  const Json json = {{"mesh", mesh_json(options.mesh, loaded)},
                     {"feature", options.feature},
                     {"out", options.out},
                     {"strokes", strokes}};
  write_result(options.json ? json_text(json) : text);
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

void run(const SnapCommandOptions& options) {
  const NamedFeature named = *feature_named(options.feature);
  check_output_path(options.out);
  check_output_path(options.png);
  Recording recording = read_whole_strokes(options.strokes);
  turn(recording, turn_of_strokes(options.axes, options.mesh.path));
  repair_times(recording);
  if (!named.values.empty() && (options.mesh.subdivide || options.mesh.target_triangles))
    throw CLI::ValidationError("--feature", "values of vertices are lost if --mesh is refined");
  const LoadedSurface loaded = load_surface_on_console(options.mesh);
  move_origin(recording, loaded.from.origin);
  Feature feature{.kind = named.kind};
  std::vector<float> values;
  if (!named.values.empty()) values = values_of(options, loaded, named.values);
  feature.values = values;
  const std::optional<Camera> camera = chosen_camera(options, recording, loaded.from.origin);
  if (named.kind == FeatureKind::silhouette) feature.view = chosen_view(options, camera);
  const Picker picker(loaded.surface);
  SnappedRecording snapped(options, loaded, picker, feature);
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
          "surface turns away from --view (silhouette), its open border, or crests of a value of a PLY "
          "file's "
          "vertices (scalar:NAME), scalar:-NAME for its lowest places")
      ->required()
      ->type_name("ridge|valley|silhouette|border|scalar:NAME")
      ->check([](const std::string& name) {
        return feature_named(name) ? std::string() : fmt::format("'{}' is no feature", name);
      });
  command
      .add_option(
          "--scale", options.scale,
          "standard deviation of the Gaussian that smooths the surface, object units; half the feature's "
          "width is best; default: a sixth of the radius, but for silhouettes and borders 1.25 edges")
      ->check(positive_number());
  command.add_option("--iterations", options.snap.iterations, "charts, each around the result before")
      ->check(CLI::Range(1, 20))
      ->capture_default_str();
  command
      .add_option("--significance", options.snap.significance,
                  "least contrast of a feature, in units of the noise; the stroke stays where it is less")
      ->check(CLI::NonNegativeNumber & finite_number())
      ->capture_default_str();
  command.add_option("--ends", options.ends, "ends of strokes are moved too, or stay")
      ->check(CLI::IsMember({"free", "fixed"}))
      ->capture_default_str();
}

}  // namespace

void add_snap(CLI::App& app) {
  const auto options = std::make_shared<SnapCommandOptions>();
  CLI::App& command =
      *app.add_subcommand("snap", "move recorded strokes to ridges, silhouettes and other features");
  command.add_option("stroke_file", options->strokes, "recorded strokes")
      ->required()
      ->type_name("FILE.stroke");
  add_mesh_options(command, options->mesh);
  add_drawing_axes_options(command, options->axes);
  add_view_options(command, options->view);
  command
      .add_option("--camera", options->camera,
                  "recording whose camera silhouettes are seen by; default: that of the strokes, if any")
      ->type_name("FILE.stroke")
      ->excludes("--view");
  constexpr std::string_view keys[] = {"radius", "closed"};
  add_setting_options(command, options->settings, keys);
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
