// Sessions of libburin.so, beside sessions of the static libraries that this program is linked with.
#include <burin/host/replay.h>
#include <burin/host/stroke_pieces.h>
#include <burin/stroke/stroke_file.h>
#include <burin/surface/mesh_file.h>
#include <burin/surface/triangulate.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "c_host.h"

namespace burin::test {
namespace {

TriangleMesh rough_plane() { return shuffled(plane(1, 0.02, 4), 5); }

/// What a session of C++ makes of the wave.
std::uint64_t expected_hash(const TriangleMesh& mesh, const std::string& brush) {
  Session session(make_surface(mesh), brushes());
  StrokeSettings given = settings(brush);
  draw(session, given, wave());
  return session.result_hash();
}

/// Numbers of a type, `padding` bytes apart in groups of `group`, from an odd address on.
template <class Number, class From>
std::vector<char> packed(const From* numbers, std::size_t count, std::size_t group, std::size_t padding) {
  std::vector<char> bytes(1);
  for (std::size_t i = 0; i < count; ++i) {
    const auto number = static_cast<Number>(numbers[i]);
    bytes.resize(bytes.size() + sizeof number);
    std::memcpy(bytes.data() + bytes.size() - sizeof number, &number, sizeof number);
    if ((i + 1) % group == 0) bytes.resize(bytes.size() + padding);
  }
  return bytes;
}

/// The mesh in arrays of other types and strides.
template <class Real, class Whole>
std::uint64_t hash_from(const TriangleMesh& mesh, burin_number real, burin_number whole,
                        std::size_t padding) {
  const std::vector<char> positions =
      packed<Real>(mesh.positions.front().data(), 3 * mesh.positions.size(), 3, padding);
  const std::vector<char> corners =
      packed<Whole>(mesh.triangles.front().data(), 3 * mesh.triangles.size(), 3, padding);
  burin_mesh arrays = arrays_of(mesh);
  arrays.position_type = real;
  arrays.positions = positions.data() + 1;
  arrays.position_stride = padding ? 3 * sizeof(Real) + padding : 0;
  arrays.corner_type = whole;
  arrays.corners = corners.data() + 1;
  arrays.face_stride = padding ? 3 * sizeof(Whole) + padding : 0;
  CSession session(arrays);
  session.draw(groove, in_c(wave()));
  return session.hash();
}

TEST(CSession, DrawsTheSameBitsFromNumbersOfAnyTypeAndStride) {
  const TriangleMesh mesh = shuffled(plane(1, 0.04, 4), 5);
  const std::uint64_t expected = expected_hash(mesh, "org.burin.groove");
  EXPECT_EQ((hash_from<float, std::uint32_t>(mesh, BURIN_FLOAT32, BURIN_UINT32, 0)), expected);
  EXPECT_EQ((hash_from<float, std::uint32_t>(mesh, BURIN_FLOAT32, BURIN_UINT32, 20)), expected);
  EXPECT_EQ((hash_from<double, std::int32_t>(mesh, BURIN_FLOAT64, BURIN_UINT32, 4)), expected);
  EXPECT_EQ((hash_from<float, std::uint64_t>(mesh, BURIN_FLOAT32, BURIN_UINT64, 3)), expected);
  EXPECT_EQ((hash_from<double, std::int64_t>(mesh, BURIN_FLOAT64, BURIN_UINT64, 0)), expected);
}

/// A grid of quads, as a PolygonMesh.
PolygonMesh quads(int cells) {
  PolygonMesh mesh;
  for (int y = 0; y <= cells; ++y)
    for (int x = 0; x <= cells; ++x) {
      const Vec3d place(2. * x / cells - 1, 2. * y / cells - 1, 0.01 * ((x * 7 + y * 3) % 5));
      mesh.positions.push_back(place.cast<float>());
    }
  const auto at = [&](int x, int y) { return static_cast<Index>(y * (cells + 1) + x); };
  for (int y = 0; y < cells; ++y)
    for (int x = 0; x < cells; ++x) {
      mesh.face_sizes.push_back(4);
      for (const Index corner : {at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)})
        mesh.face_vertices.push_back(corner);
    }
  return mesh;
}

/// The grid with hexagons of two quads in its even rows.
PolygonMesh polygons(int cells) {
  const PolygonMesh grid = quads(cells);
  PolygonMesh mesh;
  mesh.positions = grid.positions;
  for (std::size_t face = 0; face < grid.face_sizes.size(); ++face) {
    const Index* const c = &grid.face_vertices[4 * face];
    const bool two = face / cells % 2 == 0 && face % cells + 1 < static_cast<std::size_t>(cells);
    mesh.face_sizes.push_back(two ? 6 : 4);
    if (two)
      mesh.face_vertices.insert(mesh.face_vertices.end(), {c[0], c[1], c[5], c[6], c[2], c[3]});
    else
      mesh.face_vertices.insert(mesh.face_vertices.end(), c, c + 4);
    if (two) ++face;
  }
  return mesh;
}

TEST(CSession, CutsQuadsAndPolygonsAsTheReadersOfFilesDo) {
  const PolygonMesh grid = quads(50), mixed = polygons(50);
  burin_mesh arrays = arrays_of(grid.positions, grid.face_vertices.data(), grid.face_sizes.size(), 4);
  CSession of_quads(arrays);
  of_quads.draw(groove, in_c(wave()));
  EXPECT_EQ(of_quads.hash(), expected_hash(triangulate(grid), "org.burin.groove"));

  const std::vector<std::uint64_t> corners(mixed.face_vertices.begin(), mixed.face_vertices.end()),
      sizes(mixed.face_sizes.begin(), mixed.face_sizes.end());
  arrays.corner_type = BURIN_UINT64;
  arrays.corners = corners.data();
  arrays.face_count = sizes.size();
  arrays.face_size = 0;
  arrays.face_sizes = sizes.data();
  CSession of_polygons(arrays);
  of_polygons.draw(groove, in_c(wave()));
  EXPECT_EQ(of_polygons.hash(), expected_hash(triangulate(mixed), "org.burin.groove"));
  EXPECT_NE(of_polygons.hash(), of_quads.hash());
}

TEST(CSession, MapsTheCallersOrderToTheSurfacesAndBack) {
  const TriangleMesh mesh = rough_plane();
  burin_mesh sorted = arrays_of(mesh);
  sorted.order = BURIN_ORDER_SURFACE;
  CSession callers(mesh), surfaces(sorted);
  callers.draw(groove, in_c(wave()));
  surfaces.draw(groove, in_c(wave()));
  EXPECT_EQ(callers.hash(), surfaces.hash());
  const std::size_t count = mesh.positions.size();
  for (CSession* session : {&callers, &surfaces}) {
    std::vector<std::uint32_t> there(count), back(count);
    session->check(IN_C(burin_session_read_map)(*session, BURIN_MAP_CALLER_TO_SURFACE, there.data(), count,
                                                &session->error));
    session->check(IN_C(burin_session_read_map)(*session, BURIN_MAP_SURFACE_TO_CALLER, back.data(), count,
                                                &session->error));
    EXPECT_FALSE(std::ranges::is_sorted(there));
    const std::vector<float> by_caller = callers.read(BURIN_POSITIONS, 3),
                             by_surface = surfaces.read(BURIN_POSITIONS, 3);
    for (std::size_t vertex = 0; vertex < count; ++vertex) {
      ASSERT_EQ(back[there[vertex]], vertex);
      ASSERT_EQ(std::memcmp(&by_caller[3 * vertex], &by_surface[3 * there[vertex]], 3 * sizeof(float)), 0);
    }
  }
}

TEST(CSession, GivesTheTrianglesInItsNumbers) {
  const TriangleMesh mesh = rough_plane();
  burin_mesh sorted = arrays_of(mesh);
  sorted.order = BURIN_ORDER_SURFACE;
  CSession callers(mesh), surfaces(sorted);
  const Surface surface = make_surface(mesh);
  std::vector<Triangle> given(mesh.triangles.size()), expected = surface.triangles;
  surfaces.check(
      IN_C(burin_session_read_triangles)(surfaces, given.front().data(), given.size(), &surfaces.error));
  EXPECT_EQ(given, expected);
  callers.check(
      IN_C(burin_session_read_triangles)(callers, given.front().data(), given.size(), &callers.error));
  for (Triangle& triangle : expected)
    for (Index& corner : triangle) corner = surface.source_vertex[corner];
  EXPECT_EQ(given, expected);
}

TEST(CSession, DrawsRecordingsAsReplayDoes) {
  const std::string stroke = std::string(BURIN_SAMPLES) + "/strokes/meander.stroke";
  const TriangleMesh mesh = triangulate(read_mesh(std::string(BURIN_SAMPLES) + "/meshes/ewer.obj"));
  Session expected(make_surface(mesh), brushes());
  GivenSettings bead;
  bead[&StrokeSettings::brush] = "org.burin.bead";
  replay(expected, read_strokes(stroke), bead);
  CSession session(mesh);
  session.update(BURIN_POSITIONS);
  const char* const texts[] = {"brush=org.burin.bead", nullptr};
  session.check(IN_C(burin_session_replay)(session, stroke.c_str(), texts, &session.error));
  EXPECT_EQ(session.hash(), expected.result_hash());
  EXPECT_EQ(session.info().undo_count, 1u);
  session.update(BURIN_POSITIONS);
  const std::vector<float> current = session.read(BURIN_POSITIONS, 3);
  EXPECT_EQ(std::memcmp(IN_C(burin_session_values)(session, BURIN_POSITIONS), current.data(),
                        current.size() * sizeof(float)),
            0);
}

TEST(CSession, CalmsSamplesAndClosesStrokesAsReplayDoes) {
  const std::vector<Sample> samples = wave();
  Recording recording;
  recording.strokes.resize(1);
  RecordedStroke& stroke = recording.strokes.front();
  stroke.settings[&StrokeSettings::brush] = "org.burin.groove";
  stroke.settings[&StrokeSettings::radius] = 0.15;
  stroke.settings[&ReplaySettings::closure] = Closure::closed;
  stroke.settings[&ReplaySettings::stabilising] = {Stabilising::Kind::string, 0.1};
  stroke.fields = {.time = true, .pressure = true, .tilt = true};
  stroke.samples = samples;
  Session expected(make_surface(rough_plane()), brushes());
  replay(expected, recording);
  CSession session(rough_plane());
  session.begin({"brush=org.burin.groove", "radius=0.15", "closed=yes", "stabilise=string:0.1"},
                BURIN_PEN_TIME | BURIN_PEN_PRESSURE | BURIN_PEN_TILT);
  session.add(in_c(samples));
  session.end();
  EXPECT_EQ(session.hash(), expected.result_hash());
}

TEST(CSession, TakesRaysAndBreaksStrokesBesideTheSurface) {
  std::vector<burin_sample> samples = in_c(wave());
  for (burin_sample& sample : samples) {
    sample.position[2] = 3;
    sample.direction[2] = -0.5;
  }
  samples[20].position[0] = 30;
  Session session(make_surface(rough_plane()), brushes());
  StrokePieces pieces(session, settings("org.burin.groove"));
  const std::vector<Sample> drawn = wave();
  for (std::size_t i = 0; i < drawn.size(); ++i)
    pieces.add(Ray{Vec3f(i == 20 ? 30 : static_cast<float>(drawn[i].position.x()),
                         static_cast<float>(drawn[i].position.y()), 3),
                   Vec3f(0, 0, -0.5f)},
               0, drawn[i].pen);
  pieces.end();
  CSession in_groups(rough_plane());
  in_groups.begin(groove);
  auto event = sized<burin_event>();
  in_groups.check(IN_C(burin_session_add)(in_groups, samples.data(), 21, &event, &in_groups.error));
  EXPECT_EQ(event.outcome, BURIN_OUTCOME_OFF_SURFACE);
  EXPECT_EQ(event.drawn, 20u);
  in_groups.add({samples.begin() + 21, samples.end()});
  in_groups.end();
  EXPECT_EQ(in_groups.hash(), session.result_hash());
}

TEST(CSession, TakesStructsOfLaterVersions) {
  struct LaterSample {
    burin_sample sample;
    double more[2];
  };
  struct LaterInfo {
    burin_session_info info;
    std::uint64_t more;
  };
  const TriangleMesh mesh = shuffled(plane(1, 0.04, 4), 5);
  std::vector<LaterSample> samples;
  for (const burin_sample& sample : in_c(wave())) {
    samples.push_back({sample, {1e300, -1}});
    samples.back().sample.struct_size = sizeof(LaterSample);
  }
  CSession session(mesh);
  session.begin(groove);
  session.check(
      IN_C(burin_session_add)(session, &samples.front().sample, samples.size(), nullptr, &session.error));
  session.end();
  EXPECT_EQ(session.hash(), expected_hash(mesh, "org.burin.groove"));
  LaterInfo info{{}, 77};
  info.info.struct_size = sizeof info;
  session.check(IN_C(burin_session_get_info)(session, &info.info, &session.error));
  EXPECT_EQ(info.info.struct_size, sizeof info);
  EXPECT_EQ(info.info.undo_count, 1u);
  EXPECT_EQ(info.more, 77u) << "what this version does not know";
}

TEST(CSession, ReadsColoursMasksAndNormalsAsTheyAre) {
  const TriangleMesh mesh = rough_plane();
  Session expected(make_surface(mesh), brushes());
  draw(expected, settings("org.burin.test.every-input"), wave());
  CSession session(mesh);
  EXPECT_EQ(session.read(BURIN_COLOURS, 4)[7], 0.f) << "bare";
  EXPECT_EQ(session.read(BURIN_MASKS, 1)[0], 1.f);
  session.draw(every_input, in_c(wave()));
  const std::vector<float> colours = session.read(BURIN_COLOURS, 4), masks = session.read(BURIN_MASKS, 1),
                           normals = session.read(BURIN_NORMALS, 3);
  for (Index vertex = 0; vertex < mesh.positions.size(); ++vertex) {
    const Index source = expected.surface().source_vertex[vertex];
    ASSERT_EQ(Eigen::Map<const Eigen::Vector4f>(&colours[4 * source]), expected.paint().colour_of(vertex));
    ASSERT_EQ(masks[source], expected.paint().mask_of(vertex));
    ASSERT_EQ(Eigen::Map<const Vec3f>(&normals[3 * source]), expected.normals()[vertex]);
  }
  std::vector<double> apart(2 * 5 * 3, -7);
  auto target = sized<burin_target>();
  target.type = BURIN_FLOAT64;
  target.data = apart.data();
  target.stride = 2 * 3 * sizeof(double);
  const burin_range few{11, 15};
  session.check(IN_C(burin_session_read)(session, BURIN_NORMALS, &few, &target, &session.error));
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(apart[6 * i + k], double{normals[3 * (11 + i) + k]});
      EXPECT_EQ(apart[6 * i + 3 + k], -7);
    }
  EXPECT_EQ(apart[24], -7);
}

TEST(CSession, GivesTheChartInItsNumbers) {
  const TriangleMesh mesh = rough_plane();
  Session expected(make_surface(mesh), brushes());
  draw(expected, settings("org.burin.groove"), wave());
  CSession session(mesh);
  session.draw(groove, in_c(wave()));
  auto chart = sized<burin_chart>();
  session.check(IN_C(burin_session_chart)(session, &chart, &session.error));
  const Chart& made = expected.chart();
  ASSERT_EQ(chart.count, made.size());
  EXPECT_GT(chart.count, 500u);
  EXPECT_EQ(chart.length, made.length);
  for (std::size_t node = 0; node < made.size(); ++node) {
    ASSERT_EQ(chart.vertex[node], expected.surface().source_vertex[made.vertex[node]]);
    ASSERT_EQ(chart.t[node], made.t[node]);
    ASSERT_EQ(chart.d[node], made.d[node]);
    ASSERT_EQ(chart.sheet[node], made.sheet[node]);
  }
}

}  // namespace
}  // namespace burin::test
