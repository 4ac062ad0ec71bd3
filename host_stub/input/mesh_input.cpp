// Loads the mesh of a command: joins its vertices, refines it as the options request, and makes the surface.
// Levels that need more memory than there is are refused before any of it is allocated.
#include "input/mesh_input.h"

#include <burin/surface/mesh_file.h>
#include <burin/surface/topology/defects.h>
#include <burin/surface/weld_mesh.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <map>
#include <nlohmann/json.hpp>

#include "input/name_file.h"
#include "options/options.h"
#include "pictures/painted.h"
#include "system/platform.h"

namespace burin {
namespace {

/// The number of levels to refine, from the options.
int levels(const PolygonMesh& mesh, SubdivisionScheme scheme, const MeshOptions& options) {
  if (options.target_triangles) return level_for_triangles(mesh, scheme, *options.target_triangles);
  return options.subdivide.value_or(0);
}

/// Peak memory per triangle, about, while a refined surface is made.
constexpr double bytes_per_triangle = 150;

/// Throws Error if a level needs more memory than there is, before any is allocated.
void check_size(const Cage& cage) {
  const std::size_t triangles = refined_triangle_count(cage.polygons, cage.scheme, cage.level);
  const double bytes = bytes_per_triangle * static_cast<double>(triangles);
  const auto limit = static_cast<double>(memory_limit());
  if (cage.level == 0 || limit == 0 || bytes <= limit) return;
  throw Error(fmt::format(
      "level {} of this cage has {} triangles, which need about {:.0f} GB of memory; here are {:.1f}",
      cage.level, triangles, bytes / 1e9, limit / 1e9));
}

/// Joins vertices at the same positions (find_welds()), and keeps the original mesh as Cage::apart.
void join_vertices(const MeshOptions& options, Cage& cage) {
  FromFile& from = cage.from;
  from.vertices = cage.polygons.positions.size();
  from.tolerance = options.weld.value_or(rounding_tolerance(cage.polygons));
  from.vertex_of = find_welds(cage.polygons, from.tolerance);
  if (from.vertex_of.empty()) return;
  cage.apart = std::move(cage.polygons);
  cage.polygons = weld(*cage.apart, from.vertex_of);
  from.joined = from.vertices - cage.polygons.positions.size();
}

LoadedSurface load_points(const MeshOptions& options, const Progress& progress) {
  if (options.subdivide.value_or(0) > 0 || options.target_triangles) {
    throw FileError(options.path, "holds points without faces, which cannot be refined");
  }
  return with_file_context(options.path, [&] {
    PointSet points = read_points(options.path);
    FromFile from{.origin = points.origin, .vertices = points.positions.size()};
    return LoadedSurface{make_point_surface(points, default_links, progress), "", {}, std::move(from)};
  });
}

}  // namespace

void add_mesh_options(CLI::App& command, MeshOptions& options) {
  command.add_option("--mesh", options.path, "surface or cage: OBJ, PLY, STL, OFF, glTF or GLB")
      ->required()
      ->type_name("FILE");
  auto* levels = command.add_option("--subdivide", options.subdivide, "refine the cage by this many levels")
                     ->check(CLI::Range(0, 15));
  command
      .add_option("--target-triangles", options.target_triangles,
                  "refine the cage to at least so many triangles")
      ->check(CLI::Range(std::size_t{1}, std::size_t{1} << 30))
      ->excludes(levels);
  using Scheme = std::optional<SubdivisionScheme>;
  choose(command.add_option_function<std::string>(
             "--scheme",
             [&options](const std::string& name) {
               static const std::map<std::string, Scheme> schemes = {
                   {"auto", std::nullopt},
                   {"catmull-clark", SubdivisionScheme::catmull_clark},
                   {"loop", SubdivisionScheme::loop}};
               options.scheme = schemes.at(name);
             },
             "subdivision scheme; auto: Loop for a cage of triangles only, else Catmull-Clark"),
         {"auto", "catmull-clark", "loop"});
  command
      .add_option("--weld", options.weld,
                  "join edges that lie on each other no farther apart, object units; 0: exactly; heals\n"
                  "rounding unless given")
      ->check(number_from_0())
      ->type_name("TOL");
}

Cage read_cage(const MeshOptions& options) {
  return with_file_context(options.path, [&] {
    if (holds_points(options.path)) {
      throw FileError(options.path, "holds points without faces; only 'burin chart' takes a point set");
    }
    Cage cage{read_mesh(options.path), SubdivisionScheme::catmull_clark, 0, {}};
    cage.from.origin = cage.polygons.origin;
    cage.from.not_used = cage.polygons.not_used;
    join_vertices(options, cage);
    cage.scheme = options.scheme.value_or(natural_scheme(cage.polygons));
    cage.level = levels(cage.polygons, cage.scheme, options);
    check_size(cage);
    if (cage.level > 0) {
      cage.apart.reset();
      cage.from.vertex_of.clear();
    }
    if (cage.level > 0 && !cage.polygons.paint.empty()) {
      warn(options.path +
           ": colours and masks are left behind: they are kept on meshes that are not refined");
      cage.polygons.paint = {};
    }
    return cage;
  });
}

LoadedSurface make_loaded(TriangleMesh mesh, int level, const VertexPaint& paint, FromFile from,
                          const Progress& progress) {
  LoadedSurface loaded;
  loaded.from = std::move(from);
  if (level == 0) {
    const MeshDefects defects = find_defects(mesh);
    if (defects.any()) loaded.defects = defects.text();
  }
  loaded.surface = make_surface(std::move(mesh), progress);
  loaded.paint = paint_in_surface_order(loaded.surface, paint);
  return loaded;
}

LoadedSurface load_surface(const MeshOptions& options, const Progress& progress) {
  return load_surface(options, read_cage(options), progress);
}

LoadedSurface load_surface(const MeshOptions& options, Cage cage, const Progress& progress) {
  cage.polygons.corner_uv = {};
  return with_file_context(options.path, [&] {
    return make_loaded(refine(cage.polygons, cage.scheme, cage.level, progress), cage.level,
                       cage.polygons.paint, std::move(cage.from), progress);
  });
}

LoadedSurface load_surface_on_console(const MeshOptions& options) {
  return load_surface_on_console(options, read_cage(options));
}

LoadedSurface load_surface_on_console(const MeshOptions& options, Cage cage) {
  LoadedSurface loaded = [&] {
    ProgressBar bar;
    return load_surface(options, std::move(cage), bar.progress());
  }();
  if (!loaded.defects.empty()) warn(options.path + ": " + loaded.defects);
  return loaded;
}

LoadedSurface load_mesh_or_points_on_console(const MeshOptions& options) {
  if (!holds_points(options.path)) return load_surface_on_console(options);
  ProgressBar bar;
  return load_points(options, bar.progress());
}

Json mesh_json(const MeshOptions& options, const LoadedSurface& loaded) {
  const FromFile& from = loaded.from;
  return {{"file", options.path},
          {"vertices", loaded.surface.vertex_count()},
          {"triangles", loaded.surface.triangles.size()},
          {"defects", loaded.defects},
          {"vertices_joined", from.joined},
          {"weld_tolerance", from.tolerance},
          {"not_used", from.not_used},
          {"origin", {from.origin.x(), from.origin.y(), from.origin.z()}}};
}

namespace {

std::string file_text(const FromFile& from) {
  std::string text;
  if (from.joined > 0)
    text += fmt::format("; {} of {} vertices joined to others within {:.2g}", from.joined, from.vertices,
                        from.tolerance);
  if (!from.not_used.empty()) text += "; not used: " + from.not_used;
  if (!from.origin.isZero(0))
    text += fmt::format("; counted from ({}, {}, {})", from.origin.x(), from.origin.y(), from.origin.z());
  return text;
}

}  // namespace

std::string mesh_text(const MeshOptions& options, const LoadedSurface& loaded) {
  if (loaded.surface.is_point_set()) {
    return fmt::format("{}: {} points{}", options.path, loaded.surface.vertex_count(),
                       file_text(loaded.from));
  }
  return fmt::format("{}: {} vertices, {} triangles{}", options.path, loaded.surface.vertex_count(),
                     loaded.surface.triangles.size(), file_text(loaded.from));
}

}  // namespace burin
