// Meshes for C: read, joined and refined as the command does, refined from arrays, and written.
#include <burin/c/triangles.h>
#include <burin/deform/paint_bytes.h>
#include <burin/host/c/call.h>
#include <burin/host/c/handles.h>
#include <burin/host/c/mesh_arrays.h>
#include <burin/subdiv/refine.h>
#include <burin/surface/mesh_file.h>
#include <burin/surface/weld_mesh.h>

#include <memory>
#include <utility>

namespace burin::c {
namespace {

constexpr std::uint32_t highest_level = 15;

/// A mesh of a file, without vertices that only stand apart at seams.
PolygonMesh read_cage(const char* path, const burin_refinement& options) {
  PolygonMesh cage = read_mesh(path);
  const double tolerance = options.weld > 0 ? options.weld : rounding_tolerance(cage);
  const std::vector<Index> vertex_of = find_welds(cage, tolerance);
  return vertex_of.empty() ? std::move(cage) : weld(std::move(cage), vertex_of);
}

int level_of(const PolygonMesh& cage, SubdivisionScheme scheme, const burin_refinement& options) {
  if (options.target_triangles == 0) return static_cast<int>(options.levels);
  return level_for_triangles(cage, scheme, options.target_triangles);
}

std::unique_ptr<burin_triangles> refined(const PolygonMesh& cage, const burin_refinement& options) {
  const SubdivisionScheme scheme = natural_scheme(cage);
  const int level = level_of(cage, scheme, options);
  auto made = std::make_unique<burin_triangles>();
  made->mesh = refine(cage, scheme, level);
  made->origin = cage.origin;
  if (level > 0) return made;
  for (const PaintBytes& bytes : cage.paint.colours) made->colours.push_back(colour_of(bytes));
  made->masks = cage.paint.masks;
  return made;
}

burin_refinement known_options(const burin_refinement* given) {
  burin_refinement known{};
  if (given) known = known_members(given, BURIN_HAS(given, burin_refinement, weld), "options");
  if (known.levels > highest_level) reject("there are no more than 15 levels");
  return known;
}

burin_mesh arrays_of(const TriangleMesh& mesh) {
  return {.struct_size = 0,
          .position_type = BURIN_FLOAT32,
          .positions = mesh.positions.data(),
          .vertex_count = mesh.positions.size(),
          .position_stride = 0,
          .corners = mesh.triangles.data(),
          .face_count = mesh.triangles.size(),
          .face_stride = 0,
          .corner_type = BURIN_UINT32,
          .face_size = 3,
          .face_sizes = nullptr,
          .order = BURIN_ORDER_CALLER,
          .refines = 0,
          .transform = nullptr,
          .hidden = nullptr};
}

/// A mesh that no session is made of.
burin_mesh known_mesh(const burin_mesh* given) {
  const burin_mesh known = known_members(given, has_first(given), "mesh");
  if (known.transform || known.hidden || known.refines)
    reject("transform, hidden and refines are for sessions");
  return known;
}

VertexPaint paint_of(const burin_mesh_values& values, std::size_t vertices) {
  VertexPaint paint;
  for (std::size_t i = 0; values.colours && i < vertices; ++i)
    paint.colours.push_back(bytes_of(Eigen::Map<const Vec4f>(&values.colours[4 * i])));
  if (values.masks) paint.masks.assign(values.masks, values.masks + vertices);
  return paint;
}

std::vector<TriangleUv> uv_of(const burin_mesh_values& values, const burin_mesh& mesh) {
  if (!values.uv) return {};
  if (mesh.face_sizes || mesh.face_size != 3) reject("texture coordinates are of triangles");
  std::vector<TriangleUv> uv(mesh.face_count);
  const float* given = values.uv;
  for (TriangleUv& triangle : uv)
    for (Vec2f& corner : triangle) {
      corner = Vec2f(given[0], given[1]);
      if (!corner.allFinite()) reject("a texture coordinate is not finite");
      given += 2;
    }
  return uv;
}

}  // namespace
}  // namespace burin::c

using namespace burin;

burin_status burin_triangles_read(const char* path, const burin_refinement* options,
                                  burin_triangles** triangles, burin_text* error) {
  return plugin::guarded(error, [&] {
    c::require(path, "path");
    c::require(triangles, "triangles");
    const burin_refinement known = c::known_options(options);
    *triangles = c::refined(c::read_cage(path, known), known).release();
  });
}

burin_status burin_triangles_refine(const burin_mesh* mesh, const burin_refinement* options,
                                    burin_triangles** triangles, burin_text* error) {
  return plugin::guarded(error, [&] {
    c::require(triangles, "triangles");
    const burin_mesh known = c::known_mesh(mesh);
    *triangles = c::refined(c::read_polygons(known), c::known_options(options)).release();
  });
}

void burin_triangles_destroy(burin_triangles* triangles) { delete triangles; }

burin_status burin_triangles_get(const burin_triangles* triangles, burin_mesh* mesh,
                                 burin_mesh_values* values, burin_text* error) {
  return plugin::guarded(error, [&] {
    c::require(triangles, "triangles");
    c::give(c::arrays_of(triangles->mesh), mesh, c::has_first(mesh), "mesh");
    if (!values) return;
    const burin_mesh_values known{
        .struct_size = 0,
        .reserved = 0,
        .colours = triangles->colours.empty() ? nullptr : triangles->colours.front().data(),
        .masks = triangles->masks.empty() ? nullptr : triangles->masks.data(),
        .origin = {triangles->origin.x(), triangles->origin.y(), triangles->origin.z()},
        .uv = triangles->mesh.triangle_uv.empty() ? nullptr
                                                  : triangles->mesh.triangle_uv.front().front().data()};
    c::give(known, values, BURIN_HAS(values, burin_mesh_values, origin), "values");
  });
}

burin_status burin_mesh_write(const char* path, const burin_mesh* mesh, const burin_mesh_values* values,
                              burin_text* error) {
  return plugin::guarded(error, [&] {
    c::require(path, "path");
    const burin_mesh known = c::known_mesh(mesh);
    burin_mesh_values with{};
    if (values) with = c::known_members(values, BURIN_HAS(values, burin_mesh_values, origin), "values");
    TriangleMesh read = c::read_arrays(known);
    read.triangle_uv = c::uv_of(with, known);
    write_mesh(path, read, c::paint_of(with, read.positions.size()),
               Vec3d(with.origin[0], with.origin[1], with.origin[2]));
  });
}
