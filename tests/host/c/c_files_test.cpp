// Files of recordings and meshes, and snapping, by libburin.so.
#include <burin/host/replay.h>
#include <burin/stroke/stroke_file.h>
#include <burin/subdiv/refine.h>
#include <burin/surface/mesh_file.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <limits>

#include "c_host.h"
#include "support/shared_data.h"

namespace burin::test {
namespace {

namespace fs = std::filesystem;

const fs::path samples_folder = BURIN_SAMPLES;
const fs::path ewer = samples_folder / "meshes/ewer.obj";

/// A recording that C has read.
class CRecording {
 public:
  explicit CRecording(const fs::path& path) {
    if (IN_C(burin_recording_read)(path.c_str(), &recording_, &error) != BURIN_OK)
      throw std::runtime_error(error.str());
  }
  CRecording(const CRecording&) = delete;
  CRecording& operator=(const CRecording&) = delete;
  ~CRecording() { IN_C(burin_recording_destroy)(recording_); }

  burin_recording_stroke stroke(std::uint64_t index) {
    auto stroke = sized<burin_recording_stroke>();
    EXPECT_EQ(IN_C(burin_recording_get_stroke)(recording_, index, &stroke, &error), BURIN_OK) << error.str();
    return stroke;
  }
  operator const burin_recording*() const { return recording_; }

  CText error;

 private:
  burin_recording* recording_ = nullptr;
};

/// The camera looks down on the plane.
Recording seen_on_a_screen() {
  Recording recording;
  recording.space = StrokeSpace::screen;
  recording.device = "Tablet";
  recording.camera =
      framing_camera(Vec3d(-1, -1, -0.1), Vec3d(1, 1, 0.1), -Vec3d::UnitZ(), Vec3d::UnitY(), 800, 800, 0.6);
  for (int number = 0; number < 2; ++number) {
    RecordedStroke stroke;
    stroke.settings[&StrokeSettings::brush] = number ? "org.burin.bead" : "org.burin.bark";
    stroke.settings[&StrokeSettings::radius] = 0.17;
    stroke.settings[&StrokeSettings::dynamics] = {{"strength", PenSource::pressure, {0, 0, 1, 1.5}}};
    stroke.fields = {.time = true, .pressure = true, .tilt = false, .twist = false, .barrel = number == 0};
    if (number == 0) stroke.drawn_by = {"pen", true};
    for (int i = 0; i < 30; ++i) {
      Sample sample;
      // Stamps of packets, which are repaired.
      sample.time = 0.02 * (i / 3);
      sample.position = Vec3d(200 + 13 * i, 300 + 40 * number + 3 * i, 0);
      sample.pen.pressure = static_cast<float>(i) / 30;
      sample.barrel = number == 0 && i == 7;
      stroke.samples.push_back(sample);
    }
    recording.strokes.push_back(stroke);
  }
  return recording;
}

void write(const Recording& recording, const fs::path& path) {
  StrokeWriter writer(path, recording.space, recording.camera, recording.device);
  for (const RecordedStroke& stroke : recording.strokes) {
    writer.begin(stroke);
    for (const Sample& sample : stroke.samples) writer.add(sample);
    writer.end();
  }
}

TEST(CRecordings, DrawnStrokeByStrokeHaveTheBitsOfAReplay) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "screen.stroke";
  write(seen_on_a_screen(), path);
  const TriangleMesh mesh = shuffled(plane(1, 0.04, 4), 5);
  Session expected(make_surface(mesh), brushes());
  replay(expected, read_strokes(path));

