#include <burin/surface/mesh_file.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "host_stub/run_command.h"
#include "support/shapes.h"

namespace burin::test {
namespace {

/// Rotates a position from y up to z up.
Vec3f turned(const Vec3f& place) { return {place.x(), -place.z(), place.y()}; }

std::vector<Vec3f> turned(std::vector<Vec3f> places) {
  for (Vec3f& place : places) place = turned(place);
  return places;
}

/// A stroke over the same places of a sphere as equator_stroke(), with z up.
std::string upright_stroke() {
  std::string text =
      "{\"burin_stroke\":1,\"space\":\"object\"}\n{\"begin\":{\"brush\":\"org.burin.groove\",\"radius\":0.3},"
      "\"fields\":[\"time\",\"x\",\"y\",\"z\"]}\n";
  for (int i = 0; i <= 40; ++i) {
    const double angle = -0.6 + 1.2 * i / 40;
    text += fmt::format("[{},{},{},0]\n", 0.01 * i, std::sin(angle), -std::cos(angle));
  }
  return text + "{\"end\":true}\n";
}

/// A bumpy sphere with y up and with z up, and a stroke for each.
class AxesOption : public testing::Test {
 protected:
  static TriangleMesh with_z_up(TriangleMesh mesh) {
    mesh.positions = turned(mesh.positions);
    return mesh;
  }

  std::vector<Vec3f> drawn(const std::string& on, const std::string& by, std::vector<std::string> options,
                           const std::string& saved = "saved.ply") {
    options.insert(options.begin(), {"replay", by, "--mesh", on, "--save-mesh", folder.path(saved)});
    burin_output(options);
    const PolygonMesh back = read_mesh(folder.path(saved));
    std::vector<Vec3f> places = back.positions;
    for (Vec3f& place : places) place += back.origin.cast<float>();
    return places;
  }

  std::string refused(std::vector<std::string> options) {
    options.insert(options.begin(), {"replay", y_stroke, "--mesh", y_mesh});
    const ProcessResult result = burin(options);
    EXPECT_EQ(result.exit_code, 2);
    return result.err;
  }

