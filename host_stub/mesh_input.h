#pragma once
#include <burin/deform/paint.h>
#include <burin/subdiv/refine.h>
#include <burin/surface/surface.h>

#include <optional>
#include <string>

#include "cli_fwd.h"
#include "console.h"

namespace burin {

/// The surface that a command works on, as the command line names it.
struct MeshOptions {
  std::string path;
  std::optional<int> subdivide;                 ///< levels
  std::optional<std::size_t> target_triangles;  ///< subdivide until there are at least so many
  std::optional<SubdivisionScheme> scheme;      ///< the cage's natural one unless given
};

/// Adds --mesh, --subdivide, --target-triangles and --scheme.
void add_mesh_options(CLI::App& command, MeshOptions& options);

struct LoadedSurface {
  Surface surface;
  std::string defects;  ///< of a mesh that was not refined, counted; empty for none
  Paint paint = {};     ///< on the surface's vertices, where the file has colours or masks
};

/// A mesh as its file has it, though painted only where it is not to be refined, and how far the options ask
/// to refine it.
struct Cage {
  PolygonMesh polygons;
  SubdivisionScheme scheme;
  int level;
};

/// Warns of paint that refinement loses. Throws FileError, for a point set too.
Cage read_cage(const MeshOptions& options);

/// Makes triangles of a cage's `level` ready for strokes; texture coordinates are left behind. `paint`: of
/// the vertices, or nothing.
LoadedSurface make_loaded(TriangleMesh mesh, int level, const VertexPaint& paint, const Progress& progress);

/// Reads the mesh, refines or triangulates it and makes it ready. Throws FileError, for a point set too.
LoadedSurface load_surface(const MeshOptions& options, const Progress& progress);

/// As load_surface, with a progress bar and a warning that counts the defects.
LoadedSurface load_surface_on_console(const MeshOptions& options);

/// As load_surface_on_console, of a mesh or of a point set.
LoadedSurface load_mesh_or_points_on_console(const MeshOptions& options);

/// File, vertices, triangles and defects.
Json mesh_json(const MeshOptions& options, const LoadedSurface& loaded);

/// "FILE: 12 vertices, 34 triangles" or "FILE: 12 points".
std::string mesh_text(const MeshOptions& options, const LoadedSurface& loaded);

}  // namespace burin