  CRecording recording(path);
  EXPECT_EQ(IN_C(burin_recording_stroke_count)(recording), 2u);
  EXPECT_STREQ(IN_C(burin_recording_device)(recording), "Tablet");
  CSession session(mesh);
  for (std::uint64_t i = 0; i < 2; ++i) {
    const burin_recording_stroke from = recording.stroke(i);
    EXPECT_EQ(from.fields, static_cast<std::uint32_t>(BURIN_PEN_TIME | BURIN_PEN_PRESSURE |
                                                      (i == 0 ? BURIN_PEN_BARREL : 0)));
    for (std::uint64_t k = 0; k < from.sample_count; ++k)
      EXPECT_EQ(from.samples[k].barrel, i == 0 && k == 7 ? 1U : 0U);
    EXPECT_STREQ(from.tool, i == 0 ? "pen" : "");
    EXPECT_EQ(from.eraser, i == 0 ? 1U : 0U);
    auto stroke = sized<burin_stroke>();
    stroke.fields = from.fields;
    stroke.settings = from.settings;
    stroke.seed = from.seed;
    session.check(IN_C(burin_session_begin)(session, &stroke, &session.error));
    session.check(IN_C(burin_session_add)(session, from.samples, from.sample_count, nullptr, &session.error));
    session.end();
  }
  EXPECT_EQ(session.hash(), expected.result_hash());
  auto none = sized<burin_recording_stroke>();
  EXPECT_EQ(IN_C(burin_recording_get_stroke)(recording, 2, &none, &recording.error), BURIN_NOT_FOUND);
}

/// The same strokes in the object, which can be stabilised.
Recording seen_in_the_object() {
  Recording recording = seen_on_a_screen();
  recording.space = StrokeSpace::object;
  recording.camera.reset();
  for (RecordedStroke& stroke : recording.strokes) {
    stroke.settings[&ReplaySettings::stabilising] = {.kind = Stabilising::Kind::string, .amount = 0.03};
    for (Sample& sample : stroke.samples) sample.position = (sample.position - Vec3d(400, 400, 0)) / 300;
  }
  return recording;
}

/// Draws a stroke that refines the surface. `knows`: whether its samples are told when it begins. Returns how
/// often the surface got other triangles after that.
std::uint64_t draw_refining(CSession& session, const burin_recording_stroke& from, bool knows) {
  std::vector<const char*> settings{"refine=auto"};
  for (const char* const* text = from.settings; *text; ++text) settings.push_back(*text);
  settings.push_back(nullptr);
  auto stroke = sized<burin_stroke>();
  stroke.fields = from.fields;
  stroke.settings = settings.data();
  stroke.seed = from.seed;
  if (knows) {
    stroke.path = from.samples;
    stroke.path_count = from.sample_count;
  }
  session.check(IN_C(burin_session_begin)(session, &stroke, &session.error));
  const std::uint64_t begun = session.info().generation;
  session.check(IN_C(burin_session_add)(session, from.samples, from.sample_count, nullptr, &session.error));
  session.end();
  return session.info().generation - begun;
}

TEST(CRecordings, ThatRefineHaveTheBitsOfAReplayHoweverTheyAreDrawn) {
  for (const Recording& recorded : {seen_on_a_screen(), seen_in_the_object()}) {
    const TemporaryFolder folder;
    const fs::path path = folder.path() / "refining.stroke";
    write(recorded, path);
    const TriangleMesh mesh = shuffled(plane(1, 0.4, 4), 5);
    burin_mesh refinable = arrays_of(mesh);
    refinable.refines = 1;
    Session expected(make_surface(mesh), brushes());
    GivenSettings overrides;
    overrides[&StrokeSettings::refining] = {.kind = Refining::Kind::automatic};
    const Recording whole = read_strokes(path);
    replay(expected, whole, overrides);
    ASSERT_EQ(expected.refinements().size(), 1u);
    // A replay refines for all strokes at once, an application for one after the other.
    Session one_by_one(make_surface(mesh), brushes());
    for (std::size_t i = 0; i < 2; ++i) {
      Recording so_far = whole;
      so_far.strokes.resize(i + 1);
      replay(one_by_one, so_far, overrides, {}, i);
    }
    ASSERT_GE(one_by_one.refinements().size(), 1u);

    CSession replayed(refinable), drawn(refinable), unaware(refinable);
    const char* const texts[] = {"refine=auto", nullptr};
    replayed.check(IN_C(burin_session_replay)(replayed, path.c_str(), texts, &replayed.error));
    EXPECT_EQ(replayed.hash(), expected.result_hash());
    CRecording recording(path);
    std::uint64_t refined_later = 0;
    for (std::uint64_t i = 0; i < 2; ++i) {
      EXPECT_EQ(draw_refining(drawn, recording.stroke(i), true), 0u) << "all was refined when it began";
      refined_later += draw_refining(unaware, recording.stroke(i), false);
    }
    EXPECT_EQ(drawn.hash(), one_by_one.result_hash());
    EXPECT_GT(refined_later, 0u);
    for (CSession* each : {&replayed, &drawn}) {
      for (int i = 0; i < 2; ++i) each->check(IN_C(burin_session_undo)(*each, &each->error));
      EXPECT_EQ(each->info().vertex_count, mesh.positions.size());
      EXPECT_EQ(each->info().triangle_count, mesh.triangles.size());
    }
  }
}

TEST(CRecordings, ThatAreCutOffAreRefused) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "cut.stroke";
  std::ofstream(path) << "{\"burin_stroke\":1,\"space\":\"object\"}\n{\"begin\":{},\"fields\":[\"x\",\"y\","
                         "\"z\"]}\n[0,0,0]\n";
  burin_recording* recording = nullptr;
  CText error;
  EXPECT_EQ(IN_C(burin_recording_read)(path.c_str(), &recording, &error), BURIN_ERROR);
  EXPECT_EQ(error.str(), path.string() + ":3: the recording is cut off here");
  EXPECT_EQ(recording, nullptr);
  EXPECT_EQ(IN_C(burin_recording_read)(nullptr, &recording, &error), BURIN_INVALID_ARGUMENT);
}

