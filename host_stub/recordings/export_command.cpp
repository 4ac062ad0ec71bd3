// The command `burin export`: writes recorded strokes in formats that other programs read.
#include <burin/stroke/stroke_file.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "command.h"
#include "recordings/opened_recording.h"
#include "recordings/written_strokes.h"
#include "system/console.h"
#include "system/output_file.h"

namespace burin::command {
namespace {

struct ExportOptions {
  std::vector<std::string> recordings;
  std::string out;
  bool json = false;
};

struct Counts {
  std::size_t strokes = 0, samples = 0, empty = 0;
};

Counts count(std::span<const Recording> recordings) {
  Counts counts;
  for (const Recording& recording : recordings)
    for (const RecordedStroke& stroke : recording.strokes) {
      ++(stroke.samples.empty() ? counts.empty : counts.strokes);
      counts.samples += stroke.samples.size();
    }
  return counts;
}

void run(const ExportOptions& options) {
  check_pen_file_name(options.out);
  check_output_path(options.out);
  std::vector<Recording> recordings;
  for (const std::string& path : options.recordings) {
    recordings.push_back(read_strokes(path));
    warn_if_cut_off(path, recordings.back().cut_off_at);
  }
  write_pen_file(options.out, recordings);
  const Counts counts = count(recordings);
  if (options.json) {
    write_result(json_text({{"out", options.out}, {"strokes", counts.strokes}, {"samples", counts.samples}}));
  } else {
    write_result(fmt::format("{}: {} strokes, {} samples\n", options.out, counts.strokes, counts.samples));
  }
  if (counts.empty > 0) warn(fmt::format("strokes without samples, left out: {}", counts.empty));
}

}  // namespace

void add_export(CLI::App& app) {
  const auto options = std::make_shared<ExportOptions>();
  CLI::App& command = *app.add_subcommand("export", "write recorded strokes as InkML or CSV");
  command.add_option("recordings", options->recordings, ".stroke files")
      ->required()
      ->type_name("FILE.stroke");
  command.add_option("--out", options->out, "file to write; its extension decides the format")
      ->required()
      ->type_name("FILE.inkml|FILE.csv");
  command.add_flag("--json", options->json, "write JSON to the standard output");
  command.callback([options] { run(*options); });
}

}  // namespace burin::command
