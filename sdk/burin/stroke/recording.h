#pragma once
#include <burin/stroke/camera.h>
#include <burin/stroke/given_settings.h>
#include <burin/stroke/pen.h>

#include <optional>
#include <string>
#include <vector>

namespace burin {

/// The space of a recording's samples.
enum class StrokeSpace {
  object,  ///< positions near the surface, object units
  screen,  ///< pixels from the top left corner of the viewport; z is not used
};

/// One event of the pen.
struct Sample {
  double time = 0;  ///< seconds
  Vec3d position = Vec3d::Zero();
  Pen pen;
  bool barrel = false;  ///< a button at the pen's side is held
};

/// What drew a stroke, as far as it is known.
struct DrawnBy {
  std::string tool = {};  ///< "pen", "touch", "mouse" or the like; empty if unknown
  bool eraser = false;    ///< the pen's eraser, or an eraser tool

  bool operator==(const DrawnBy&) const = default;
};

/// One stroke of a recording. Settings that the file does not have are not given; the caller must supply
/// them.
struct RecordedStroke {
  GivenSettings settings;  ///< the rows of the setting table marked as recorded
  PenFields fields;
  std::vector<Sample> samples;  ///< finite as floats, pressure 0..1, time not falling
  DrawnBy drawn_by = {};
};

/// The content of a `.stroke` file.
struct Recording {
  StrokeSpace space = StrokeSpace::object;
  std::optional<Camera> camera;  ///< never empty for StrokeSpace::screen
  std::string device;            ///< name of what the pen was drawn with; empty if unknown
  std::vector<RecordedStroke> strokes;
  /// The line (from 1) at which the file was cut off: either this last line was incomplete and left out, or
  /// the last stroke has no end and holds the samples that were written.
  std::optional<std::size_t> cut_off_at;
};

}  // namespace burin