/// A mesh that C has read.
class CMeshFile {
 public:
  CMeshFile(const fs::path& path, const burin_refinement& options) {
    if (IN_C(burin_triangles_read)(path.c_str(), &options, &file_, &error) != BURIN_OK)
      throw std::runtime_error(error.str());
    EXPECT_EQ(IN_C(burin_triangles_get)(file_, &mesh, &values, &error), BURIN_OK) << error.str();
  }
  CMeshFile(const CMeshFile&) = delete;
  CMeshFile& operator=(const CMeshFile&) = delete;
  ~CMeshFile() { IN_C(burin_triangles_destroy)(file_); }

  burin_mesh mesh = sized<burin_mesh>();
  burin_mesh_values values = sized<burin_mesh_values>();
  CText error;

 private:
  burin_triangles* file_ = nullptr;
};

TEST(CMeshFiles, AreRefinedAsTheCommandDoes) {
  auto options = sized<burin_refinement>();
  options.levels = 2;
  const CMeshFile refined(ewer, options);
  const PolygonMesh cage = read_mesh(ewer);
  CSession from_file(refined.mesh), expected(refine(cage, natural_scheme(cage), 2));
  EXPECT_EQ(from_file.hash(), expected.hash());
  EXPECT_EQ(refined.values.colours, nullptr);

  burin_mesh arrays = arrays_of(cage.positions, cage.face_vertices.data(), cage.face_sizes.size(), 0);
  arrays.face_sizes = cage.face_sizes.data();
  burin_triangles* of_arrays = nullptr;
  CText error;
  ASSERT_EQ(IN_C(burin_triangles_refine)(&arrays, &options, &of_arrays, &error), BURIN_OK) << error.str();
  auto mesh = sized<burin_mesh>();
  ASSERT_EQ(IN_C(burin_triangles_get)(of_arrays, &mesh, nullptr, &error), BURIN_OK) << error.str();
  PolygonMesh smooth = cage;
  smooth.creases.clear();
  CSession without_creases(refine(smooth, natural_scheme(smooth), 2));
  EXPECT_EQ(CSession(mesh).hash(), without_creases.hash());
  EXPECT_NE(without_creases.hash(), expected.hash());
  IN_C(burin_triangles_destroy)(of_arrays);
  EXPECT_EQ(IN_C(burin_triangles_refine)(nullptr, &options, &of_arrays, &error), BURIN_INVALID_ARGUMENT);
  options.levels = 0;
  options.target_triangles = refined.mesh.face_count - 1;
  EXPECT_EQ(CMeshFile(ewer, options).mesh.face_count, refined.mesh.face_count);
}

