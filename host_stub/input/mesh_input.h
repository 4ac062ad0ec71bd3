#pragma once
#include <burin/deform/paint.h>
#include <burin/subdiv/refine.h>
#include <burin/surface/surface.h>

#include <optional>
#include <string>

#include "cli_fwd.h"
#include "system/console.h"

namespace burin {

/// The surface that a command works on, as the command line names it.
struct MeshOptions {
  std::string path;
  std::optional<int> subdivide;                 ///< levels
  std::optional<std::size_t> target_triangles;  ///< subdivide until there are at least so many
  std::optional<SubdivisionScheme> scheme;      ///< the cage's natural one unless given
  std::optional<double> weld;                   ///< tolerance, object units; that of rounding unless given
};

/// Adds --mesh, --subdivide, --target-triangles, --scheme and --weld.
void add_mesh_options(CLI::App& command, MeshOptions& options);

/// How a surface stands to the file that it comes from.
struct FromFile {
  Vec3d origin = Vec3d::Zero();  ///< as PolygonMesh::origin
  /// [vertex of the file] the vertex that it became when vertices were joined; empty where none were, and
  /// of a mesh that was refined.
  std::vector<Index> vertex_of = {};
  std::size_t vertices = 0;   ///< of the file
  std::size_t joined = 0;     ///< so many of them became one with another
  double tolerance = 0;       ///< object units
  std::string not_used = {};  ///< as PolygonMesh::not_used
};

struct LoadedSurface {
  Surface surface;
  std::string defects;  ///< of a mesh that was not refined, counted; empty for none
  Paint paint = {};     ///< on the surface's vertices, where the file has colours or masks
  FromFile from = {};
};

/// A mesh as its file has it, with vertices joined, though painted only where it is not to be refined, and
/// how far the options ask to refine it.
struct Cage {
  PolygonMesh polygons;
  SubdivisionScheme scheme;
  int level;
  FromFile from;
  /// With the vertices of the file, where those of a mesh that is not to be refined were joined.
  std::optional<PolygonMesh> apart = {};
};

/// Warns of paint that refinement loses. Throws FileError, for a point set too.
Cage read_cage(const MeshOptions& options);

/// Makes triangles of a cage's `level` ready for strokes; texture coordinates are left behind. `paint`: of
/// the vertices, or nothing.
LoadedSurface make_loaded(TriangleMesh mesh, int level, const VertexPaint& paint, FromFile from,
                          const Progress& progress);

/// Reads the mesh, refines or triangulates it and makes it ready. Throws FileError, for a point set too.
LoadedSurface load_surface(const MeshOptions& options, const Progress& progress);

/// As load_surface, with a progress bar and a warning that counts the defects.
LoadedSurface load_surface_on_console(const MeshOptions& options);

/// As load_surface_on_console, of a mesh or of a point set.
LoadedSurface load_mesh_or_points_on_console(const MeshOptions& options);

/// File, vertices, triangles and defects, and what is told of the file.
Json mesh_json(const MeshOptions& options, const LoadedSurface& loaded);

/// "FILE: 12 vertices, 34 triangles" or "FILE: 12 points", and what there is to tell of the file: "; 2 of 14
/// vertices joined to others within 4e-06; not used: 14 normals; counted from (448256, 5.4e6, 0)".
std::string mesh_text(const MeshOptions& options, const LoadedSurface& loaded);

}  // namespace burin
