#pragma once
#include <burin/base/vector.h>
#include <burin/host/session.h>
#include <burin/subdiv/sculpt_levels.h>

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>

#include "input/mesh_input.h"

namespace burin {

/// The options of a replay's mesh.
struct ReplayMeshOptions {
  MeshOptions mesh;
  std::optional<int> sculpt_level;  ///< level on which strokes are drawn; default: the finest
};

/// Adds the options of add_mesh_options, and --sculpt-level.
void add_replay_mesh_options(CLI::App& command, ReplayMeshOptions& options);

/// The mesh of a replay. Strokes are drawn on one of its levels, and the result is the finest level.
class ReplayMesh {
 public:
  /// The uses of the result.
  struct Uses {
    bool baked = false;    ///< its displacement is baked to a map
    bool saved = false;    ///< it is saved to a file
    bool refined = false;  ///< strokes may refine the surface, which keep seams of texture coordinates
  };

  /// Reads and refines the mesh, with a progress bar and a warning that counts defects. Throws FileError as
  /// load_surface() does, and for a sculpt level above the finest, and for a mesh that cannot be baked.
  ReplayMesh(const ReplayMeshOptions& options, const Uses& uses);

  /// The surface to draw on. May be called once.
  Surface take_surface() { return std::move(drawn_.surface); }

  /// The colours and masks of that surface. May be called once.
  Paint take_paint() { return std::move(drawn_.paint); }

  /// Whether strokes are drawn on a level below the finest.
  bool has_levels() const { return levels_.has_value(); }

  /// On a mesh with levels: transfers the result of the session to the finest level. result_hash() is the
  /// hash of that level, as Session::result_hash().
  void finish(const Session& session);
  std::uint64_t result_hash() const;

  /// The finest level after the session, in the vertex order of the file or of the refinement. Requires
  /// finish() on a mesh with levels.
  TriangleMesh result(const Session& session) const;

  /// The finest level before any stroke, with texture coordinates; empty if it is neither baked nor saved and
  /// there are no levels.
  const TriangleMesh& before() const { return before_; }

  /// The result and its paint for saving: with the vertices and texture coordinates of the file if the mesh
  /// was not refined and no solid merged with it. Positions are relative to origin().
  TriangleMesh saved(const Session& session) const;
  VertexPaint saved_paint(const Session& session) const;

  /// The origin to which positions are relative; see PolygonMesh::origin.
  const Vec3d& origin() const { return drawn_.from.origin; }

  /// The results of mesh_json() and mesh_text() for the level of the strokes and the finest level.
  const Json& json() const { return json_; }
  const std::string& text() const { return text_; }

 private:
  void load(Cage cage, const Uses& uses, const Progress& progress);
  void load_levels(const Cage& cage, const Progress& progress);
  void describe(const MeshOptions& options);

  LoadedSurface drawn_;
  int drawn_level_ = 0;
  std::optional<SculptLevels> levels_;
  TriangleMesh before_;
  std::optional<PolygonMesh> apart_;  ///< see Cage::apart
  VertexPaint joined_paint_;
  Json json_;
  std::string text_;
};

}  // namespace burin