TEST(CMeshFiles, KeepWhatIsPainted) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "painted.ply";
  const TriangleMesh mesh = plane(1, 0.25, 4);
  const std::size_t count = mesh.positions.size();
  std::vector<float> colours(4 * count, 1), masks(count, 0.25f);
  for (std::size_t i = 0; i < count; ++i) colours[4 * i] = i % 2 ? 0.f : 1.f;
  auto values = sized<burin_mesh_values>();
  values.colours = colours.data();
  values.masks = masks.data();
  values.origin[0] = 448256;
  const burin_mesh arrays = arrays_of(mesh);
  CText error;
  ASSERT_EQ(IN_C(burin_mesh_write)(path.c_str(), &arrays, &values, &error), BURIN_OK) << error.str();
  const CMeshFile read(path, sized<burin_refinement>());
  ASSERT_EQ(read.mesh.vertex_count, count);
  EXPECT_EQ(read.values.origin[0], 448256);
  EXPECT_TRUE(std::equal(masks.begin(), masks.end(), read.values.masks));
  EXPECT_TRUE(std::equal(colours.begin(), colours.end(), read.values.colours));
  EXPECT_EQ(IN_C(burin_mesh_write)("/no/such/folder/a.ply", &arrays, nullptr, &error), BURIN_ERROR);
  EXPECT_NE(error.str().find("/no/such/folder/a.ply"), std::string::npos);
  burin_triangles* none = nullptr;
  auto options = sized<burin_refinement>();
  options.levels = 16;
  EXPECT_EQ(IN_C(burin_triangles_read)(ewer.c_str(), &options, &none, &error), BURIN_INVALID_ARGUMENT);
  EXPECT_EQ(IN_C(burin_triangles_read)("/no/such.obj", nullptr, &none, &error), BURIN_ERROR);
}

TEST(CMeshFiles, KeepTextureCoordinatesOfTriangles) {
  const TemporaryFolder folder;
  const TriangleMesh mesh = plane(1, 0.5, 4);
  std::vector<float> uv;  // another island for each triangle
  for (std::size_t i = 0; i < 3 * mesh.triangles.size(); ++i) {
    uv.push_back(static_cast<float>(i) / 1024);
    uv.push_back(1 - static_cast<float>(i * i) / 65536);
  }
  auto values = sized<burin_mesh_values>();
  values.uv = uv.data();
  burin_mesh arrays = arrays_of(mesh);
  CText error;
  for (const char* name : {"a.obj", "a.ply", "a.glb"}) {
    const fs::path path = folder.path() / name;
    ASSERT_EQ(IN_C(burin_mesh_write)(path.c_str(), &arrays, &values, &error), BURIN_OK) << error.str();
    const CMeshFile read(path, sized<burin_refinement>());
    ASSERT_EQ(read.mesh.face_count, mesh.triangles.size()) << name;
    ASSERT_NE(read.values.uv, nullptr) << name;
    EXPECT_TRUE(std::equal(uv.begin(), uv.end(), read.values.uv)) << name;
  }
  const CMeshFile without(ewer, sized<burin_refinement>());
  EXPECT_EQ(without.values.uv, nullptr);
  arrays.face_size = 4;
  arrays.face_count = mesh.triangles.size() * 3 / 4;
  EXPECT_EQ(IN_C(burin_mesh_write)((folder.path() / "b.obj").c_str(), &arrays, &values, &error),
            BURIN_INVALID_ARGUMENT);
  EXPECT_NE(error.str().find("texture coordinates are of triangles"), std::string::npos) << error.str();
  EXPECT_FALSE(fs::exists(folder.path() / "b.obj"));
  arrays = arrays_of(mesh);
  uv[7] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(IN_C(burin_mesh_write)((folder.path() / "b.obj").c_str(), &arrays, &values, &error),
            BURIN_INVALID_ARGUMENT);
  EXPECT_NE(error.str().find("a texture coordinate is not finite"), std::string::npos) << error.str();
}

