// Draws the last stroke again and again, each time with the module as it is by then. A stroke that cannot be
// drawn leaves the surface without it, and the watch goes on.
#include "watch/watch.h"

#include <burin/abi/brush.h>
#include <burin/host/plugin/param_snapshot.h>
#include <burin/host/replay.h>
#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <span>
#include <utility>

#include "pictures/result_picture.h"
#include "system/console.h"
#include "watch/module_watch.h"

namespace burin {
namespace {

/// Whether a brush takes this value of a parameter; says why not.
bool takes(const burin_brush_descriptor& brush, const std::string& name, const ParamSetting& setting) {
  const std::span params(brush.params, brush.param_count);
  const auto info = std::ranges::find_if(params, [&](const auto* param) { return param->id == name; });
  try {
    if (info == params.end()) throw Error(fmt::format("{} has no parameter '{}' any more", brush.id, name));
    resolve_param(brush, **info, &setting);
    return true;
  } catch (const Error& error) {
    warn(error.what());
    return false;
  }
}

/// Leaves out values that the brush does not take any more.
void keep_taken(GivenSettings& settings, const burin_brush_descriptor& brush) {
  if (settings.find(&StrokeSettings::params))
    std::erase_if(settings[&StrokeSettings::params],
                  [&](const auto& param) { return !takes(brush, param.first, param.second); });
}

/// The id of the brush that draws the last stroke.
std::string brush_of_last(const Recording& recording, const GivenSettings& settings) {
  return replay_settings(recording.strokes.back(), recording.strokes.size() - 1, settings).brush;
}

/// The last stroke, drawn again by each version of the module.
class LastStroke {
 public:
  explicit LastStroke(Watched watched)
      : watched_(std::move(watched)), number_(watched_.recording.strokes.size() - 1) {}

  /// Undoes the stroke, if it is there, loads the module anew and draws the stroke again.
  WatchedStroke draw_again(const std::filesystem::path& module) {
    watched_.brushes.reload(module);
    const burin_brush_descriptor& descriptor = *watched_.brushes.find(brush_).descriptor;
    keep_taken(watched_.settings, descriptor);
    GivenSettings& recorded = watched_.recording.strokes[number_].settings;
    // Those of another brush are left out anyway.
    if (const std::string* brush = recorded.find(&StrokeSettings::brush); brush && *brush == brush_)
      keep_taken(recorded, descriptor);
    if (drawn_) watched_.session.undo();
    drawn_ = false;
    const ReplayResult result = replay(watched_.session, watched_.recording, watched_.settings, {}, number_);
    drawn_ = result.pieces > 0;
    warn_of_news();
    return measured(result);
  }

  bool drawn() const { return drawn_; }
  const Watched& watched() const { return watched_; }

 private:
  WatchedStroke measured(const ReplayResult& result);

  /// Says what the session has to say since the last time.
  void warn_of_news() {
    const std::span<const std::string> warnings = watched_.session.warnings();
    for (const std::string& line : warnings.subspan(std::min(warned_, warnings.size()))) warn(line);
    warned_ = warnings.size();
  }

  Watched watched_;
  std::size_t number_;
  std::string brush_ = brush_of_last(watched_.recording, watched_.settings);
  std::size_t warned_ = watched_.session.warnings().size();
  bool drawn_ = true;  ///< on the surface
};

WatchedStroke LastStroke::measured(const ReplayResult& result) {
  WatchedStroke stroke;
  EventCost cost;
  for (const auto* costs : {&result.costs, &result.end_costs})
    for (const EventCost& event : *costs) cost += event;
  for (const auto* seconds : {&result.latencies, &result.end_latencies})
    stroke.seconds = std::accumulate(seconds->begin(), seconds->end(), stroke.seconds);
  const auto evaluated = static_cast<double>(std::max<std::uint64_t>(cost.evaluated, 1));
  stroke.nanoseconds_per_node = 1e9 * cost.seconds[static_cast<std::size_t>(Stage::evaluate)] / evaluated;
  stroke.brush = brush_;
  stroke.hash = result.hash;
  const Session& session = watched_.session;
  stroke.picture = std::exchange(watched_.picture, {});
  if (watched_.camera && stroke.picture.rgb.empty())
    stroke.picture = draw_result(session, part_meshes(session), *watched_.camera);
  return stroke;
}

}  // namespace

std::filesystem::path module_of_last(const BrushLibrary& brushes, const Recording& recording,
                                     const GivenSettings& settings) {
  return brushes.find(brush_of_last(recording, settings)).module;
}

void watch(Watched given) {
  LastStroke stroke(std::move(given));
  const Watched& watched = stroke.watched();
  const std::filesystem::path module = module_of_last(watched.brushes, watched.recording, watched.settings);
  ModuleWatch file(module);
  WatchedStroke before = stroke.draw_again(module);
  if (!stroke.drawn()) throw Error("the last stroke does not meet the surface");
  write_result(fmt::format("watching {}\n", module.string()));
  flush_results();
  for (int change = 0; watched.changes == 0 || change < watched.changes; ++change) {
    file.wait();
    try {
      WatchedStroke after = stroke.draw_again(module);
      write_result(fmt::format("before  {}\nafter   {}\n", stroke_text(before), stroke_text(after)));
      if (watched.camera) watched.show(before, after);
      before = std::move(after);
    } catch (const Error& error) {
      warn(error.what());
    }
    flush_results();
  }
}

}  // namespace burin
