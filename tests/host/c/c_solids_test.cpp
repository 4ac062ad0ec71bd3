// Solids that strokes make beside the surface or merge with it, and meshes that they bend, beside the classes
// of C++.
#include <burin/level_set/solid_mesh.h>
#include <gtest/gtest.h>

#include <Eigen/LU>

#include <filesystem>

#include "../../refine/refined.h"
#include "c_host.h"
#include "patch_follower.h"
#include "support/shapes.h"
#include "support/shared_data.h"

namespace burin::test {
namespace {

namespace fs = std::filesystem;

const std::vector<const char*> chain = {"brush=org.burin.chain", "radius=0.2"};
const std::vector<const char*> tube = {"brush=org.burin.tube", "radius=0.2", "params=height=0", "solid=union",
                                       "voxel=0.03"};

/// Over the side of the unit sphere.
std::vector<burin_sample> arc(double from, double to) {
  std::vector<burin_sample> samples;
  for (int i = 0; i <= 40; ++i) {
    auto sample = sized<burin_sample>();
    const double angle = from + i / 40. * (to - from);
    sample.position[0] = std::cos(angle);
    sample.position[1] = std::sin(angle);
    samples.push_back(sample);
  }
  return samples;
}

void draw(CSession& session, const std::vector<const char*>& settings,
          const std::vector<burin_sample>& samples) {
  session.begin(settings, 0);
  session.add(samples);
  session.end();
}

void draw(Session& session, const StrokeSettings& settings, const std::vector<burin_sample>& samples) {
  session.begin_stroke(settings);
  for (const burin_sample& sample : samples)
    session.add_sample(Eigen::Map<const Vec3d>(sample.position), 0, {}, Show::later);
  session.end_stroke();
}

StrokeSettings settings_of(const char* brush, ParamSettings params = {}) {
  StrokeSettings made = settings(brush, 0.2);
  made.params = std::move(params);
  made.fields = {};
  return made;
}

using ReadPart = decltype(burin_session_read_solid);

/// A part of a session, as a mesh of C++.
TriangleMesh part(CSession& session, ReadPart* read, std::uint64_t number) {
  burin_triangles* triangles = nullptr;
  session.check(read(session, number, &triangles, &session.error));
  auto arrays = sized<burin_mesh>();
  session.check(IN_C(burin_triangles_get)(triangles, &arrays, nullptr, &session.error));
  TriangleMesh mesh;
  mesh.positions.resize(arrays.vertex_count);
  mesh.triangles.resize(arrays.face_count);
  std::memcpy(static_cast<void*>(mesh.positions.data()), arrays.positions,
              arrays.vertex_count * sizeof(Vec3f));
  std::memcpy(static_cast<void*>(mesh.triangles.data()), arrays.corners,
              arrays.face_count * sizeof(Triangle));
  IN_C(burin_triangles_destroy)(triangles);
  return mesh;
}

void expect_same(const TriangleMesh& mesh, const TriangleMesh& expected) {
  EXPECT_GT(mesh.triangles.size(), 10u);
  EXPECT_TRUE(mesh.positions == expected.positions);
  EXPECT_TRUE(mesh.triangles == expected.triangles);
}

TEST(CSolids, BesideTheSurfaceAreMeshes) {
  const TriangleMesh mesh = sphere(4, 0.2, 3);
  CSession session(mesh);
  Session expected(make_surface(mesh), brushes());
  draw(session, chain, arc(-0.3, 0.3));
  draw(expected, settings_of("org.burin.chain"), arc(-0.3, 0.3));
  EXPECT_EQ(session.hash(), expected.result_hash());
  EXPECT_EQ(session.info().solid_count, 1u);
  expect_same(part(session, IN_C(burin_session_read_solid), 0), mesh_of(expected.parts()[0]));
  burin_triangles* none = nullptr;
  EXPECT_EQ(IN_C(burin_session_read_solid)(session, 1, &none, &session.error), BURIN_NOT_FOUND);
  session.check(IN_C(burin_session_undo)(session, &session.error));
  EXPECT_EQ(session.info().solid_count, 0u);
  EXPECT_EQ(IN_C(burin_session_read_solid)(session, 0, &none, &session.error), BURIN_NOT_FOUND);
  EXPECT_EQ(session.error.str(), "there are 0 of them");
  EXPECT_EQ(none, nullptr);
}

TEST(CSolids, OfFilesOfOpenVdbAreMade) {
  const TriangleMesh mesh = sphere(4, 0.2, 3);
  const std::string stamp = BURIN_SAMPLES "/solids/rail.vdb";
  CSession session(mesh);
  draw(session, {"brush=org.burin.vdb-trail", "radius=0.2", ("params=stamp=" + stamp).c_str()},
       arc(-0.3, 0.3));
  Session expected(make_surface(mesh), brushes());
  draw(expected, settings_of("org.burin.vdb-trail", {{"stamp", stamp}}), arc(-0.3, 0.3));
  EXPECT_EQ(session.hash(), expected.result_hash());
  EXPECT_EQ(session.info().solid_count, 1u);
}

TEST(CSolids, AreWhereTheObjectIs) {
  // Mirrored and scaled by powers of two, the object is the world to the bit.
  const double matrix[16] = {-2, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 1};
  const auto in_object = [](TriangleMesh mesh) {
    for (Vec3f& p : mesh.positions) p = Vec3f(-p.x() / 2, p.y(), p.z() * 2);
    for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
    return mesh;
  };
  const TriangleMesh world = sphere(4, 0.2, 3), object = in_object(world);
  burin_mesh arrays = arrays_of(object);
  arrays.transform = matrix;
  CSession session(arrays), expected(world);
  for (CSession* each : {&session, &expected}) draw(*each, chain, arc(-0.3, 0.3));
  expect_same(part(session, IN_C(burin_session_read_solid), 0),
              in_object(part(expected, IN_C(burin_session_read_solid), 0)));
}

TEST(CSolids, ThatAreMergedArePatches) {
  const TriangleMesh mesh = sphere(4, 0.2, 3);
  CSession session(refinable(mesh));
  Session expected(make_surface(mesh), brushes(), merge_solid);
  Follower arrays(session);
  const std::multiset<Triangle> whole = as_set(arrays.triangles);
  const std::vector<float> positions = arrays.positions;
  const std::uint64_t before = session.hash();
  StrokeSettings same = settings_of("org.burin.tube", {{"height", 0.0}});
  same.solid = SolidOperation::unite;
  same.voxel = 0.03;
  draw(session, tube, arc(-0.5, 0.5));
  draw(expected, same, arc(-0.5, 0.5));
  EXPECT_EQ(session.hash(), expected.result_hash());
  EXPECT_GT(arrays.follow(), 500u);
  EXPECT_EQ(arrays.kept, 0u) << "vertices behind those that are gone have other numbers";
  const std::multiset<Triangle> merged = as_set(arrays.triangles);
  draw(session, {"brush=org.burin.groove", "radius=0.2"}, arc(1.5, 2.5));
  draw(expected, settings_of("org.burin.groove"), arc(1.5, 2.5));
  EXPECT_EQ(arrays.follow(), 0u);
  EXPECT_EQ(arrays.kept, session.info().vertex_count);
  EXPECT_EQ(session.hash(), expected.result_hash());
  for (int i = 0; i < 2; ++i) session.check(IN_C(burin_session_undo)(session, &session.error));
  EXPECT_GT(arrays.follow(), 500u);
  EXPECT_EQ(as_set(arrays.triangles), whole);
  EXPECT_EQ(arrays.positions, positions);
  EXPECT_EQ(session.hash(), before);
  session.check(IN_C(burin_session_redo)(session, &session.error));
  arrays.follow();
  EXPECT_EQ(as_set(arrays.triangles), merged);

  CSession fixed(mesh);
  fixed.begin(tube, 0);
  fixed.add(arc(-0.5, 0.5));
  EXPECT_EQ(IN_C(burin_session_end)(fixed, &fixed.error), BURIN_ERROR);
  EXPECT_EQ(fixed.error.str(), "this application cannot merge solids with the surface");
  EXPECT_EQ(fixed.hash(), before);
}

TEST(CSolids, ThatAreMergedAreUndoneToTheBitsOfTheObject) {
  const double matrix[16] = {1.1, 0.2, 0, 0, -0.3, 0.9, 0.1, 0, 0, 0.1, 1.3, 0, 0.1, 0.2, 0.3, 1};
  TriangleMesh mesh = sphere(5, 0.2, 3);
  const Eigen::Matrix4d to_object = Eigen::Map<const Eigen::Matrix4d>(matrix).inverse();
  for (Vec3f& p : mesh.positions) p = (to_object * p.cast<double>().homogeneous()).head<3>().cast<float>();
  burin_mesh arrays = refinable(mesh);
  arrays.transform = matrix;
  CSession session(arrays);
  draw(session, {"brush=org.burin.tube", "radius=0.4", "params=height=-0.5", "solid=difference", "voxel=0.1"},
       arc(-0.5, 0.5));
  EXPECT_LT(session.info().vertex_count, mesh.positions.size()) << "some are gone, with their numbers";
  session.check(IN_C(burin_session_undo)(session, &session.error));
  const std::vector<float> now = session.read(BURIN_POSITIONS, 3);
  ASSERT_EQ(now.size(), 3 * mesh.positions.size());
  EXPECT_EQ(std::memcmp(now.data(), mesh.positions.data(), now.size() * sizeof(float)), 0);
}

TEST(CSolids, AndMeshesThatAreBentAreParts) {
  const TemporaryFolder folder;
  const fs::path link = folder.path() / "box.obj";
  const TriangleMesh box_mesh = box({1, 0.5f, 0.5f});
  const burin_mesh box_arrays = arrays_of(box_mesh);
  CText error;
  const std::vector<float> uv(6 * box_mesh.triangles.size(), 0.25f);
  auto values = sized<burin_mesh_values>();
  values.uv = uv.data();
  ASSERT_EQ(IN_C(burin_mesh_write)(link.c_str(), &box_arrays, &values, &error), BURIN_OK) << error.str();
  CSession session(sphere(4, 0.2, 3));
  draw(session, {"radius=0.2", ("along_mesh=" + link.string()).c_str()}, arc(-0.3, 0.3));
  ASSERT_EQ(session.info().bent_mesh_count, 1u);
  const TriangleMesh bent = part(session, IN_C(burin_session_read_bent_mesh), 0);
  EXPECT_GE(bent.triangles.size(), 12u);
  for (const Vec3f& p : bent.positions) EXPECT_NEAR(p.norm(), 1, 0.4) << p.transpose();

  burin_triangles* with_uv = nullptr;
  session.check(IN_C(burin_session_read_bent_mesh)(session, 0, &with_uv, &session.error));
  auto mesh = sized<burin_mesh>();
  session.check(IN_C(burin_triangles_get)(with_uv, &mesh, &values, &session.error));
  ASSERT_NE(values.uv, nullptr);
  EXPECT_EQ(std::count(values.uv, values.uv + 6 * mesh.face_count, 0.25f),
            std::ptrdiff_t(6 * mesh.face_count));
  IN_C(burin_triangles_destroy)(with_uv);
}

TEST(CSolids, WantTheirModuleOnlyWhenTheyAreShown) {
  const TemporaryFolder folder;
  const fs::path alone = folder.path() / "libburin.so.0";
  fs::copy_file(BURIN_C_LIBRARY, alone);
  const CLibrary library(alone);
  CText error;
  burin_library* made = nullptr;
  burin_session* session = nullptr;
  const TriangleMesh mesh = sphere(4, 0.2, 3);
  const burin_mesh arrays = arrays_of(mesh);
  const auto check = [&](burin_status status) { ASSERT_EQ(status, BURIN_OK) << error.str(); };
  check(library.find<decltype(burin_library_create)>("burin_library_create")(nullptr, &made, &error));
  check(
      library.find<decltype(burin_library_load)>("burin_library_load")(made, brushes_folder.c_str(), &error));
  check(
      library.find<decltype(burin_session_create)>("burin_session_create")(made, &arrays, &session, &error));
  std::vector<const char*> settings = chain;
  settings.push_back(nullptr);
  auto stroke = sized<burin_stroke>();
  stroke.settings = settings.data();
  const std::vector<burin_sample> samples = arc(-0.3, 0.3);
  check(library.find<decltype(burin_session_begin)>("burin_session_begin")(session, &stroke, &error));
  check(library.find<decltype(burin_session_add)>("burin_session_add")(session, samples.data(),
                                                                       samples.size(), nullptr, &error));
  check(library.find<decltype(burin_session_end)>("burin_session_end")(session, &error));
  burin_triangles* none = nullptr;
  EXPECT_EQ(library.find<ReadPart>("burin_session_read_solid")(session, 0, &none, &error), BURIN_ERROR);
  EXPECT_NE(error.str().find("burin-solids.so"), std::string::npos) << error.str();
  EXPECT_EQ(none, nullptr);
  library.find<decltype(burin_session_destroy)>("burin_session_destroy")(session);
  library.find<decltype(burin_library_destroy)>("burin_library_destroy")(made);
}

}  // namespace
}  // namespace burin::test
