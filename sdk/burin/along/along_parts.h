#pragma once
#include <burin/along/source_part.h>
#include <burin/stroke/stroke_settings.h>
#include <burin/surface/triangle_mesh.h>
#include <burin/volume/solid.h>

#include <functional>
#include <optional>

namespace burin {

/// What meshes are bent along. Non-owning.
struct BentStroke {
  const SolidGround& ground;                   ///< whose chart reaches AlongParts::chart_radii
  double radius = 0;                           ///< object units; half the width of the meshes
  std::function<double(double t)> width = {};  ///< share of the radius, above 0 and up to 1; any thread
  bool mirrored = false;                       ///< d of the meshes is negated
};

/// Meshes that are bent along strokes.
class AlongParts {
 public:
  /// How many radii the chart of a stroke must reach to either side, so that there are triangles up to one.
  static constexpr double chart_radii = 1.5;

  /// Takes the meshes, and reads files of which there is no mesh. Throws FileError as read_mesh(), and Error,
  /// naming the file, for a mesh that cannot be bent.
  explicit AlongParts(const AlongSettings& settings);

  /// Bends them along a stroke: object units, counter-clockwise seen from outside if the meshes are. Edges
  /// are split where they would leave the bend by more than 1/500 of the radius. Where copies meet and both
  /// are open there, equal vertices become one. Texture coordinates if any of the meshes has some. Throws
  /// Error where that would take more than 20 million triangles. The bits do not depend on the number of
  /// threads.
  TriangleMesh bend(const BentStroke& stroke) const;

 private:
  double widest(const SourcePart& part) const;

  AlongSettings settings_;  ///< without the meshes
  SourcePart middle_;
  std::optional<SourcePart> start_, end_;
  double half_width_ = 0;  ///< that becomes the radius, in units of the meshes
  bool with_uv_ = false;
};

}  // namespace burin
