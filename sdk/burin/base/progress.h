#pragma once
#include <functional>
#include <string_view>

namespace burin {

/// Told of long work: the name of the stage and the share of it that is done, 0..1. Called on the thread
/// that started the work, seldom enough to draw on a terminal. Empty when nobody listens.
using Progress = std::function<void(std::string_view stage, double done)>;

inline void report(const Progress& progress, std::string_view stage, double done) {
  if (progress) progress(stage, done);
}

}  // namespace burin
