#include "replay_mesh.h"

#include <burin/base/hash.h>
#include <burin/deform/bake.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "name_file.h"
#include "source_order.h"

namespace burin {
namespace {

void check_level(int sculpt_level, int finest) {
  if (sculpt_level > finest) {
    throw Error(fmt::format("--sculpt-level {} is above the finest level, {}", sculpt_level, finest));
  }
}

}  // namespace

void add_replay_mesh_options(CLI::App& command, ReplayMeshOptions& options) {
  add_mesh_options(command, options.mesh);
  command
      .add_option("--sculpt-level", options.sculpt_level,
                  "draw on this level of the refined cage; the result is the finest")
      ->check(CLI::Range(0, 15));
}

ReplayMesh::ReplayMesh(const ReplayMeshOptions& options, bool for_map) {
  naming_file(options.mesh.path, [&] {
    ProgressBar bar;
    Cage cage = read_cage(options.mesh);
    drawn_level_ = options.sculpt_level.value_or(cage.level);
    check_level(drawn_level_, cage.level);
    if (for_map) check_bakeable(cage.polygons);
    if (!for_map) cage.polygons.corner_uv = {};
    drawn_level_ < cage.level ? load_levels(cage, bar.progress())
                              : load(std::move(cage), for_map, bar.progress());
  });
  describe(options.mesh);
}

void ReplayMesh::load(Cage cage, bool for_map, const Progress& progress) {
  TriangleMesh mesh = refine(cage.polygons, cage.scheme, cage.level, progress);
  const VertexPaint paint = std::move(cage.polygons.paint);
  cage.polygons = {};
  if (for_map) before_ = mesh;
  drawn_ = make_loaded(std::move(mesh), cage.level, paint, progress);
}

void ReplayMesh::load_levels(const Cage& cage, const Progress& progress) {
  levels_.emplace(cage.polygons, cage.scheme, cage.level, progress);
  drawn_ = make_loaded(levels_->mesh(drawn_level_), drawn_level_, {}, progress);
  // Levels without details are the refined cage, but have no texture coordinates.
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

}  // namespace burin
