#pragma once
#include <burin/base/vector.h>
#include <burin/deform/paint.h>
#include <burin/subdiv/refine.h>
#include <burin/surface/surface.h>

#include <optional>
#include <string>
#include <vector>

#include "cli_fwd.h"
#include "system/console.h"

namespace burin {

/// The surface of a command, from the command line.
struct MeshOptions {
  std::string path;
  std::optional<int> subdivide;                 ///< number of levels
  std::optional<std::size_t> target_triangles;  ///< least number of triangles to subdivide to
  std::optional<SubdivisionScheme> scheme;      ///< default: the cage's natural scheme
  std::optional<double> weld;                   ///< tolerance, object units; default: rounding_tolerance()
};

/// Adds --mesh, --subdivide, --target-triangles, --scheme and --weld.
void add_mesh_options(CLI::App& command, MeshOptions& options);

/// The relation of a surface to its file.
struct FromFile {
  Vec3d origin = Vec3d::Zero();  ///< see PolygonMesh::origin
  /// [vertex of the file] the vertex that it became when vertices were joined; empty if none were joined, and
  /// for a mesh that was refined.
  std::vector<Index> vertex_of = {};
  std::size_t vertices = 0;   ///< number of vertices of the file
  std::size_t joined = 0;     ///< number of vertices that joining removed
  double tolerance = 0;       ///< tolerance of joining, object units
  std::string not_used = {};  ///< see PolygonMesh::not_used
};

struct LoadedSurface {
  Surface surface;
  std::string defects;  ///< counts of the defects of a mesh that was not refined; empty if there are none
  Paint paint = {};     ///< colours and masks of the surface's vertices, if the file has any
  FromFile from = {};
};

/// A mesh with joined vertices, and the refinement that the options request. It is painted only if it is not
/// to be refined.
struct Cage {
  PolygonMesh polygons;
  SubdivisionScheme scheme = SubdivisionScheme::catmull_clark;
  int level = 0;
  FromFile from;
  /// The mesh with the vertices of the file, if vertices were joined and the mesh is not to be refined.
  std::optional<PolygonMesh> apart = {};
};

/// Reads a mesh and joins its vertices. Warns if refinement loses paint. Throws FileError, also for a point
/// set.
Cage read_cage(const MeshOptions& options);

/// Makes a surface of a mesh, which is the refined level `level` of a cage. `paint` has the colours and masks
/// of the mesh's vertices and may be empty. Defects are counted on level 0 only.
LoadedSurface make_loaded(TriangleMesh mesh, int level, const VertexPaint& paint, FromFile from,
                          const Progress& progress);

/// Reads the mesh, refines or triangulates it and makes the surface. Throws FileError, also for a point set.
LoadedSurface load_surface(const MeshOptions& options, const Progress& progress);

/// Does the same for a cage that read_cage() has read.
LoadedSurface load_surface(const MeshOptions& options, Cage cage, const Progress& progress);

/// Does what load_surface() does, with a progress bar and a warning that counts the defects.
LoadedSurface load_surface_on_console(const MeshOptions& options);

/// Does the same for a cage that read_cage() has read.
LoadedSurface load_surface_on_console(const MeshOptions& options, Cage cage);

/// Does what load_surface_on_console() does, and accepts a point set too.
LoadedSurface load_mesh_or_points_on_console(const MeshOptions& options);

/// The file, its numbers of vertices and triangles, its defects, and the relation of the surface to it.
Json mesh_json(const MeshOptions& options, const LoadedSurface& loaded);

/// "FILE: 12 vertices, 34 triangles" or "FILE: 12 points", followed by the relation to the file: "; 2 of 14
/// vertices joined to others within 4e-06; not used: 14 normals; counted from (448256, 5.4e6, 0)".
std::string mesh_text(const MeshOptions& options, const LoadedSurface& loaded);

}  // namespace burin
