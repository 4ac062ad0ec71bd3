// Sessions for C, and what of their surfaces and strokes a caller may read.
#include <burin/host/c/call.h>
#include <burin/host/c/handles.h>
#include <burin/host/c/mesh_arrays.h>
#include <burin/surface/source_numbers.h>
#include <burin/surface/triangle_mesh.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <string>
#include <utility>

using namespace burin;

/// Follows a surface that has other triangles, and more or fewer vertices.
void burin_session::renew() {
  const Index count = session.surface().vertex_count();
  const Index kept = session.kept_vertices();
  kept_vertices = std::min(kept_vertices, kept);
  vertex_count = count;
  generation = session.generation();
  has_other_triangles = true;
  order = c::VertexOrder(session.surface(), BURIN_ORDER_CALLER);
  if (object) object->resize(session.surface());
  for (auto& values : shown)
    if (values) values->resize(count, kept);
}

std::vector<Triangle> burin_session::triangles() const {
  std::vector<Triangle> made = session.surface().triangles;
  if (object && object->placement().mirrors()) c::turn_over(made);
  for (Triangle& triangle : made)
    for (Index& vertex : triangle) vertex = order.of_surface(vertex);
  return made;
}

namespace burin::c {
namespace {

/// Brings the list of triangles up to date. Returns how many vertices were there all the time.
Index tell_triangles(burin_session& session) {
  if (session.has_other_triangles)
    session.told->update(session.triangles());
  else
    session.told->keep();
  session.has_other_triangles = false;
  return std::exchange(session.kept_vertices, session.vertex_count);
}

/// The triangles as the caller's list has them after the next patch.
std::vector<Triangle> triangles_of(const burin_session& session) {
  if (!session.told) return session.triangles();
  if (!session.has_other_triangles) return session.told->list();
  ToldTriangles next = *session.told;
  next.update(session.triangles());
  return next.list();
}

/// Moves a mesh from the caller's object to the world. Returns the positions that it had.
std::vector<Vec3f> place(TriangleMesh& mesh, const Placement& placement) {
  std::vector<Vec3f> given = mesh.positions;
  for (std::size_t vertex = 0; vertex < given.size(); ++vertex) {
    mesh.positions[vertex] = placement.to_world(given[vertex]);
    if (!mesh.positions[vertex].allFinite())
      reject("vertex " + std::to_string(vertex) + " is not finite in the world");
  }
  if (placement.mirrors()) turn_over(mesh.triangles);
  return given;
}

void hide(burin_session& session, const std::uint8_t* hidden) {
  session.session.hide(hidden ? session.faces->triangles(hidden) : std::vector<bool>());
  session.has_other_triangles = true;
  session.note_changed();
}

/// Notes which faces became which triangles, and hides those that are to be hidden at first.
void hide_first(burin_session& session, const burin_mesh& given, const std::vector<Triangle>& triangles) {
  const auto face_count = static_cast<Index>(given.face_count);
  session.faces.emplace(triangles, read_triangle_faces(given), face_count, session.session.surface());
  if (std::any_of(given.hidden, given.hidden + face_count, [](std::uint8_t h) { return h != 0; }))
    hide(session, given.hidden);
}

std::unique_ptr<burin_session> make_session(const burin_library& library, const burin_mesh& given) {
  if (given.refines > 1) reject("refines is neither 0 nor 1");
  if (given.refines && given.order == BURIN_ORDER_SURFACE) reject("refines wants the caller's order");
  std::optional<Placement> placement;
  if (given.transform) placement.emplace(given.transform);
  TriangleMesh mesh = read_arrays(given);
  std::vector<Vec3f> in_object;
  if (placement) in_object = place(mesh, *placement);
  const std::vector<Triangle> triangles = given.hidden ? mesh.triangles : std::vector<Triangle>();
  auto session = std::make_unique<burin_session>(library, make_surface(std::move(mesh)), given.order,
                                                 given.refines == 1);
  if (placement) session->object.emplace(*placement, std::move(in_object));
  if (given.hidden) hide_first(*session, given, triangles);
  if (given.refines) session->told.emplace(session->triangles());
  return session;
}

}  // namespace
}  // namespace burin::c

burin_status burin_session_create(burin_library* library, const burin_mesh* mesh, burin_session** session,
                                  burin_text* error) {
  return plugin::guarded(error, [&] {
    c::require(library, "library");
    c::require(session, "session");
    const TaskRunnerScope scope(library->threads.get());
    *session = c::make_session(*library, c::known_members(mesh, c::has_first(mesh), "mesh")).release();
  });
}

