// Values of vertices for C: what changed, and what callers read and write.
#include <burin/host/c/call.h>
#include <burin/host/c/handles.h>

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

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

/// Bytes from one vertex to the next of a caller's array, whose struct is complete.
template <class Array>
std::uint64_t stride_of(const Array& array, std::size_t size) {
  require(array.data, "data");
  if (array.type != BURIN_FLOAT32 && array.type != BURIN_FLOAT64)
    reject("the type is neither BURIN_FLOAT32 nor BURIN_FLOAT64");
  if (array.stride) return array.stride;
  return size * (array.type == BURIN_FLOAT32 ? sizeof(float) : sizeof(double));
}

void read(const burin_session& session, const VertexValues& values, const burin_range& range,
          const burin_target& target) {
  const std::uint64_t stride = stride_of(target, values.size);
  char* to = static_cast<char*>(target.data);
  for (std::uint64_t vertex = range.begin; vertex < range.end; ++vertex, to += stride) {
    float now[most_floats];
    values.copy(session.order.to_surface(static_cast<Index>(vertex)), now);
    write_values(now, values.size, target.type, to);
  }
}

/// The values of a range of vertices, float by float.
std::vector<float> taken(const burin_range& range, const burin_source& source, std::size_t size) {
  const std::uint64_t stride = stride_of(source, size);
  std::vector<float> values;
  values.reserve((range.end - range.begin) * size);
  const char* from = static_cast<const char*>(source.data);
  for (std::uint64_t vertex = range.begin; vertex < range.end; ++vertex, from += stride)
    for (std::size_t k = 0; k < size; ++k) values.push_back(read_value(from, source.type, k));
  return values;
}

/// The vertices of the surface that have these numbers.
std::vector<Index> surface_vertices(const burin_session& session, const burin_range& range) {
  std::vector<Index> vertices;
  vertices.reserve(range.end - range.begin);
  for (std::uint64_t vertex = range.begin; vertex < range.end; ++vertex)
    vertices.push_back(session.order.to_surface(static_cast<Index>(vertex)));
  return vertices;
}

/// Positions of the caller's where the surface has them.
std::vector<Vec3f> placed(const burin_session& session, std::span<const float> values) {
  std::vector<Vec3f> positions(values.size() / 3);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    positions[i] = Eigen::Map<const Vec3f>(&values[3 * i]);
    if (session.object) positions[i] = session.object->placement().to_world(positions[i]);
    if (!positions[i].allFinite()) reject("a position is not finite");
  }
  return positions;
}

void move(burin_session& session, std::span<const Index> vertices, std::span<const float> values) {
  session.session.move_vertices(vertices, placed(session, values));
  session.note_changed();
  if (!session.object) return;
  // What rounds to the same place of the world has other bits in the object.
  const std::vector<Index>& source = session.session.surface().source_vertex;
  std::vector<Index> given_anew;
  for (std::size_t i = 0; i < vertices.size(); ++i)
    if (session.object->take(source[vertices[i]], Eigen::Map<const Vec3f>(&values[3 * i])))
      given_anew.push_back(vertices[i]);
  session.note(given_anew);
}

void paint(burin_session& session, burin_attribute attribute, std::span<const Index> vertices,
           std::span<const float> values) {
  if (!std::ranges::all_of(values, [](float value) { return value >= 0 && value <= 1; }))
    reject("a value is not from 0 to 1");
  Paint paint = session.session.paint();
  const Index count = session.session.surface().vertex_count();
  if (attribute == BURIN_COLOURS) {
    paint.colour.resize(count, Paint::bare());
    for (std::size_t i = 0; i < vertices.size(); ++i)
      paint.colour[vertices[i]] = Eigen::Map<const Vec4f>(&values[4 * i]);
  } else {
    paint.mask.resize(count, 1);
    for (std::size_t i = 0; i < vertices.size(); ++i) paint.mask[vertices[i]] = values[i];
  }
  session.session.set_paint(std::move(paint));
  session.note(vertices);
}

}  // namespace
}  // namespace burin::c

using namespace burin;

burin_status burin_session_update(burin_session* session, burin_attribute attribute, uint64_t gap,
                                  burin_range* ranges, uint64_t capacity, uint64_t* count,
                                  burin_text* error) {
  return c::in_session(session, error, [&] {
    c::require(ranges, "ranges");
    c::require(count, "count");
    if (capacity == 0) c::reject("there is room for no range");
    const c::VertexValues values = session->values(attribute);
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
  return c::in_session(session, error, [&] {
    c::require(range, "range");
    const burin_target known =
        c::known_members(target, target && BURIN_HAS(target, burin_target, stride), "target");
    c::check(*range, session->session);
    c::read(*session, session->values(attribute), *range, known);
  });
}

burin_status burin_session_write(burin_session* session, burin_attribute attribute, const burin_range* range,
                                 const burin_source* source, burin_text* error) {
  return c::in_session(session, error, [&] {
    c::require(range, "range");
    if (session->stroke) c::reject("a stroke is open");
    const burin_source known =
        c::known_members(source, source && BURIN_HAS(source, burin_source, stride), "source");
    c::check(*range, session->session);
    if (attribute == BURIN_NORMALS) c::reject("normals follow from positions");
    const std::size_t size = session->values(attribute).size;
    const std::vector<float> values = c::taken(*range, known, size);
    const std::vector<Index> vertices = c::surface_vertices(*session, *range);
    if (attribute == BURIN_POSITIONS)
      c::move(*session, vertices, values);
    else
      c::paint(*session, attribute, vertices, values);
  });
}
