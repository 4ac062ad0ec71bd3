#pragma once
#include <burin/host/session.h>
#include <burin/subdiv/sculpt_levels.h>

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "input/mesh_input.h"

namespace burin {

/// What a replay wants of its mesh.
struct ReplayMeshOptions {
  MeshOptions mesh;
  std::optional<int> sculpt_level;  ///< the level that strokes are drawn on; the finest unless given
};

/// Adds the options of add_mesh_options, and --sculpt-level.
void add_replay_mesh_options(CLI::App& command, ReplayMeshOptions& options);

/// The mesh of a replay: strokes are drawn on one level of it, and its result is the finest.
class ReplayMesh {
 public:
  /// What is to become of the result.
  struct Uses {
    bool baked = false;  ///< its displacement becomes a map
    bool saved = false;
  };

  /// Reads and refines, with a progress bar and a warning that counts defects. Throws FileError: as
  /// load_surface, a level above the finest, a mesh that cannot be baked.
  ReplayMesh(const ReplayMeshOptions& options, const Uses& uses);

  /// The surface to draw on. To be called once.
  Surface take_surface() { return std::move(drawn_.surface); }

  /// What is painted on it. To be called once.
  Paint take_paint() { return std::move(drawn_.paint); }

  /// Whether strokes are drawn on a level below the finest.
  bool has_levels() const { return levels_.has_value(); }

  /// Where there are levels: brings what the session drew up to the finest, and names that as
  /// Session::result_hash does.
  void finish(const Session& session);
  std::uint64_t result_hash() const;

  /// The finest level in the order of the file or of the refinement, as the session left it; finished.
  TriangleMesh result(const Session& session) const;

  /// The same before any stroke, with its texture coordinates when it is to be baked or saved; without that
  /// and without levels nothing.
  const TriangleMesh& before() const { return before_; }

  /// The result with the vertices and texture coordinates of the file where it was not refined, and what is
  /// painted on it; to be saved from origin() on.
  TriangleMesh saved(const Session& session) const;
  VertexPaint saved_paint(const Session& session) const;

  /// Where positions are counted from.
  const Vec3d& origin() const { return drawn_.from.origin; }

  /// As mesh_json() and mesh_text(), of the level drawn on and of the finest.
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
  std::optional<PolygonMesh> apart_;  ///< as Cage::apart, and with it its paint after joining
  VertexPaint joined_paint_;
  Json json_;
  std::string text_;
};

}  // namespace burin
