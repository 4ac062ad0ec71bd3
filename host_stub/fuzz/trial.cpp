// Draws a stroke in several ways through a session, which must agree.
#include "fuzz/trial.h"

#include <burin/base/parallel.h>
#include <burin/host/replay.h>
#include <burin/level_set/solid_mesh.h>
#include <burin/services/stamp_services.h>
#include <burin/stroke/files/setting_table.h>
#include <fmt/format.h>

#include <optional>

#include "input/brush_folder.h"
#include "input/suite_params.h"

namespace burin {
namespace {

/// The same stroke drawn in several ways on one surface.
class Drawing {
 public:
  Drawing(const BrushLibrary& library, const Trial& trial, const GivenSettings& settings)
      : session_(make_surface(trial.mesh), library, merge_solid) {
    recording_.strokes.push_back(trial.stroke);
    recording_.strokes.back().settings = settings;
  }

  /// The hash of what the stroke makes of the surface. Shown every so many samples, or as the trial says.
  std::uint64_t draw(std::optional<std::size_t> show_every = {}) {
    GivenSettings shown;
    if (show_every) shown[&ReplaySettings::show_every] = *show_every;
    const std::uint64_t hash = replay(session_, recording_, shown).hash;
    session_.undo();
    return hash;
  }

 private:
  Session session_;
  Recording recording_;
};

/// What the brush breaks, or nothing.
std::string broken_by(Drawing& drawing, const std::string& brush) {
  const std::uint64_t hash = drawing.draw();
  if (drawing.draw(0) != hash)
    return fmt::format("{}: drawn whole at its end the stroke differs from sample by sample", brush);
  const ThreadLimit one_thread(1);
  if (drawing.draw() != hash) return fmt::format("{}: drawn again on one thread the stroke differs", brush);
  return {};
}

}  // namespace

TrialResult run_trial(const std::filesystem::path& module, const std::filesystem::path& folder,
                      const Trial& trial) {
  BrushLibrary library(nullptr, stamp_services(read_vdb));
  load_module(library, module);
  GivenSettings settings;
  read_settings(JsonValue::of(nlohmann::json(trial.settings), "settings"), SettingsOf::suite, settings);
  settings = settings_of_suite((folder / "trial").string(), settings, library);
  try {
    Drawing drawing(library, trial, settings);
    const std::string broken = broken_by(drawing, trial.settings["brush"].get<std::string>());
    return {broken.empty() ? Outcome::kept : Outcome::broke, broken};
  } catch (const ContractError& error) {
    return {Outcome::broke, error.what()};
  } catch (const Error& error) {
    return {Outcome::refused, error.what()};
  } catch (const std::exception& error) {
    return {Outcome::broke, error.what()};
  }
}

}  // namespace burin
