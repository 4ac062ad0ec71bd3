// The command `burin import`: converts a pen recording of another program to a `.stroke` file, with a camera
// that looks at the surface of the command.
#include <burin/base/error.h>
#include <burin/base/file.h>
#include <burin/ink/pen_strokes.h>
#include <burin/stroke/files/import.h>
#include <burin/stroke/move_origin.h>
#include <burin/stroke/stroke_file.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "command.h"
#include "input/mesh_input.h"
#include "options/setting_options.h"
#include "options/view.h"
#include "system/output_file.h"

namespace burin::command {
namespace {

struct ImportOptions {
  std::string recording, out, format = "auto";
  MeshOptions mesh;
  ViewOptions view;
  GivenSettings settings;
  PenChoice choice;
  bool json = false;
};

/// The format of a recording whose kind is to be found: by its bytes if it was opened, else by its name.
std::string format_of(const std::string& path, const std::optional<PenFileText>& opened) {
  const std::string_view kind = opened ? kind_of_pen_file(*opened) : std::string_view();
  if (kind == "pointer" || kind == "svc" || kind == "mypaint") return std::string(kind);
  if (!kind.empty()) return "pen";
  const std::filesystem::path extension = std::filesystem::path(path).extension();
  return extension == ".json" ? "pointer" : extension == ".svc" ? "svc" : "mypaint";
}

Import import_as(const ImportOptions& options, const Camera& camera) {
  const std::string& path = options.recording;
  const bool by_kind = options.format == "auto";
  // A pipe can be read only once.
  std::optional<PenFileText> opened;
  if (options.format == "pen" || (by_kind && std::filesystem::is_regular_file(path)))
    opened = open_pen_file(path);
  const std::string format = by_kind ? format_of(path, opened) : options.format;
  if (format == "pen") return import_pen_file(*opened, camera, options.choice);
  if (options.choice.page || options.choice.layer)
    throw FileError(path, "has neither pages nor layers, as --page and --layer ask for");
  if (format == "pointer") return import_pointer_events(path, camera);
  return format == "svc" ? import_svc(path, camera) : import_mypaint_events(path, camera);
}

Import read_recording(const ImportOptions& options, const Camera& camera) {
  Import import = import_as(options, camera);
  for (RecordedStroke& stroke : import.recording.strokes) stroke.settings = options.settings;
  return import;
}

void write_strokes(const std::filesystem::path& path, const Recording& recording) {
  StrokeWriter writer(path, recording.space, recording.camera, recording.device, PassLines::in_blocks);
  for (const RecordedStroke& stroke : recording.strokes) {
    writer.begin(stroke);
    for (const Sample& sample : stroke.samples) writer.add(sample);
    writer.end();
  }
  writer.flush();
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
                            {"pressures_dropped", counts.pressures_dropped}}));
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

void run(const ImportOptions& options) {
  check_output_path(options.out);
  const LoadedSurface loaded = load_surface_on_console(options.mesh);
  const Camera camera = seen_from(whole_view(loaded.surface, options.view), -loaded.from.origin);
  const auto [recording, counts] = read_recording(options, camera);
  replace_file(options.out, [&](const std::filesystem::path& partial) { write_strokes(partial, recording); });
  print_result(options, recording, counts);
  warn_of_changes(counts);
}

}  // namespace

void add_import(CLI::App& app) {
  const auto options = std::make_shared<ImportOptions>();
  CLI::App& command =
      *app.add_subcommand("import", "turn a pen recording into a .stroke file in front of a surface");
  command.add_option("recording", options->recording, "a pen file of any kind in docs/recordings.md")
      ->required();
  command
      .add_option("--format", options->format,
                  "of the recording; auto: pen if its first bytes are those of a pen file, else by the name: "
                  "pointer for .json, svc for .svc, else mypaint")
      ->check(CLI::IsMember({"auto", "pen", "mypaint", "pointer", "svc"}))
      ->capture_default_str();
  command.add_option("--page", options->choice.page, "only strokes of this page, from 1")
      ->check(CLI::PositiveNumber);
  command.add_option("--layer", options->choice.layer, "only strokes of this layer, from 1")
      ->check(CLI::PositiveNumber);
  add_mesh_options(command, options->mesh);
  add_view_options(command, options->view);
  constexpr std::string_view keys[] = {"brush", "radius"};
  add_setting_options(command, options->settings, keys, "left open");
  command.add_option("--out", options->out, "file to write")->required()->type_name("FILE.stroke");
  command.add_flag("--json", options->json, "write JSON to the standard output");
  command.callback([options] { run(*options); });
}

}  // namespace burin::command
