#pragma once
#include <burin/base/progress.h>
#include <burin/subdiv/refine.h>

#include <memory>
#include <span>
#include <vector>

namespace burin {

/// A subdivision surface that is sculpted on all its levels. The vertices of level k + 1 stand where the
/// subdivision rules put them from level k, plus a detail each, in a frame of that subdivided surface
/// (DetailFrames): P[k+1] = S P[k] + F(S P[k]) detail[k+1]. So details turn and bend with what is coarser
/// than they are. [Zorin, Schroeder, Sweldens 1997, Interactive Multiresolution Mesh Editing]
///
/// What is sculpted on a level is
/// - new shape for the finer levels, which keep their details on it;
/// - seen on the coarser levels as far as they can show it: their vertices move by the mean of how those
/// around
///   them on the next level moved, weighted as the transpose of linear interpolation does (4 for the vertex
///   itself, 2 along an edge, 1 across a quad); what remains becomes detail.
///
/// All levels are a function of the cage's positions and the details alone, bit for bit, so going up and down
/// changes nothing. Without details the levels are what refine() gives, bit for bit. One thread; it uses all
/// threads of oneTBB inside. Takes about 210 bytes for each vertex of the finest level, with Loop 300, most
/// of them for OpenSubdiv's topology.
class SculptLevels {
 public:
  /// Levels 0, the cage itself, to `finest` >= 1, without details. Throws Error as refine(). Texture
  /// coordinates are not kept.
  SculptLevels(PolygonMesh cage, SubdivisionScheme scheme, int finest, const Progress& progress = {});
  ~SculptLevels();
  SculptLevels(SculptLevels&&) noexcept;
  SculptLevels& operator=(SculptLevels&&) noexcept;

  int finest() const;

  /// Object units, in the order of refine(). Valid until the next set_positions().
  std::span<const Vec3f> positions(int level) const;

  /// The level as refine() gives it; level 0 triangulated.
  TriangleMesh mesh(int level) const;

  /// Takes the positions that strokes left on a level, and lets the other levels follow. positions(level) is
  /// then what was given, up to the rounding of its details: 1e-6 of a detail's length at most. Costs in
  /// proportion to the finest level. Throws ContractError for a level that is not there or another number of
  /// positions, Error when one is not finite; the levels are as they were then.
  void set_positions(int level, std::span<const Vec3f> positions);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace burin
