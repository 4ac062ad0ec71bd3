#pragma once
#include <burin/feature/track.h>
#include <burin/stroke/given_settings.h>
#include <burin/stroke/recording.h>
#include <burin/surface/picker.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "input/mesh_input.h"
#include "snap/snap_picture.h"
#include "system/console.h"

namespace burin::command {

/// How the strokes of a file are snapped.
struct SnapJob {
  std::string strokes;     ///< the file, for messages
  GivenSettings settings;  ///< instead of the recorded ones
  SnapOptions snap;        ///< its radius is that of each stroke
  /// TrackOptions::most_edges: the strokes are lines that were snapped before, and are followed.
  std::optional<double> most_edges;
};

/// Snaps the strokes of a recording, one by one. The result has a stroke for each piece of a stroke that
/// leaves the surface on the way, or for each part of a line that is followed.
class SnappedRecording {
 public:
  /// All must outlive the object.
  SnappedRecording(const SnapJob& job, const LoadedSurface& loaded, const Picker& picker,
                   const Feature& feature);

  /// Snaps stroke `number`, from 0. Throws FileError if it does not meet the surface.
  void add(const Recording& recording, std::size_t number);

  const Recording& recording() const { return recording_; }
  const std::vector<SnappedStroke>& strokes() const { return snapped_; }
  double radius() const { return radius_; }          ///< greatest of the strokes
  const Json& json() const { return json_; }         ///< an element for each piece of a stroke
  const std::string& text() const { return text_; }  ///< a line for each

 private:
  void snap(const SurfaceCurve& piece, const SnapOptions& how, const RecordedStroke& stroke);
  void follow(const SurfaceCurve& piece, const TrackOptions& how, const RecordedStroke& stroke);
  void write(const RecordedStroke& stroke, const SurfaceCurve& curve);
  void say(const Json& json, const std::string& text);

  const SnapJob& job_;
  const LoadedSurface& loaded_;
  const Picker& picker_;
  const Feature& feature_;
  StrokeSnapper snapper_;
  LineTracker tracker_;
  Recording recording_;
  std::vector<SnappedStroke> snapped_;
  double radius_ = 0;
  std::size_t number_ = 0;  ///< of the stroke, from 1
  Json json_ = Json::array();
  std::string text_;
};

}  // namespace burin::command
