// Writes what failed as a folder, and reads and draws it again.
#include "fuzz/bundle.h"

#include <burin/base/file.h>
#include <burin/stroke/files/setting_table.h>
#include <burin/stroke/stroke_file.h>
#include <burin/surface/mesh_file.h>
#include <burin/surface/triangulate.h>
#include <fmt/format.h>

#include <stdexcept>

#include "fuzz/fuzz_case.h"
#include "report/report_folder.h"
#include "system/console.h"
#include "system/time_limit.h"

namespace burin {
namespace fs = std::filesystem;

namespace {

constexpr const char* description = "bundle.json";
constexpr const char* stroke_file = "stroke.stroke";
constexpr const char* surface_file = "surface.ply";

/// The stroke with the settings that recordings have, so that `burin replay` draws it by itself, too.
void write_stroke(const fs::path& path, const Trial& trial) {
  RecordedStroke stroke = trial.stroke;
  read_settings(JsonValue::of(nlohmann::json(trial.settings), "settings"), SettingsOf::recording,
                stroke.settings);
  StrokeWriter writer(path, StrokeSpace::object, {});
  writer.begin(stroke);
  for (const Sample& sample : stroke.samples) writer.add(sample);
  writer.end();
}

/// Whether the trial names the file.
bool uses(const Trial& trial, const char* file) {
  const Json flat = trial.settings.flatten();
  for (const auto& [place, value] : flat.items())
    if (value == file) return true;
  return false;
}

}  // namespace

void write_bundle(const fs::path& folder, const Bundle& bundle, const fs::path& files) {
  make_report_folder(folder.string());
  write_stroke(folder / stroke_file, bundle.trial);
  write_mesh(folder / surface_file, bundle.trial.mesh);
  for (const char* file : fuzz_files)
    if (uses(bundle.trial, file))
      fs::copy_file(files / file, folder / file, fs::copy_options::overwrite_existing);
  const Json json = {{"burin_bundle", 1},
                     {"failure", bundle.failure},
                     {"module", bundle.module.string()},
                     {"time_limit", bundle.time_limit},
                     {"settings", bundle.trial.settings}};
  // The failure may hold bytes of the plugin that are no UTF-8.
  write_text(folder / description, json_text(json));
}

Bundle read_bundle(const fs::path& folder) {
  const fs::path path = folder / description;
  const std::string text = read_file(path);
  const JsonValue json = JsonValue::parse(text, path.string());
  if (const auto version = json.find("burin_bundle"); !version || version->number() != 1)
    throw FileError(path.string(), "is no bundle that this version reads");
  Bundle bundle{json.member("module").text(), json.member("failure").text(), {}};
  if (const auto limit = json.find("time_limit")) bundle.time_limit = limit->number();
  json.member("settings").member("brush").text();
  bundle.trial.settings = Json::parse(text)["settings"];
  const Recording recording = read_strokes(folder / stroke_file);
  if (recording.strokes.size() != 1)
    throw FileError((folder / stroke_file).string(), "holds other than one stroke");
  bundle.trial.stroke = recording.strokes[0];
  bundle.trial.mesh = triangulate(read_mesh(folder / surface_file));
  return bundle;
}

void replay_bundle(const fs::path& folder) {
  const Bundle bundle = read_bundle(folder);
  if (!fs::is_regular_file(bundle.module))
    throw FileError(bundle.module.string(), "is not there; bundle.json names the module");
  write_result(fmt::format("{}\nfailed: {}\ntime limit: {} seconds, none in a debugger\n",
                           bundle.module.string(), bundle.failure, bundle.time_limit));
  flush_results();
  const TimeLimit limit(bundle.time_limit,
                        fmt::format("fails again: did not end within {} seconds", bundle.time_limit));
  const TrialResult result = run_trial(bundle.module, folder, bundle.trial);
  if (result.outcome == Outcome::broke) throw std::runtime_error("fails again: " + result.text);
  write_result(result.outcome == Outcome::kept ? "does not fail any more\n"
                                               : "the brush refuses it: " + result.text + "\n");
}

}  // namespace burin
