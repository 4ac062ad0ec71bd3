#pragma once
#include <burin/stroke/stroke_file.h>
#include <burin/stroke/stroke_settings.h>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string_view>

namespace burin {

/// Records what a user draws, beside the session that draws it, as a `.stroke` file that replay() and `burin
/// replay` draw again:
///   StrokeRecorder recorder("session.stroke", StrokeSpace::object, {}, "Intuos Pro M");
///   StrokePieces stroke(session, recorder.begin(settings, fields));
///   recorder.add({time, position, pen}), stroke.add(position, time, pen);  // for every sample
///   recorder.end(), stroke.end();
/// On a copy of the surface that the session began with, the replay has the session's result_hash(), provided
/// that
/// - the strokes were drawn by StrokePieces with the settings that begin() returned, and none was undone;
/// - in screen space, rays were pixel_ray() of the recorder's camera. A recording has one camera: begin
///   another one when the view changes, or record positions in object space;
/// - time stamps of a stroke rise. replay() spreads equal ones, see spread_times().
///
/// Every call passes its line to the operating system before it returns: a process that is killed loses at
/// most the line that it is writing, and read_strokes() reads what there is. One thread, which need not be
/// the session's. All functions throw FileError if the file cannot be written.
class StrokeRecorder {
 public:
  /// Creates or replaces the file. In screen space samples are pixels of the camera's viewport, from the top
  /// left corner; in object space a camera is optional. `device`: name of the tablet or the like, UTF-8; may
  /// be empty. Throws ContractError for a missing camera, or one with an empty viewport or without an
  /// inverse.
  StrokeRecorder(const std::filesystem::path& path, StrokeSpace space,
                 const std::optional<Camera>& camera = {}, std::string_view device = {});

  /// Begins a stroke. `settings` need brush and radius. Returns what replay() will draw it with, seed and
  /// pen fields included; settings that recordings do not keep (docs/stroke_format.md) have their defaults
  /// in it. Throws ContractError within a stroke, for values out of range and for a tool whose name is not
  /// UTF-8, Error if brush or radius lack; nothing is written then.
  ReplaySettings begin(const GivenSettings& settings, const PenFields& fields, DrawnBy drawn_by = {});

  /// Adds a sample of the open stroke, whether or not it hits the surface. Throws ContractError, without
  /// writing, for values that are not finite, pressure outside 0..1, and time that falls.
  void add(const Sample& sample) { writer_.add(sample); }

  /// Ends the open stroke. ContractError if none is.
  void end() { writer_.end(); }

 private:
  StrokeWriter writer_;
  std::size_t strokes_ = 0;  ///< begun so far
};

}  // namespace burin
