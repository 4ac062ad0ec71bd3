// The command `burin import`: converts a pen recording of another program to a `.stroke` file, with a camera
// that looks at the surface of the command.
#include <burin/ink/import_pen_file.h>
#include <burin/stroke/move_origin.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "command.h"
#include "input/mesh_input.h"
#include "options/options.h"
#include "options/setting_options.h"
#include "options/view.h"
#include "recordings/pen_listing.h"
#include "recordings/written_strokes.h"
#include "system/output_file.h"

namespace burin::command {
namespace {

struct ImportOptions {
  std::string recording, out, format = "auto";
  MeshOptions mesh;
  ViewOptions view;
  GivenSettings settings;
  PenImport import;
  std::string pressure_from;
  bool list = false, json = false;
};

/// The kind of a recording whose first bytes are those of none, so that a message can name its fault; empty
/// if its name does not tell either.
std::string_view kind_by_name(const std::filesystem::path& path) {
  const std::filesystem::path extension = path.extension();
  return extension == ".json"  ? "pointer"
         : extension == ".svc" ? "svc"
         : extension == ".dat" ? "mypaint"
                               : std::string_view();
}

PenFile read_recording(const ImportOptions& options) {
  const PenFileText text = open_pen_file(options.recording);
  if (options.format == "pen") return read_pen_file(text);
  if (options.format != "auto") return read_pen_file(text, options.format);
  const bool known = !kind_of_pen_file(text).empty();
  return read_pen_file(text, known ? std::string_view() : kind_by_name(text.path));
}

void print_result(const ImportOptions& options, const Recording& recording, const ImportCounts& counts) {
  std::size_t samples = 0;
  for (const RecordedStroke& stroke : recording.strokes) samples += stroke.samples.size();
  if (options.json) {
    write_result(json_text({{"recording", options.recording},
                            {"out", options.out},
                            {"strokes", recording.strokes.size()},
                            {"samples", samples},
                            {"events", counts.events},
                            {"events_lifted", counts.lifted},
                            {"times_raised", counts.times_raised},
                            {"pressures_dropped", counts.pressures_dropped},
                            {"y_estimated_strokes", counts.estimated_y}}));
  } else {
    write_result(fmt::format("{}: {} strokes, {} samples of {} events; {} left out, the pen lifted\n",
                             options.out, recording.strokes.size(), samples, counts.events, counts.lifted));
  }
}

void warn_of_changes(const ImportCounts& counts) {
  if (counts.times_raised > 0)
    warn(fmt::format("times that fell within a stroke, raised to the one before: {}", counts.times_raised));
  if (counts.pressures_dropped > 0) {
    warn(fmt::format("strokes whose pressure is 0 although the pen touches the tablet, taken as without: {}",
                     counts.pressures_dropped));
  }
}

/// What the file does not tell.
void warn_of_estimates(const ImportCounts& counts) {
  if (counts.estimated_y == 0) return;
  warn(
      fmt::format("strokes beside typed text, whose y is estimated since the file does not tell the heights "
                  "of its lines: {}",
                  counts.estimated_y));
}

void list(const ImportOptions& options) {
  const PenFile file = read_recording(options);
  write_result(options.json ? json_text(listing_json(file)) : listing_text(file));
}

void import(const ImportOptions& options) {
  check_output_path(options.out);
  const LoadedSurface loaded = load_surface_on_console(options.mesh);
  const Camera camera = whole_view(loaded.surface, options.view);
  auto [recording, counts] =
      import_pen_file(options.recording, read_recording(options), options.import, camera, loaded.surface);
  move_origin(recording, -loaded.from.origin);
  for (RecordedStroke& stroke : recording.strokes) stroke.settings = options.settings;
  write_stroke_file(options.out, recording);
  print_result(options, recording, counts);
  warn_of_changes(counts);
  warn_of_estimates(counts);
}

void run(ImportOptions& options) {
  options.import.pressure_from_width = !options.pressure_from.empty();
  if (options.list) return list(options);
  if (options.mesh.path.empty()) throw CLI::RequiredError("--mesh");
  if (options.out.empty()) throw CLI::RequiredError("--out");
  import(options);
}

/// The options that say which strokes are taken, and what they become.
void add_stroke_options(CLI::App& command, PenImport& import, std::string& pressure_from) {
  command.add_option("--page", import.choice.page, "only strokes of this page, from 1")
      ->check(whole_number_from_1());
  command.add_option("--layer", import.choice.layer, "only strokes of this layer, from 1")
      ->check(whole_number_from_1());
  const auto fit = [&import](const std::string& word) {
    import.fit = word == "mesh" ? PenFit::mesh : PenFit::view;
  };
  choose(command.add_option_function<std::string>(
             "--fit", fit,
             "where a drawing is put: view, so that it fills the picture, or mesh, as large as possible "
             "with all samples on the mesh as seen in it"),
         {"view", "mesh"})
      ->default_str("view");
  command
      .add_option(
          "--speed", import.speed,
          "of the pen in strokes without times: pixels per second, or object units of strokes in space")
      ->check(positive_number());
  choose(command.add_option(
             "--pressure-from", pressure_from,
             "width: strokes without pressure get their width at each sample, 1 for the greatest one"),
         {"width"});
}

}  // namespace

void add_import(CLI::App& app) {
  const auto options = std::make_shared<ImportOptions>();
  CLI::App& command =
      *app.add_subcommand("import", "turn a pen recording into a .stroke file in front of a surface");
  command
      .add_option("recording", options->recording,
                  "a pen file of one of the kinds that recordings.md of the guide lists")
      ->required();
  choose(command.add_option("--format", options->format,
                            "of the recording; auto: pen if its first bytes are those of a pen file, else by "
                            "the name: pointer for .json, svc for .svc, else mypaint"),
         {"auto", "pen", "mypaint", "pointer", "svc"})
      ->capture_default_str();
  add_stroke_options(command, options->import, options->pressure_from);
  command.add_flag("--list", options->list, "only list the pages, layers and strokes of the recording");
  add_mesh_options(command, options->mesh);
  command.get_option("--mesh")->required(false);  // --list does without
  add_view_options(command, options->view);
  constexpr std::string_view keys[] = {"brush", "radius"};
  add_setting_options(command, options->settings, keys, "left open");
  command.add_option("--out", options->out, "file to write")->type_name("FILE.stroke");
  command.add_flag("--json", options->json, "write JSON to the standard output");
  command.callback([options] { run(*options); });
}

}  // namespace burin::command
