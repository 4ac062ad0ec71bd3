// Sessions for C, and what of their surfaces and strokes a caller may read.
#include <burin/host/c/call.h>
#include <burin/host/c/handles.h>
#include <burin/host/c/mesh_arrays.h>

#include <algorithm>
#include <utility>

using namespace burin;

burin_status burin_session_create(burin_library* library, const burin_mesh* mesh, burin_session** session,
                                  burin_text* error) {
  return plugin::guarded(error, [&] {
    c::require(library, "library");
    c::require(session, "session");
    const burin_mesh known = c::known_members(mesh, mesh && BURIN_HAS(mesh, burin_mesh, reserved), "mesh");
    *session = new burin_session(library->brushes, make_surface(c::read_arrays(known)), known.order);
  });
}

void burin_session_destroy(burin_session* session) { delete session; }

burin_status burin_session_get_info(const burin_session* session, burin_session_info* info,
                                    burin_text* error) {
  return plugin::guarded(error, [&] {
    c::require(session, "session");
    const Surface& surface = session->session.surface();
    const burin_session_info known{.struct_size = 0,
                                   .stroke_open = session->stroke ? 1u : 0u,
                                   .vertex_count = surface.vertex_count(),
                                   .triangle_count = surface.triangles.size(),
                                   .undo_count = session->session.undo_count(),
                                   .redo_count = session->session.redo_count(),
                                   .undo_bytes = session->session.undo_bytes()};
    c::give(known, info, info && BURIN_HAS(info, burin_session_info, undo_bytes), "info");
  });
}

burin_status burin_session_read_map(const burin_session* session, burin_map map, uint32_t* numbers,
                                    uint64_t capacity, burin_text* error) {
  return plugin::guarded(error, [&] {
    c::require(session, "session");
    c::require(numbers, "numbers");
    if (map != BURIN_MAP_CALLER_TO_SURFACE && map != BURIN_MAP_SURFACE_TO_CALLER)
      c::reject("there is no such map");
    const Surface& surface = session->session.surface();
    if (capacity < surface.vertex_count()) c::reject("the map does not fit");
    if (map == BURIN_MAP_SURFACE_TO_CALLER)
      std::ranges::copy(surface.source_vertex, numbers);
    else
      std::ranges::copy(c::VertexOrder::inverse(surface), numbers);
  });
}

burin_status burin_session_read_triangles(const burin_session* session, uint32_t* corners, uint64_t capacity,
                                          burin_text* error) {
  return plugin::guarded(error, [&] {
    c::require(session, "session");
    c::require(corners, "corners");
    const Surface& surface = session->session.surface();
    if (capacity < surface.triangles.size()) c::reject("the triangles do not fit");
    for (const Triangle& triangle : surface.triangles)
      for (const Index vertex : triangle) *corners++ = session->order.of_surface(vertex);
  });
}

burin_status burin_session_hash(const burin_session* session, uint64_t* hash, burin_text* error) {
  return plugin::guarded(error, [&] {
    c::require(session, "session");
    c::require(hash, "hash");
    *hash = session->session.result_hash();
  });
}

burin_status burin_session_chart(burin_session* session, burin_chart* chart, burin_text* error) {
  return plugin::guarded(error, [&] {
    c::require(session, "session");
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
