// The command `burin strokes`: tells what recordings hold, draws them, and writes them mended.
#include <burin/base/error.h>
#include <burin/base/file.h>
#include <burin/ink/import_pen_file.h>
#include <burin/ink/mend.h>
#include <burin/stroke/move_origin.h>
#include <burin/stroke/stroke_file.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "command.h"
#include "input/mesh_input.h"
#include "input/name_file.h"
#include "options/options.h"
#include "options/view.h"
#include "recordings/facts_report.h"
#include "recordings/opened_recording.h"
#include "recordings/strokes_picture.h"
#include "recordings/written_strokes.h"
#include "system/output_file.h"

namespace burin::command {
namespace {

struct StrokesOptions {
  std::vector<std::string> files;
  std::string png, out;
  MeshOptions mesh;
  ViewOptions view;
  std::optional<LineColour> colour;
  std::optional<double> split, join, resample;
  bool fix = false, json = false;

  bool edits() const { return fix || split || join || resample; }
};

std::vector<std::string> edit(Recording& recording, const StrokesOptions& options) {
  std::vector<std::string> did;
  if (const auto line = std::exchange(recording.cut_off_at, std::nullopt))
    did.push_back(fmt::format("line {}: the recording was cut off here; its last stroke ends there", *line));
  const auto note = [&](const std::vector<std::string>& lines) {
    did.insert(did.end(), lines.begin(), lines.end());
  };
  if (options.fix) note(mend(recording));
  if (options.split) note(split(recording, *options.split));
  if (options.join) note(join(recording, *options.join));
  if (options.resample) note(resample(recording, *options.resample));
  return did;
}

void write_edited(const StrokesOptions& options, const OpenedRecording& opened, const Recording& edited,
                  bool changed) {
  if (!changed && opened.file.kind == written_kind(options.out) &&
      std::filesystem::is_regular_file(options.files[0])) {
    const std::string bytes = read_file(options.files[0]);
    write_file_whole(options.out, [&](std::ostream& out) { out << bytes; });
  } else if (opened.strokes && written_kind(options.out) == "stroke") {
    write_stroke_file(options.out, edited);
  } else {
    write_pen_file(options.out, {&edited, 1});
  }
}

void run_edits(const StrokesOptions& options) {
  check_output_path(options.out);
  const std::string& path = options.files[0];
  const OpenedRecording opened = open_recording(path);
  if (!opened.strokes || written_kind(options.out) != "stroke") check_pen_file_name(options.out);
  Recording recording = opened.strokes ? *opened.strokes : recording_of(opened.file);
  const std::vector<std::string> did = with_file_context(path, [&] { return edit(recording, options); });
  write_edited(options, opened, recording, !did.empty());
  if (options.json) {
    write_result(json_text({{"file", path}, {"out", options.out}, {"did", did}}));
    return;
  }
  for (const std::string& line : did) write_result(fmt::format("{}: {}\n", path, line));
  if (did.empty()) write_result(fmt::format("{}: nothing to do\n", path));
}

/// The recording where the picture shows it: on the mesh, if there is one.
Picture draw(const StrokesOptions& options, const OpenedRecording& opened, const Recording& flat,
             LineColour colour) {
  if (options.mesh.path.empty())
    return picture_in_plane(flat, colour, options.view.width, options.view.height);
  const LoadedSurface loaded = load_surface_on_console(options.mesh);
  const Camera camera = whole_view(loaded.surface, options.view);
  if (!opened.strokes) {
    const Import import =
        import_pen_file(options.files[0], opened.file, {.fit = PenFit::mesh}, camera, loaded.surface);
    return picture_on_surface(import.recording, colour, loaded.surface);
  }
  Recording recording = flat;
  move_origin(recording, loaded.from.origin);
  if (!recording.camera) recording.camera = camera;
  return picture_on_surface(recording, colour, loaded.surface);
}

void run_picture(const StrokesOptions& options) {
  check_output_path(options.png);
  const OpenedRecording opened = open_recording(options.files[0]);
  warn_if_cut_off(options.files[0], opened.cut_off_at());
  const Recording flat = opened.strokes ? *opened.strokes : recording_of(opened.file);
  const bool pressed = coloured_range(flat, LineColour::pressure).has_value();
  const LineColour colour = options.colour.value_or(pressed ? LineColour::pressure : LineColour::speed);
  write_png(options.png, draw(options, opened, flat, colour));
  const std::string name = colour == LineColour::pressure ? "pressure" : "speed";
  const std::optional<ValueRange> range = coloured_range(flat, colour);
  if (options.json) {
    write_result(json_text({{"file", options.files[0]},
                            {"png", options.png},
                            {"colour", range ? Json(name) : Json(nullptr)},
                            {"range", range ? Json{range->least, range->most} : Json(nullptr)}}));
  } else {
    write_result(options.png +
                 (range ? fmt::format(": {} {:.4g} blue to {:.4g} yellow\n", name, range->least, range->most)
                        : fmt::format(": the strokes have no {}\n", name)));
  }
}

void run_facts(const StrokesOptions& options) {
  Json list = Json::array();
  std::string text;
  for (const std::string& path : options.files) {
    const OpenedRecording opened = open_recording(path);
    warn_if_cut_off(path, opened.cut_off_at());
    if (options.json)
      list.push_back(facts_json(path, opened.file));
    else
      text += facts_text(path, opened.file);
  }
  write_result(options.json ? json_text(list) : text);
}

void run(const StrokesOptions& options) {
  if (options.edits() != !options.out.empty())
    throw CLI::ValidationError("--out", "goes with --fix, --split, --join and --resample");
  if (options.edits() && !options.png.empty())
    throw CLI::ValidationError("--png", "draws what a file holds; draw the mended file by another call");
  if ((options.edits() || !options.png.empty()) && options.files.size() != 1)
    throw CLI::ValidationError("files", "one file is drawn or mended at a time");
  if (options.png.empty() && !options.mesh.path.empty())
    throw CLI::ValidationError("--mesh", "goes with --png");
  if (options.edits())
    run_edits(options);
  else if (!options.png.empty())
    run_picture(options);
  else
    run_facts(options);
}

void add_picture_options(CLI::App& command, StrokesOptions& options) {
  command.add_option("--png", options.png, "draw the strokes of one file")->type_name("FILE");
  const auto colour = [&options](const std::string& word) {
    options.colour = word == "speed" ? LineColour::speed : LineColour::pressure;
  };
  choose(command.add_option_function<std::string>(
             "--colour", colour,
             "what the lines of --png are coloured by: pressure (the default if there is any) or speed"),
         {"pressure", "speed"});
  add_mesh_options(command, options.mesh);
  command.get_option("--mesh")->required(false);  // without, --png draws in the plane
  add_view_options(command, options.view);
}

void add_edit_options(CLI::App& command, StrokesOptions& options) {
  command.add_flag("--fix", options.fix,
                   "mend order, duplicates, packets of equal times, wild samples and hooks of one file");
  command
      .add_option("--split", options.split, "begin a new stroke after a pause of more than so many seconds")
      ->check(number_from_0());
  command
      .add_option("--join", options.join,
                  "join strokes that begin at most so many seconds after the one before ends")
      ->check(number_from_0());
  command.add_option("--resample", options.resample, "samples at even times, so many to the second")
      ->check(positive_number());
  command
      .add_option("--out", options.out,
                  "file to write what these four make of one file; a .stroke file stays one or is exported")
      ->type_name("FILE.stroke|FILE.inkml|FILE.csv");
}

}  // namespace

void add_strokes(CLI::App& app) {
  const auto options = std::make_shared<StrokesOptions>();
  CLI::App& command =
      *app.add_subcommand("strokes", "tell what recordings hold, draw them or write them mended");
  command
      .add_option("files", options->files,
                  ".stroke files, and pen files of the kinds that recordings.md of the guide lists")
      ->required();
  add_picture_options(command, *options);
  add_edit_options(command, *options);
  command.add_flag("--json", options->json,
                   "write JSON to the standard output: a list with an object per file");
  command.callback([options] { run(*options); });
}

}  // namespace burin::command
