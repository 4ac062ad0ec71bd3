#pragma once
#include <burin/host/brush_library.h>
#include <burin/host/session/refine_path.h>
#include <burin/stroke/pen.h>
#include <burin/stroke/stroke_settings.h>
#include <burin/surface/picker.h>

#include <optional>
#include <variant>
#include <vector>

namespace burin {

/// A sample as the application gave it.
struct GivenSample {
  std::variant<Ray, Vec3d> at;
  double time;
  Pen pen;
};

/// All that an open stroke was given, to draw it again on a surface that was refined for it.
struct GivenSamples {
  struct Piece {
    std::vector<GivenSample> samples;
    std::vector<Vec3d> places;  ///< [sample] where it is on the surface, object units
    std::optional<Closure> ended;
  };

  GivenSamples(const BrushEntry* of, StrokeSettings with)
      : entry(of), settings(std::move(with)), on_fine(settings.refining.kind != Refining::Kind::automatic) {}

  /// The settings for the surface as it is: it is as if there was no refinement where there is nothing to
  /// refine.
  StrokeSettings settings_now() const {
    StrokeSettings now = settings;
    if (!on_fine) now.refining = {};
    return now;
  }

  /// `place`: where it is on the surface, object units.
  void add(const GivenSample& sample, const Vec3d& place) {
    length += step_to(place).length();
    if (pieces.back().ended) pieces.emplace_back();
    pieces.back().samples.push_back(sample);
    pieces.back().places.push_back(place);
    last = place;
  }
  void end_piece(Closure closure) {
    if (!pieces.back().samples.empty()) pieces.back().ended = closure;
  }
  PenStep step_to(const Vec3d& place) const {
    const bool begins = pieces.back().ended || pieces.back().samples.empty();
    return {begins ? place : last, place, length};
  }

  const BrushEntry* entry;  ///< null for none
  StrokeSettings settings;
  bool on_fine;  ///< triangles near the stroke are small, whatever those elsewhere are
  std::vector<Piece> pieces{1};
  Vec3d last = Vec3d::Zero();
  double length = 0;
};

}  // namespace burin
