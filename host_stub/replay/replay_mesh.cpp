// Prepares the mesh of a replay, with levels if strokes are drawn below the finest one, and makes the mesh to
// save: where the mesh of the file was not refined, it has the vertices and texture coordinates of the file.
#include "replay/replay_mesh.h"

#include <burin/base/hash.h>
#include <burin/deform/bake.h>
#include <burin/surface/triangulate.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "input/name_file.h"
#include "pictures/painted.h"
#include "replay/source_order.h"

namespace burin {
namespace {

void check_level(int sculpt_level, int finest) {
  if (sculpt_level > finest) {
    throw Error(fmt::format("--sculpt-level {} is above the finest level, {}", sculpt_level, finest));
  }
}

/// Drops texture coordinates if any is not finite, since not all file formats can hold NaN.
void drop_unless_finite(std::vector<Vec2f>& uv) {
  if (!std::ranges::all_of(uv, [](const Vec2f& corner) { return corner.allFinite(); })) uv = {};
}

}  // namespace

void add_replay_mesh_options(CLI::App& command, ReplayMeshOptions& options) {
  add_mesh_options(command, options.mesh);
  command
      .add_option("--sculpt-level", options.sculpt_level,
                  "draw on this level of the refined cage; the result is the finest")
      ->check(CLI::Range(0, 15));
}

ReplayMesh::ReplayMesh(const ReplayMeshOptions& options, const Uses& uses) {
  with_file_context(options.mesh.path, [&] {
    ProgressBar bar;
    Cage cage = read_cage(options.mesh);
    drawn_level_ = options.sculpt_level.value_or(cage.level);
    check_level(drawn_level_, cage.level);
    if (uses.baked) check_bakeable(cage.polygons);
    if (!uses.baked && !uses.saved && !uses.refined) cage.polygons.corner_uv = {};
    drop_unless_finite(cage.polygons.corner_uv);
    drawn_level_ < cage.level ? load_levels(cage, bar.progress())
                              : load(std::move(cage), uses, bar.progress());
  });
  describe(options.mesh);
}

void ReplayMesh::load(Cage cage, const Uses& uses, const Progress& progress) {
  TriangleMesh mesh = refine(cage.polygons, cage.scheme, cage.level, progress);
  VertexPaint paint = std::move(cage.polygons.paint);
  cage.polygons = {};
  if (uses.baked || uses.saved) before_ = mesh;
  if (!uses.saved && !uses.refined) mesh.triangle_uv = {};
  drawn_ = make_loaded(std::move(mesh), cage.level, paint, std::move(cage.from), progress);
  if (!uses.saved || !cage.apart) return;
  apart_ = std::move(cage.apart);
  drop_unless_finite(apart_->corner_uv);
  joined_paint_ = std::move(paint);
}

void ReplayMesh::load_levels(const Cage& cage, const Progress& progress) {
  levels_.emplace(cage.polygons, cage.scheme, cage.level, progress);
  drawn_ = make_loaded(levels_->mesh(drawn_level_), drawn_level_, {}, cage.from, progress);
  // Levels without details equal the refined cage, but have no texture coordinates.
  before_ = cage.polygons.corner_uv.empty() ? levels_->mesh(levels_->finest())
                                            : refine(cage.polygons, cage.scheme, cage.level, progress);
}

void ReplayMesh::describe(const MeshOptions& options) {
  if (!drawn_.defects.empty()) warn(options.path + ": " + drawn_.defects);
  json_ = mesh_json(options, drawn_);
  text_ = mesh_text(options, drawn_);
  if (!levels_) return;
  const std::size_t vertices = before_.positions.size(), triangles = before_.triangles.size();
  json_["level"] = drawn_level_;
  json_["finest"] = {{"level", levels_->finest()}, {"vertices", vertices}, {"triangles", triangles}};
  text_ += fmt::format(" on level {}; {} vertices, {} triangles on level {}", drawn_level_, vertices,
                       triangles, levels_->finest());
}

void ReplayMesh::finish(const Session& session) {
  levels_->set_positions(drawn_level_, in_source_order(session.surface(), session.positions()).positions);
}

std::uint64_t ReplayMesh::result_hash() const {
  const std::span<const Vec3f> positions = levels_->positions(levels_->finest());
  return hash_bytes(positions.data(), positions.size_bytes());
}

TriangleMesh ReplayMesh::result(const Session& session) const {
  if (levels_) return levels_->mesh(levels_->finest());
  return in_source_order(session.surface(), session.positions());
}

TriangleMesh ReplayMesh::saved(const Session& session) const {
  TriangleMesh mesh = result(session);
  if (session.generation() != 0) return mesh;
  mesh.triangles = before_.triangles;
  mesh.triangle_uv = before_.triangle_uv;
  if (!apart_) return mesh;
  TriangleMesh apart = triangulate(*apart_);
  for (std::size_t i = 0; i < apart.positions.size(); ++i) {
    const Index joined = drawn_.from.vertex_of[i];
    if (mesh.positions[joined] != before_.positions[joined]) apart.positions[i] = mesh.positions[joined];
  }
  return apart;
}

namespace {

/// The values of the file's vertices after a stroke: a vertex takes the value of the vertex that it became,
/// but keeps its own if that value did not change.
template <class Value>
std::vector<Value> apart_again(const std::vector<Value>& own, const std::vector<Value>& before,
                               const std::vector<Value>& after, const std::vector<Index>& vertex_of) {
  if (after.empty()) return {};
  std::vector<Value> values(vertex_of.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Index joined = vertex_of[i];
    const bool unchanged = !before.empty() && before[joined] == after[joined];
    values[i] = unchanged ? own[i] : after[joined];
  }
  return values;
}

}  // namespace

VertexPaint ReplayMesh::saved_paint(const Session& session) const {
  if (levels_) return {};
  VertexPaint after = paint_in_source_order(session.surface(), session.paint());
  if (!apart_ || session.generation() != 0) return after;
  const VertexPaint &own = apart_->paint, &before = joined_paint_;
  const std::vector<Index>& vertex_of = drawn_.from.vertex_of;
  return {apart_again(own.colours, before.colours, after.colours, vertex_of),
          apart_again(own.masks, before.masks, after.masks, vertex_of)};
}

}  // namespace burin
