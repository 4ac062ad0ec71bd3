// Sessions for C: surfaces, and what of them a caller may read.
#include <burin/host/c/call.h>
#include <burin/host/c/handles.h>
#include <burin/host/c/mesh_arrays.h>

#include <algorithm>
#include <utility>

namespace burin::c {
namespace {

ShownValues& shown_values(burin_session& session, burin_attribute attribute, std::size_t size) {
  std::optional<ShownValues>& shown = session.shown[static_cast<std::size_t>(attribute) - 1];
  if (!shown) shown.emplace(session.session.surface().vertex_count(), size);
  return *shown;
}

void check(const burin_range& range, const Session& session) {
  if (range.begin > range.end || range.end > session.surface().vertex_count())
    reject("the range is not one of vertices");
}

void read(const burin_session& session, const VertexValues& values, const burin_range& range,
          const burin_target& target) {
  if (target.type != BURIN_FLOAT32 && target.type != BURIN_FLOAT64)
    reject("the target's type is neither BURIN_FLOAT32 nor BURIN_FLOAT64");
  const std::size_t number = target.type == BURIN_FLOAT32 ? sizeof(float) : sizeof(double);
  const std::uint64_t stride = target.stride ? target.stride : values.size * number;
  char* to = static_cast<char*>(target.data);
  for (std::uint64_t vertex = range.begin; vertex < range.end; ++vertex, to += stride)
    write_values(values.of(session.order.to_surface(static_cast<Index>(vertex))), values.size, target.type,
                 to);
}

}  // namespace
}  // namespace burin::c

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
                                   .redo_count = session->session.redo_count()};
    c::give(known, info, info && BURIN_HAS(info, burin_session_info, redo_count), "info");
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

burin_status burin_session_update(burin_session* session, burin_attribute attribute, uint64_t gap,
                                  burin_range* ranges, uint64_t capacity, uint64_t* count,
                                  burin_text* error) {
  return plugin::guarded(error, [&] {
    c::require(session, "session");
    c::require(ranges, "ranges");
    c::require(count, "count");
    if (capacity == 0) c::reject("there is room for no range");
    const c::VertexValues values = c::values_of(session->session, attribute);
    c::ShownValues& shown = c::shown_values(*session, attribute, values.size);
    const std::vector<burin_range> changed = shown.update(values, session->order, gap).at_most(capacity);
    std::ranges::copy(changed, ranges);
    *count = changed.size();
  });
}

const float* burin_session_values(const burin_session* session, burin_attribute attribute) {
  if (!session || attribute < BURIN_POSITIONS || attribute > BURIN_MASKS) return nullptr;
  const auto& shown = session->shown[static_cast<std::size_t>(attribute) - 1];
  return shown ? shown->data() : nullptr;
}

burin_status burin_session_read(const burin_session* session, burin_attribute attribute,
                                const burin_range* range, const burin_target* target, burin_text* error) {
  return plugin::guarded(error, [&] {
    c::require(session, "session");
    c::require(range, "range");
    const burin_target known =
        c::known_members(target, target && BURIN_HAS(target, burin_target, stride), "target");
    c::require(known.data, "the target's data");
    c::check(*range, session->session);
    c::read(*session, c::values_of(session->session, attribute), *range, known);
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
