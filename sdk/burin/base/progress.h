#pragma once
#include <functional>
#include <string_view>

namespace burin {

/// A callback that receives the progress of long work: the name of the stage and the finished share of it,
/// 0..1. Called on the thread that started the work, seldom enough to draw on a terminal. May be empty. An
/// exception that it throws ends the work, as any other failure does.
using Progress = std::function<void(std::string_view stage, double done)>;

/// Calls `progress` unless it is empty.
inline void report(const Progress& progress, std::string_view stage, double done) {
  if (progress) progress(stage, done);
}

}  // namespace burin
