// Objects of an application: with a transform of their own, with hidden faces.
#include <burin/surface/polygon_mesh.h>
#include <burin/surface/triangulate.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <set>

#include "c_host.h"

namespace burin::test {
namespace {

Vec3f place_of(const std::vector<float>& values, std::size_t vertex) {
  return {values[3 * vertex], values[3 * vertex + 1], values[3 * vertex + 2]};
}

/// Samples that are rays from above.
std::vector<burin_sample> from_above(std::vector<burin_sample> samples) {
  for (burin_sample& sample : samples) {
    sample.position[2] += 5;
    sample.direction[2] = -1;
  }
  return samples;
}

// ---- Transforms ----

/// 4 x 4 by columns.
using Matrix = std::array<double, 16>;

/// Turned by 0.6 about z after a scale of (0.25, 2, 3), then sheared and moved; mirrored if told.
Matrix scaled_and_turned(bool mirrored) {
  const double c = std::cos(0.6), s = std::sin(0.6), x = mirrored ? -0.25 : 0.25;
  return {c * x, s * x, 0, 0, -s * 2, c * 2, 0, 0, 0, 0.3, 3, 0, 0.1, -0.2, 0.05, 1};
}

Vec3f in_world(const Matrix& m, const Vec3f& p) {
  Vec3f world;
  const Vec3d q = p.cast<double>();
  for (std::size_t i = 0; i < 3; ++i)
    world[static_cast<int>(i)] =
        static_cast<float>(m[i] * q.x() + m[4 + i] * q.y() + m[8 + i] * q.z() + m[12 + i]);
  return world;
}

/// An object whose place in the world is nearly the plane.
TriangleMesh object_of(const TriangleMesh& world, const Matrix& matrix) {
  TriangleMesh object = world;
  const Eigen::Matrix4d inverse = Eigen::Map<const Eigen::Matrix4d>(matrix.data()).inverse();
  for (Vec3f& p : object.positions) {
    const Eigen::Vector4d q(p.x(), p.y(), p.z(), 1);
    p = (inverse * q).head<3>().cast<float>();
  }
  return object;
}

class CTransform : public ::testing::TestWithParam<bool> {
 protected:
  /// The world's mesh as an application makes it itself: transformed, turned over if mirrored.
  TriangleMesh by_hand() const {
    TriangleMesh world = object;
    for (Vec3f& p : world.positions) p = in_world(matrix, p);
    if (GetParam())
      for (Triangle& t : world.triangles) std::swap(t[1], t[2]);
    return world;
  }
  burin_mesh arrays() const {
    burin_mesh made = arrays_of(object);
    made.transform = matrix.data();
    return made;
  }

