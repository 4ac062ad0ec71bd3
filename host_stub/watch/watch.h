#pragma once
#include <burin/host/session.h>
#include <burin/stroke/camera.h>
#include <burin/stroke/given_settings.h>
#include <burin/stroke/recording.h>

#include <filesystem>
#include <functional>
#include <optional>

#include "watch/watch_page.h"

namespace burin {

/// The module of the brush that draws the last stroke of a recording. Throws Error if there is none.
std::filesystem::path module_of_last(const BrushLibrary& brushes, const Recording& recording,
                                     const GivenSettings& settings);

/// What `burin replay --watch` and `burin try --watch` go on with when all strokes are drawn.
struct Watched {
  Session& session;
  BrushLibrary& brushes;
  Recording recording;           ///< the one drawn last, whose last stroke is drawn again and again
  GivenSettings settings;        ///< instead of the recorded ones
  std::optional<Camera> camera;  ///< of the pictures; none without it
  std::function<void(const WatchedStroke& before, const WatchedStroke& after)>
      show;              ///< called after each change, if there is a camera
  int changes = 0;       ///< after so many changes of the module it is over; 0: it goes on
  Picture picture = {};  ///< of the stroke as it is now; drawn if it is empty
};

/// Loads the module of the last stroke's brush anew whenever it changes, draws the stroke again, and tells
/// times and hashes before and after. A module that cannot be loaded or fails is told, and the next change
/// waited for. Throws Error if the last stroke is drawn with no brush or draws nothing.
void watch(Watched watched);

}  // namespace burin