  CommandFolder folder;
  TriangleMesh mesh = sphere(4, 0.2, 5);
  std::string y_mesh = folder.write("y.obj", obj_text(mesh));
  std::string z_mesh = folder.write("z.obj", obj_text(with_z_up(mesh)));
  std::string y_stroke = folder.write(
      "y.stroke", equator_stroke(-0.6, 0.6, 41, "\"brush\":\"org.burin.groove\",\"radius\":0.3"));
  std::string z_stroke = folder.write("z.stroke", upright_stroke());
};

TEST_F(AxesOption, TurnsWhatIsSavedOnly) {
  const std::vector<Vec3f> as_is = drawn(y_mesh, y_stroke, {});
  EXPECT_NE(as_is, mesh.positions);
  EXPECT_EQ(drawn(y_mesh, y_stroke, {"--axes", "y-up"}), as_is);
  EXPECT_EQ(drawn(y_mesh, y_stroke, {"--axes", "y-up:z-up"}), turned(as_is));
  EXPECT_EQ(drawn(y_mesh, y_stroke, {"--axes", "y-up:as-is"}), as_is);
  const std::vector<Vec3f> z_up = drawn(z_mesh, z_stroke, {"--axes", "z-up:z-up"});
  EXPECT_EQ(turned(drawn(z_mesh, z_stroke, {"--axes", "z-up:y-up"})), z_up);
}

TEST_F(AxesOption, KnowsThatGltfIsYUp) {
  const std::vector<Vec3f> z_up = drawn(z_mesh, z_stroke, {});
  EXPECT_EQ(drawn(z_mesh, z_stroke, {}, "a.glb"), z_up);
  EXPECT_EQ(turned(drawn(z_mesh, z_stroke, {"--axes", "z-up"}, "a.glb")), z_up);
  EXPECT_EQ(drawn(z_mesh, z_stroke, {"--axes", "z-up:as-is"}, "a.glb"), z_up);
  write_mesh(folder.path("y.glb"), mesh);
  EXPECT_EQ(drawn(folder.path("y.glb"), y_stroke, {"--axes", "as-is:z-up"}),
            turned(drawn(y_mesh, y_stroke, {})));
}

TEST_F(AxesOption, LetsStrokesLandWhereTheyWereDrawn) {
  const std::vector<Vec3f> as_is = drawn(y_mesh, y_stroke, {});
  const std::vector<Vec3f> turned_stroke =
      drawn(y_mesh, z_stroke, {"--axes", "y-up", "--stroke-axes", "z-up"});
  for (std::size_t i = 0; i < as_is.size(); ++i) EXPECT_LT((turned_stroke[i] - as_is[i]).norm(), 1e-6F) << i;
  const nlohmann::json drawn_as_is = burin_json({"chart", y_stroke, "--mesh", y_mesh}),
                       drawn_turned = burin_json(
                           {"chart", z_stroke, "--mesh", y_mesh, "--axes", "y-up", "--stroke-axes", "z-up"});
  EXPECT_EQ(drawn_turned["vertices"], drawn_as_is["vertices"]);
  EXPECT_NEAR(drawn_turned["length"].get<double>(), drawn_as_is["length"].get<double>(), 1e-6);
}

TEST_F(AxesOption, TurnsWhatIsFarAwayWithItsDigits) {
  TriangleMesh far = mesh;
  std::string text;
  for (const Vec3f& place : mesh.positions)
    text += fmt::format("v {} {} {}\n", place.x() + 448256.0, place.y() + 64.0, place.z() - 5411840.0);
  for (const Triangle& triangle : mesh.triangles)
    text += fmt::format("f {} {} {}\n", triangle[0] + 1, triangle[1] + 1, triangle[2] + 1);
  const std::string stroke =
      "{\"burin_stroke\":1,\"space\":\"object\"}\n{\"begin\":{\"brush\":\"org.burin."
      "groove\",\"radius\":0.3},\"fields\":[\"x\",\"y\",\"z\"]}\n"
      "[448256.0,64,-5411839]\n[448256.3,64,-5411839]\n{\"end\":true}\n";
  burin_output({"replay", folder.write("far.stroke", stroke), "--mesh", folder.write("far.obj", text),
                "--axes", "y-up:z-up", "--save-mesh", folder.path("far.ply")});
  const PolygonMesh saved = read_mesh(folder.path("far.ply"));
  EXPECT_LT((saved.origin - Vec3d(448256, 5411840, 64)).norm(), 4);
  std::size_t moved = 0;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Vec3d place = saved.origin + saved.positions[i].cast<double>() - Vec3d(448256, 5411840, 64);
    moved += (place - turned(mesh.positions[i]).cast<double>()).norm() > 1e-5;
  }
  EXPECT_GT(moved, 10u);
  EXPECT_LT(moved, mesh.positions.size() / 2);
}

TEST_F(AxesOption, RefusesWhatItCannotKnow) {
  EXPECT_EQ(refused({"--axes", "as-is:z-up", "--save-mesh", folder.path("a.ply")}),
            "burin: --axes: which way is up in '" + y_mesh + "' is not known; --axes y-up or z-up tells\n");
  EXPECT_EQ(refused({"--stroke-axes", "z-up"}), "burin: --stroke-axes: which way is up in '" + y_mesh +
                                                    "' is not known; --axes y-up or z-up tells\n");
  EXPECT_NE(refused({"--axes", "x-up"}).find("--axes: takes as-is, y-up or z-up, not 'x-up'"),
            std::string::npos);
  EXPECT_NE(refused({"--axes", "y-up:"}).find("takes as-is, y-up or z-up, not ''"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(folder.path("a.ply")));
}

}  // namespace
}  // namespace burin::test