  Matrix matrix = scaled_and_turned(GetParam());
  TriangleMesh object = [this] {
    TriangleMesh made = object_of(shuffled(plane(1, 0.03, 4), 5), matrix);
    if (GetParam())
      for (Triangle& t : made.triangles) std::swap(t[1], t[2]);
    return made;
  }();
};
INSTANTIATE_TEST_SUITE_P(Mirrored, CTransform, testing::Bool());

TEST_P(CTransform, DrawsInTheWorldWhatAnApplicationDrawsThatTransformsByItself) {
  CSession placed(arrays());
  const TriangleMesh world = by_hand();
  CSession expected(world);
  placed.draw(groove, in_c(wave(20)));
  expected.draw(groove, in_c(wave(20)));
  placed.draw(every_input, from_above(in_c(wave(20))));
  expected.draw(every_input, from_above(in_c(wave(20))));
  EXPECT_EQ(placed.hash(), expected.hash());
  EXPECT_EQ(placed.read(BURIN_COLOURS, 4), expected.read(BURIN_COLOURS, 4));

  const std::vector<float> there = placed.read(BURIN_POSITIONS, 3),
                           in_the_world = expected.read(BURIN_POSITIONS, 3);
  std::size_t moved = 0;
  float error = 0;
  for (std::size_t v = 0; v < object.positions.size(); ++v) {
    const Vec3f at = place_of(there, v);
    if (place_of(in_the_world, v) == world.positions[v])
      EXPECT_EQ(at, object.positions[v]) << "to the bit";
    else
      ++moved;
    error = std::max(error, (in_world(matrix, at) - place_of(in_the_world, v)).norm());
  }
  EXPECT_GT(moved, 300u);
  EXPECT_LT(moved, object.positions.size() - 300);
  EXPECT_LT(error, 2e-6f);
  for (int i = 0; i < 2; ++i) placed.check(IN_C(burin_session_undo)(placed, &placed.error));
  const std::vector<float> undone = placed.read(BURIN_POSITIONS, 3);
  EXPECT_EQ(std::memcmp(undone.data(), object.positions.data(), undone.size() * sizeof(float)), 0);
}

TEST_P(CTransform, KeepsFacesAndNormalsOutward) {
  CSession placed(arrays()), plain(object);
  const std::vector<float> normals = placed.read(BURIN_NORMALS, 3), expected = plain.read(BURIN_NORMALS, 3);
  for (std::size_t v = 0; v < object.positions.size(); ++v)
    ASSERT_LT((place_of(normals, v) - place_of(expected, v)).norm(), 1e-3f) << v;
  const auto oriented = [](CSession& session) {
    std::vector<std::uint32_t> corners(3 * session.info().triangle_count);
    session.check(
        IN_C(burin_session_read_triangles)(session, corners.data(), corners.size() / 3, &session.error));
    std::set<Triangle> triangles;
    for (std::size_t i = 0; i < corners.size(); i += 3) {
      Triangle t{corners[i], corners[i + 1], corners[i + 2]};
      std::ranges::rotate(t, std::ranges::min_element(t));
      triangles.insert(t);
    }
    return triangles;
  };
  EXPECT_EQ(oriented(placed), oriented(plain));
  // A groove goes inward, in the object too.
  placed.draw(groove, in_c(wave(20)));
  const std::vector<float> drawn = placed.read(BURIN_POSITIONS, 3);
  float deepest = 0;
  for (std::size_t v = 0; v < object.positions.size(); ++v)
    deepest = std::min(deepest, (place_of(drawn, v) - object.positions[v]).dot(place_of(normals, v)));
  EXPECT_LT(deepest, -0.005f);
}

TEST_P(CTransform, TellsWhatChangedAsTheObjectHasIt) {
  CSession placed(arrays());
  for (const burin_attribute attribute : {BURIN_POSITIONS, BURIN_NORMALS}) placed.update(attribute);
  std::vector<float> seen[] = {placed.read(BURIN_POSITIONS, 3), placed.read(BURIN_NORMALS, 3)};
  const auto expect_differences = [&] {
    std::size_t different = 0;
    for (std::size_t i = 0; i < 2; ++i) {
      const burin_attribute attribute = i == 0 ? BURIN_POSITIONS : BURIN_NORMALS;
      const std::vector<float> now = placed.read(attribute, 3);
      std::set<std::uint64_t> told, differ;
      for (const burin_range& range : placed.update(attribute))
        for (std::uint64_t v = range.begin; v < range.end; ++v) told.insert(v);
      for (std::size_t v = 0; v < now.size() / 3; ++v)
        if (std::memcmp(&now[3 * v], &seen[i][3 * v], 12) != 0) differ.insert(v);
      EXPECT_EQ(told, differ);
      const float* const values = IN_C(burin_session_values)(placed, attribute);
      EXPECT_EQ(std::memcmp(values, now.data(), now.size() * sizeof(float)), 0);
      seen[i] = now;
      different += differ.size();
    }
    return different;
  };
  placed.draw(groove, in_c(wave(15)));
  EXPECT_GT(expect_differences(), 300u);
  placed.check(IN_C(burin_session_undo)(placed, &placed.error));
  EXPECT_GT(expect_differences(), 300u);

  // Other tools move a vertex, one of them by less than the world's floats tell apart.
  auto source = sized<burin_source>();
  source.type = BURIN_FLOAT32;
  std::vector<float> moved(&seen[0][30], &seen[0][30] + 6);
  moved[0] = std::nextafter(moved[0], 9.f);
  moved[5] += 0.125f;
  source.data = moved.data();
  const burin_range range{10, 12};
  placed.check(IN_C(burin_session_write)(placed, BURIN_POSITIONS, &range, &source, &placed.error));
  EXPECT_GT(expect_differences(), 2u);
  EXPECT_EQ(std::vector<float>(&seen[0][30], &seen[0][30] + 6), moved) << "to the bit";
}

TEST(CTransformOfADisc, IsRoundInTheWorldAndNotInTheObject) {
  const Matrix wide = {4, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  const TriangleMesh object = object_of(shuffled(plane(1, 0.02, 4), 5), wide);
  burin_mesh arrays = arrays_of(object);
  arrays.transform = wide.data();
  CSession session(arrays);
  auto sample = sized<burin_sample>();
  sample.pressure = 1;
  session.draw({"brush=org.burin.groove", "radius=0.3", "dabs=1", "params=depth=0.5"}, {sample});
  const std::vector<float> drawn = session.read(BURIN_POSITIONS, 3);
  float across = 0, along = 0;
  for (std::size_t v = 0; v < object.positions.size(); ++v) {
    if (place_of(drawn, v) == object.positions[v]) continue;
    across = std::max(across, std::abs(object.positions[v].x()));
    along = std::max(along, std::abs(object.positions[v].y()));
  }
  EXPECT_GT(along, 0.2f);
  EXPECT_NEAR(across * 4, along, 0.04f);
}

TEST(CTransformOfASphere, IsRefusedWhereItHasNoInverse) {
  const TriangleMesh mesh = sphere(2, 0.1, 6);
  const Matrix identity = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  const char* const flat = "transform has no inverse: it makes the object flat";
  struct Wrong {
    const char* text;
    std::function<void(Matrix&)> change;
  };
  const Wrong wrong[] = {
      {flat, [](Matrix& m) { m[5] = 0; }},
      {flat,
       [](Matrix& m) {
         for (std::size_t i = 0; i < 3; ++i) {
           m[i] = 0.1 * static_cast<double>(i + 1);
           m[4 + i] = 0.3 * static_cast<double>(i + 1);
         }
       }},
      {flat, [](Matrix& m) { m = {}, m[15] = 1; }},
      {"transform has a number that is not finite",
       [](Matrix& m) { m[13] = std::numeric_limits<double>::quiet_NaN(); }},
      {"transform is not affine: its last row is not 0, 0, 0, 1", [](Matrix& m) { m[3] = 0.5; }},
      {"vertex 0 is not finite in the world", [](Matrix& m) { m[0] = m[5] = m[10] = 1e39; }},
  };
  for (const Wrong& one : wrong) {
    Matrix matrix = identity;
    one.change(matrix);
    burin_mesh arrays = arrays_of(mesh);
    arrays.transform = matrix.data();
    burin_session* session = nullptr;
    CText error;
    EXPECT_EQ(IN_C(burin_session_create)(c_brushes(), &arrays, &session, &error), BURIN_INVALID_ARGUMENT);
    EXPECT_EQ(error.str(), one.text);
    EXPECT_EQ(session, nullptr);
  }
  // Small scales are none.
  Matrix small = identity;
  small[0] = 1e-6, small[5] = 1e3;
  burin_mesh arrays = arrays_of(mesh);
  arrays.transform = small.data();
  CSession session(arrays);
  // A program of an older header has no such members; what lies there is not read.
  arrays.transform = reinterpret_cast<const double*>(1);
  arrays.hidden = reinterpret_cast<const std::uint8_t*>(1);
  arrays.struct_size = offsetof(burin_mesh, transform);
  CSession of_old(arrays);
  EXPECT_EQ(of_old.read(BURIN_POSITIONS, 3), session.read(BURIN_POSITIONS, 3));
}

// ---- Hidden faces ----

/// Whether the middle of a triangle is in a band that the wave crosses.
bool in_band(const TriangleMesh& mesh, const Triangle& t) {
  const Vec3f middle = (mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]]) / 3;
  return middle.x() > 0.1f && middle.x() < 0.45f;
}

/// A byte for each triangle.
std::vector<std::uint8_t> band_of(const TriangleMesh& mesh) {
  std::vector<std::uint8_t> hidden;
  for (const Triangle& t : mesh.triangles) hidden.push_back(in_band(mesh, t) ? 255 : 0);
  return hidden;
}

TriangleMesh without_band(TriangleMesh mesh) {
  std::erase_if(mesh.triangles, [&](const Triangle& t) { return in_band(mesh, t); });
  return mesh;
}

burin_status hide(CSession& session, const std::vector<std::uint8_t>& hidden) {
  return IN_C(burin_session_hide)(session, hidden.data(), hidden.size(), &session.error);
}

burin_mesh with_hidden(const TriangleMesh& mesh, const std::vector<std::uint8_t>& hidden) {
  burin_mesh arrays = arrays_of(mesh);
  arrays.hidden = hidden.data();
  return arrays;
}

class CHidden : public ::testing::Test {
 protected:
  TriangleMesh mesh = [] {
    TriangleMesh bumpy = shuffled(plane(1, 0.03, 4), 5);
    for (Vec3f& p : bumpy.positions)
      p.z() = static_cast<float>(0.05 * std::sin(9.0 * p.x()) * std::cos(7.0 * p.y()));
    return bumpy;
  }();
  std::vector<std::uint8_t> band = band_of(mesh), none = std::vector<std::uint8_t>(mesh.triangles.size());