burin_status burin_session_hide(burin_session* session, const uint8_t* hidden, uint64_t face_count,
                                burin_text* error) {
  return c::in_session(session, error, [&] {
    if (session->stroke) c::reject("a stroke is open");
    if (!session->faces) c::reject("the session was made of a mesh without an array of hidden faces");
    if (hidden && face_count != session->faces->face_count())
      c::reject("the mesh has " + std::to_string(session->faces->face_count()) + " faces");
    c::hide(*session, hidden);
  });
}

void burin_session_destroy(burin_session* session) { delete session; }

burin_status burin_session_get_info(const burin_session* session, burin_session_info* info,
                                    burin_text* error) {
  return c::in_session(session, error, [&] {
    const Surface& surface = session->session.surface();
    const burin_session_info known{.struct_size = 0,
                                   .stroke_open = session->stroke ? 1u : 0u,
                                   .vertex_count = surface.vertex_count(),
                                   .triangle_count = surface.triangles.size(),
                                   .undo_count = session->session.undo_count(),
                                   .redo_count = session->session.redo_count(),
                                   .undo_bytes = session->session.undo_bytes(),
                                   .undo_dropped = session->session.undo_dropped(),
                                   .generation = session->session.generation(),
                                   .has_colours = session->session.paint().colour.empty() ? 0u : 1u,
                                   .has_masks = session->session.paint().mask.empty() ? 0u : 1u,
                                   .solid_count = session->session.parts().size(),
                                   .bent_mesh_count = session->session.bent_meshes().size()};
    c::give(known, info, info && BURIN_HAS(info, burin_session_info, undo_bytes), "info");
  });
}

burin_status burin_session_read_map(const burin_session* session, burin_map map, uint32_t* numbers,
                                    uint64_t capacity, burin_text* error) {
  return c::in_session(session, error, [&] {
    c::require(numbers, "numbers");
    if (map != BURIN_MAP_CALLER_TO_SURFACE && map != BURIN_MAP_SURFACE_TO_CALLER)
      c::reject("there is no such map");
    const Surface& surface = session->session.surface();
    if (capacity < surface.vertex_count()) c::reject("the map does not fit");
    if (map == BURIN_MAP_SURFACE_TO_CALLER)
      std::ranges::copy(surface.source_vertex, numbers);
    else
      std::ranges::copy(numbers_of_source(surface), numbers);
  });
}

burin_status burin_session_read_triangles(const burin_session* session, uint32_t* corners, uint64_t capacity,
                                          burin_text* error) {
  return c::in_session(session, error, [&] {
    c::require(corners, "corners");
    const std::vector<Triangle> triangles = c::triangles_of(*session);
    if (capacity < triangles.size()) c::reject("the triangles do not fit");
    std::memcpy(corners, triangles.data(), triangles.size() * sizeof(Triangle));
  });
}

burin_status burin_session_take_patch(burin_session* session, burin_patch* patch, burin_text* error) {
  return c::in_session(session, error, [&] {
    const bool has_first = patch && BURIN_HAS(patch, burin_patch, added);
    if (!has_first) c::reject("patch is missing or too small");
    if (!session->told) c::reject("the session was made of a mesh that nothing refines");
    const Index kept = c::tell_triangles(*session);
    const auto& added = session->told->added();
    const burin_patch known{.struct_size = 0,
                            .reserved = 0,
                            .kept_vertices = kept,
                            .vertex_count = session->vertex_count,
                            .removed_count = session->told->removed().size(),
                            .removed = session->told->removed().data(),
                            .added_count = added.size(),
                            .added = added.empty() ? nullptr : added.front().data()};
    c::give(known, patch, has_first, "patch");
  });
}

burin_status burin_session_hash(const burin_session* session, uint64_t* hash, burin_text* error) {
  return c::in_session(session, error, [&] {
    c::require(hash, "hash");
    *hash = session->session.result_hash();
  });
}

burin_status burin_session_chart(burin_session* session, burin_chart* chart, burin_text* error) {
  return c::in_session(session, error, [&] {
    const Chart& made = session->session.chart();
    session->chart_vertices.resize(made.size());
    std::ranges::transform(made.vertex, session->chart_vertices.begin(),
                           [&](Index vertex) { return session->order.of_surface(vertex); });
    const burin_chart known{.struct_size = 0,
                            .closed = made.closed ? 1u : 0u,
                            .count = made.size(),
                            .length = made.length,
                            .vertex = session->chart_vertices.data(),
                            .sheet = made.sheet.data(),
                            .t = made.t.data(),
                            .d = made.d.data()};
    c::give(known, chart, chart && BURIN_HAS(chart, burin_chart, d), "chart");
  });
}
