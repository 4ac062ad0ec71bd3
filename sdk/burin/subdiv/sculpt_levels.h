#pragma once
#include <burin/base/progress.h>
#include <burin/subdiv/refine.h>

#include <memory>
#include <span>
#include <vector>

namespace burin {

/// A subdivision surface that can be sculpted on each of its levels. The position of a vertex of level k + 1
/// is that given by the subdivision rules from level k, plus a detail vector in a frame of the subdivided
/// surface (DetailFrames): P[k+1] = S P[k] + F(S P[k]) detail[k+1]. So details rotate and bend with the
/// coarser levels. [Zorin, Schroeder, Sweldens 1997, Interactive Multiresolution Mesh Editing]
///
/// After a level was sculpted,
/// - finer levels keep their details on the new shape;
/// - vertices of coarser levels move by the weighted mean of the moves of the next level's vertices around
///   them; the weights are the transpose of linear interpolation: 4 for the vertex itself, 2 along an edge, 1
///   across a quad; the remainder becomes detail.
///
/// All levels are a function of the cage's positions and the details, bit for bit, so switching between
/// levels changes nothing. Without details the levels equal those of refine(), bit for bit. One thread; calls
/// use all threads of oneTBB inside. Needs about 210 bytes per vertex of the finest level, or 300 with Loop,
/// most of them for OpenSubdiv's topology.
class SculptLevels {
 public:
  /// Makes the levels from 0, the cage itself, to `finest` >= 1, without details. Throws the errors of
  /// refine(). Does not keep texture coordinates.
  SculptLevels(PolygonMesh cage, SubdivisionScheme scheme, int finest, const Progress& progress = {});
  ~SculptLevels();
  SculptLevels(SculptLevels&&) noexcept;
  SculptLevels& operator=(SculptLevels&&) noexcept;

  int finest() const;  ///< number of the finest level

  /// The positions of a level, object units, in the order of refine(). Valid until the next set_positions().
  /// Throws ContractError if there is no such level.
  std::span<const Vec3f> positions(int level) const;

  /// The triangles and positions of a level, in the order of refine(). Throws ContractError if there is no
  /// such level.
  TriangleMesh mesh(int level) const;

  /// Sets the positions of a level, as changed by strokes, and updates the other levels. Afterwards
  /// positions(level) is what was given, up to the rounding of details: at most 1e-6 of a detail's length.
  /// O(vertices of the finest level). Throws ContractError if there is no such level or the number of
  /// positions is wrong, and Error if a position is not finite; the levels are then unchanged.
  void set_positions(int level, std::span<const Vec3f> positions);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace burin