  /// Expects that both show and draw the same.
  static void expect_same(CSession& a, CSession& b) {
    for (const auto* settings : {&groove, &every_input}) {
      EXPECT_EQ(a.read(BURIN_NORMALS, 3), b.read(BURIN_NORMALS, 3));
      for (CSession* session : {&a, &b}) session->draw(*settings, from_above(in_c(wave(25))));
      EXPECT_EQ(a.hash(), b.hash());
    }
    EXPECT_EQ(a.info().triangle_count, b.info().triangle_count);
  }
};

TEST_F(CHidden, FacesAreAsIfTheyWereNotThere) {
  CSession hiding(with_hidden(mesh, band)), expected(without_band(mesh)), whole(mesh);
  whole.draw(groove, in_c(wave(25)));
  expect_same(hiding, expected);
  const std::vector<float> drawn = hiding.read(BURIN_POSITIONS, 3), elsewise = whole.read(BURIN_POSITIONS, 3);
  std::vector<bool> seen(mesh.positions.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    if (!band[i])
      for (const Index v : mesh.triangles[i]) seen[v] = true;
  std::size_t kept = 0;
  for (std::size_t v = 0; v < seen.size(); ++v) {
    if (seen[v]) continue;
    EXPECT_EQ(place_of(drawn, v), mesh.positions[v]) << "to the bit";
    kept += place_of(elsewise, v) != mesh.positions[v];
  }
  EXPECT_GT(kept, 50u) << "the stroke would have moved them";

  auto event = sized<burin_event>();
  auto sample = sized<burin_sample>();
  sample.position[0] = 0.3;
  sample.position[2] = 5;
  sample.direction[2] = -1;
  hiding.begin(groove, 0);
  hiding.check(IN_C(burin_session_add)(hiding, &sample, 1, &event, &hiding.error));
  EXPECT_EQ(event.outcome, BURIN_OUTCOME_OFF_SURFACE);
}

TEST_F(CHidden, FacesMayChangeBetweenStrokes) {
  CSession session(with_hidden(mesh, none)), expected(without_band(mesh)), whole(mesh);
  session.update(BURIN_NORMALS);
  session.check(hide(session, band));
  EXPECT_EQ(session.info().triangle_count, expected.info().triangle_count);
  EXPECT_FALSE(session.update(BURIN_NORMALS).empty()) << "along the border";
  session.check(hide(session, none));
  EXPECT_EQ(session.info().triangle_count, whole.info().triangle_count);
  session.check(hide(session, band));
  expect_same(session, expected);
  for (CSession* each : {&session, &expected})
    for (int i = 0; i < 2; ++i) each->check(IN_C(burin_session_undo)(*each, &each->error));
  session.check(IN_C(burin_session_hide)(session, nullptr, 0, &session.error));
  expect_same(session, whole);
}

TEST_F(CHidden, FacesLeaveUndoAndStepsAsTheyAre) {
  CSession session(with_hidden(mesh, none));
  std::vector<std::vector<float>> states{session.read(BURIN_POSITIONS, 3)};
  session.draw(groove, in_c(wave(25)));
  states.push_back(session.read(BURIN_POSITIONS, 3));
  session.check(hide(session, band));
  session.draw(groove, from_above(in_c(wave(25))));
  states.push_back(session.read(BURIN_POSITIONS, 3));
  EXPECT_NE(states[1], states[2]);
  for (const bool shown : {true, false}) {
    session.check(hide(session, shown ? none : band));
    for (const std::size_t state : {1u, 0u}) {
      session.check(IN_C(burin_session_undo)(session, &session.error));
      EXPECT_EQ(session.read(BURIN_POSITIONS, 3), states[state]);
    }
    session.check(hide(session, shown ? band : none));
    for (const std::size_t state : {1u, 2u}) {
      session.check(IN_C(burin_session_redo)(session, &session.error));
      EXPECT_EQ(session.read(BURIN_POSITIONS, 3), states[state]);
    }
  }
  burin_step* step = nullptr;
  session.check(IN_C(burin_session_take_step)(session, &step, &session.error));
  session.check(hide(session, band));
  session.check(IN_C(burin_session_apply_step)(session, step, &session.error));
  EXPECT_EQ(session.read(BURIN_POSITIONS, 3), states[1]);
  IN_C(burin_step_destroy)(step);
  session.draw(groove, from_above(in_c(wave(25))));
  EXPECT_EQ(session.info().undo_count, 2u);
}

TEST_F(CHidden, FacesAreTheCallersWhateverTheyWereCutInto) {
  PolygonMesh grid;
  const int cells = 40;
  for (int y = 0; y <= cells; ++y)
    for (int x = 0; x <= cells; ++x)
      grid.positions.emplace_back(2.f * static_cast<float>(x) / cells - 1,
                                  2.f * static_cast<float>(y) / cells - 1, 0.f);
  const auto at = [&](int x, int y) { return static_cast<Index>(y * (cells + 1) + x); };
  std::vector<std::uint8_t> hidden;
  // Quads, and in every third row pairs of quads as hexagons.
  for (int y = 0; y < cells; ++y)
    for (int x = 0; x < cells; x += y % 3 == 0 ? 2 : 1) {
      if (y % 3 == 0)
        for (const Index corner :
             {at(x, y), at(x + 1, y), at(x + 2, y), at(x + 2, y + 1), at(x + 1, y + 1), at(x, y + 1)})
          grid.face_vertices.push_back(corner);
      else
        for (const Index corner : {at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)})
          grid.face_vertices.push_back(corner);
      grid.face_sizes.push_back(y % 3 == 0 ? 6 : 4);
      hidden.push_back(x > 22 && x < 30);
    }
  TriangleMesh left = triangulate(grid);
  std::vector<Triangle> shown;
  std::size_t triangle = 0;
  for (std::size_t face = 0; face < hidden.size(); ++face)
    for (Index i = 2; i < grid.face_sizes[face]; ++i, ++triangle)
      if (!hidden[face]) shown.push_back(left.triangles[triangle]);
  EXPECT_LT(shown.size(), left.triangles.size() - 200);
  left.triangles = shown;
  burin_mesh arrays = arrays_of(grid.positions, grid.face_vertices.data(), grid.face_sizes.size(), 0);
  arrays.face_sizes = grid.face_sizes.data();
  arrays.hidden = hidden.data();
  CSession session(arrays), expected(left);
  expect_same(session, expected);
}

TEST_F(CHidden, FacesThatCannotBeHiddenAreRefused) {
  CSession session(with_hidden(mesh, band)), without(mesh);
  const std::uint64_t triangles = session.info().triangle_count;
  const auto expect = [&](CSession& of, const std::vector<std::uint8_t>& hidden, burin_status status,
                          const std::string& text) {
    EXPECT_EQ(hide(of, hidden), status);
    EXPECT_EQ(of.error.str(), text);
  };
  const std::string count = std::to_string(mesh.triangles.size());
  const std::vector<std::uint8_t> all(mesh.triangles.size(), 1);
  expect(session, all, BURIN_ERROR, "no triangle with an area would be left to draw on");
  expect(session, {1, 0}, BURIN_INVALID_ARGUMENT, "the mesh has " + count + " faces");
  expect(without, band, BURIN_INVALID_ARGUMENT,
         "the session was made of a mesh without an array of hidden faces");
  session.begin(groove);
  expect(session, none, BURIN_INVALID_ARGUMENT, "a stroke is open");
  session.check(IN_C(burin_session_cancel)(session, &session.error));
  EXPECT_EQ(session.info().triangle_count, triangles);
  burin_session* made = nullptr;
  const burin_mesh arrays = with_hidden(mesh, all);
  EXPECT_EQ(IN_C(burin_session_create)(c_brushes(), &arrays, &made, &session.error), BURIN_ERROR);
  EXPECT_EQ(made, nullptr);
}

}  // namespace
}  // namespace burin::test
