#pragma once
#include <burin/stroke/camera.h>
#include <burin/stroke/dynamics.h>
#include <burin/stroke/param_setting.h>
#include <burin/stroke/pen.h>

#include <optional>
#include <string>
#include <vector>

namespace burin {

enum class StrokeSpace {
  object,  ///< samples are places near the surface, object units
  screen,  ///< samples are pixels from the top left; z is not used
};

struct Sample {
  double time = 0;  ///< seconds
  Vec3d position = Vec3d::Zero();
  Pen pen;
};

/// One stroke as it was drawn. What the file leaves open is empty and must come from elsewhere.
struct RecordedStroke {
  std::optional<std::string> brush;
  std::optional<double> radius;  ///< object units, > 0
  double strength = 1;
  std::optional<double> follow;  ///< 0..1, how much of the relief it feels, see StrokeSettings
  bool closed = false;
  ParamSettings params;
  std::vector<Dynamic> dynamics;
  PenFields fields;
  std::vector<Sample> samples;  ///< finite as floats, pressure 0..1, time not falling
};

/// A `.stroke` file.
struct Recording {
  StrokeSpace space = StrokeSpace::object;
  std::optional<Camera> camera;  ///< always there for StrokeSpace::screen
  std::vector<RecordedStroke> strokes;
  /// The recorder stopped in the middle, at this line (from 1): a last line that was cut off has been left
  /// out, or the last stroke has no end and holds the samples that were written.
  std::optional<std::size_t> cut_off_at;
};

}  // namespace burin