TEST(CSnapping, MovesSamplesToALineAsTheSnapperDoes) {
  TriangleMesh mesh = plane(1, 0.02, 4);
  for (Vec3f& at : mesh.positions) at.z() = 0.1f / (1 + 60 * at.y() * at.y());  // a ridge along y = 0
  CSession session(shuffled(mesh, 5));
  std::vector<burin_sample> samples;
  for (int i = 0; i < 12; ++i) {
    auto sample = sized<burin_sample>();
    sample.position[0] = -0.6 + 0.1 * i;
    sample.position[1] = 0.06;
    sample.position[2] = 1;
    sample.direction[2] = -1;
    samples.push_back(sample);
  }
  auto how = sized<burin_snap>();
  how.line = BURIN_LINE_RIDGE;
  how.radius = 0.2;
  auto snapped = sized<burin_snapped>();
  session.check(
      IN_C(burin_session_snap)(session, &how, samples.data(), samples.size(), 0, &snapped, &session.error));
  EXPECT_GT(snapped.share, 0.7);
  EXPECT_NEAR(snapped.mean_move, 0.06, 0.02);
  double y = 0;
  for (std::uint64_t i = snapped.sample_count / 4; i < 3 * snapped.sample_count / 4; ++i)
    y = std::max(y, std::abs(snapped.samples[i].position[1]));
  EXPECT_LT(y, 0.005);

  // Values of the vertices, in the caller's order: the crest is where they are, not where the ridge is.
  const std::vector<float> positions = session.read(BURIN_POSITIONS, 3);
  std::vector<float> values;
  for (std::size_t i = 0; i < positions.size(); i += 3)
    values.push_back(1 / (1 + 200 * (positions[i + 1] - 0.1f) * (positions[i + 1] - 0.1f)));
  how.line = BURIN_LINE_HIGH;
  how.values = values.data();
  session.check(
      IN_C(burin_session_snap)(session, &how, samples.data(), samples.size(), 0, &snapped, &session.error));
  EXPECT_NEAR(snapped.samples[snapped.sample_count / 2].position[1], 0.1, 0.01);

  // Seen from +y, the ridge's far inflection is a suggestive contour: that of 1 / (1 + 60 y^2).
  how.line = BURIN_LINE_SUGGESTIVE;
  how.view[1] = -1;
  how.view[2] = -1;
  session.check(
      IN_C(burin_session_snap)(session, &how, samples.data(), samples.size(), 0, &snapped, &session.error));
  EXPECT_NEAR(snapped.samples[snapped.sample_count / 2].position[1], -1 / std::sqrt(180.), 0.01);
  how.view[1] = how.view[2] = 0;
  how.line = BURIN_LINE_HIGH;

  const auto refused = [&](const char* text) {
    EXPECT_EQ(
        IN_C(burin_session_snap)(session, &how, samples.data(), samples.size(), 0, &snapped, &session.error),
        BURIN_INVALID_ARGUMENT);
    EXPECT_EQ(session.error.str(), text);
  };
  how.values = nullptr;
  refused("values is missing");
  how.line = BURIN_LINE_SILHOUETTE;
  refused("the line wants a view");
  how.line = BURIN_LINE_SUGGESTIVE;
  refused("the line wants a view");
  how.line = BURIN_LINE_CREASE;
  how.least_angle = 180;
  refused("the least angle is not below 180");
  how.least_angle = 0;
  how.line = 9;
  refused("there is no such line");
  how.line = BURIN_LINE_RIDGE;
  how.radius = 0;
  refused("the radius is not above 0");
  how.radius = 0.2;
  samples[3].position[0] = 50;
  EXPECT_EQ(
      IN_C(burin_session_snap)(session, &how, samples.data(), samples.size(), 0, &snapped, &session.error),
      BURIN_ERROR);
  EXPECT_EQ(session.error.str(), "sample 3 misses the surface");
}

}  // namespace
}  // namespace burin::test
