#include "mesh_input.h"

#include <burin/surface/defects.h>
#include <burin/surface/mesh_file.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <map>
#include <nlohmann/json.hpp>

#include "name_file.h"
#include "painted.h"

namespace burin {
namespace {

/// Levels by which the options ask to refine.
int levels(const PolygonMesh& mesh, SubdivisionScheme scheme, const MeshOptions& options) {
  if (options.target_triangles) return level_for_triangles(mesh, scheme, *options.target_triangles);
  return options.subdivide.value_or(0);
}

LoadedSurface load_points(const MeshOptions& options, const Progress& progress) {
  if (options.subdivide.value_or(0) > 0 || options.target_triangles) {
    throw FileError(options.path, "holds points without faces, which cannot be refined");
  }
  return naming_file(options.path, [&] {
    return LoadedSurface{make_point_surface(read_points(options.path), default_links, progress), ""};
  });
}

}  // namespace

void add_mesh_options(CLI::App& command, MeshOptions& options) {
  command.add_option("--mesh", options.path, "surface or cage: OBJ, PLY or STL")
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
  command
      .add_option_function<std::string>(
          "--scheme",
          [&options](const std::string& name) {
            static const std::map<std::string, Scheme> schemes = {
                {"auto", std::nullopt},
                {"catmull-clark", SubdivisionScheme::catmull_clark},
                {"loop", SubdivisionScheme::loop}};
            options.scheme = schemes.at(name);
          },
          "subdivision scheme; auto: Loop for a cage of triangles only, else Catmull-Clark")
      ->check(CLI::IsMember({"auto", "catmull-clark", "loop"}));
}

Cage read_cage(const MeshOptions& options) {
  return naming_file(options.path, [&] {
    if (holds_points(options.path)) {
      throw FileError(options.path, "holds points without faces; only 'burin chart' takes a point set");
    }
    Cage cage{read_mesh(options.path), SubdivisionScheme::catmull_clark, 0};
    cage.scheme = options.scheme.value_or(natural_scheme(cage.polygons));
    cage.level = levels(cage.polygons, cage.scheme, options);
    if (cage.level > 0 && !cage.polygons.paint.empty()) {
      warn(options.path +
           ": colours and masks are left behind: they are kept on meshes that are not refined");
      cage.polygons.paint = {};
    }
    return cage;
  });
}

LoadedSurface make_loaded(TriangleMesh mesh, int level, const VertexPaint& paint, const Progress& progress) {
  LoadedSurface loaded;
  mesh.triangle_uv = {};
  if (level == 0) {
    const MeshDefects defects = find_defects(mesh);
    if (defects.any()) loaded.defects = defects.text();
  }
  loaded.surface = make_surface(std::move(mesh), progress);
  loaded.paint = paint_in_surface_order(loaded.surface, paint);
  return loaded;
}

LoadedSurface load_surface(const MeshOptions& options, const Progress& progress) {
  Cage cage = read_cage(options);
  cage.polygons.corner_uv = {};
  return naming_file(options.path, [&] {
    return make_loaded(refine(cage.polygons, cage.scheme, cage.level, progress), cage.level,
                       cage.polygons.paint, progress);
  });
}

LoadedSurface load_surface_on_console(const MeshOptions& options) {
  LoadedSurface loaded = [&] {
    ProgressBar bar;
    return load_surface(options, bar.progress());
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
  return {{"file", options.path},
          {"vertices", loaded.surface.vertex_count()},
          {"triangles", loaded.surface.triangles.size()},
          {"defects", loaded.defects}};
}

std::string mesh_text(const MeshOptions& options, const LoadedSurface& loaded) {
  if (loaded.surface.is_point_set()) {
    return fmt::format("{}: {} points", options.path, loaded.surface.vertex_count());
  }
  return fmt::format("{}: {} vertices, {} triangles", options.path, loaded.surface.vertex_count(),
                     loaded.surface.triangles.size());
}

}  // namespace burin
