// `burin replay` with a brush that makes solids.
#include <burin/base/file.h>
#include <burin/surface/mesh_file.h>
#include <burin/surface/triangulate.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <sstream>

#include "host_stub/programs.h"
#include "host_stub/run_command.h"
#include "support/rods.h"
#include "support/shapes.h"

namespace burin::test {
namespace {

using nlohmann::json;

/// A unit sphere and a tube along a part of its equator.
struct Laid {
  CommandFolder folder;
  TriangleMesh mesh = sphere(5, 0.2, 3);
  std::string mesh_path = folder.write("sphere.obj", obj_text(mesh));
  std::string stroke =
      folder.write("a.stroke", equator_stroke(-0.6, 0.6, 61, "\"brush\":\"org.burin.tube\",\"radius\":0.2"));

  json replayed(const std::vector<std::string>& options) const {
    std::vector<std::string> arguments = {"replay", stroke, "--mesh", mesh_path, "--json"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return json::parse(burin_output(arguments));
  }
};

TEST(SolidParts, AreListedAndSavedBesideTheSurface) {
  const Laid laid;
  const std::string saved = laid.folder.path("out.ply"), vdb = laid.folder.path("out.vdb");
  const json told = laid.replayed({"--save-mesh", saved, "--save-vdb", vdb, "--voxel", "0.01"});
  ASSERT_EQ(told["parts"].size(), 1u);
  const json& part = told["parts"][0];
  EXPECT_EQ(part["voxel"], 0.01);
  const double r = 0.4 * 0.2, length = 1.2;
  // The middle runs one radius above the sphere, where t and d are wider by 1 + h.
  const double wider = (1 + r) * (1 + r) + r * r / 4;
  const double volume = wider * (std::numbers::pi * r * r * length + 4 * std::numbers::pi / 3 * r * r * r);
  EXPECT_NEAR(part["volume"].get<double>(), volume, 0.01 * volume);
  const PolygonMesh mesh = read_mesh(saved);
  EXPECT_EQ(mesh.positions.size(), laid.mesh.positions.size() + part["vertices"].get<std::size_t>());
  const PolygonMesh before = read_mesh(laid.mesh_path);
  EXPECT_TRUE(std::equal(before.positions.begin(), before.positions.end(), mesh.positions.begin()));
  EXPECT_EQ(read_file(vdb).substr(0, 4), " BDV");
}

TEST(SolidParts, AreLeftOutOnRequest) {
  const Laid laid;
  EXPECT_FALSE(laid.replayed({"--solid", "none"}).contains("parts"));
}

TEST(SolidParts, AreRefusedWhereTheyWouldTakeTooMuch) {
  const Laid laid;
  const std::string saved = laid.folder.path("out.ply");
  const ProcessResult refused =
      burin({"replay", laid.stroke, "--mesh", laid.mesh_path, "--voxel", "1e-5", "--save-mesh", saved});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_NE(refused.err.find("use larger voxels"), std::string::npos) << refused.err;
  EXPECT_FALSE(std::filesystem::exists(saved));
}

/// The sample's ewer after a groove that a sample stroke engraved, and a solid along the same stroke.
json merged_along_the_groove(const std::vector<std::string>& options) {
  const std::string stroke = BURIN_SAMPLES "/strokes/meander.stroke";
  const CommandFolder folder;
  const std::string grooved = folder.path("grooved.ply");
  burin_output({"replay", stroke, "--mesh", BURIN_SAMPLES "/meshes/ewer.obj", "--subdivide", "4",
                "--save-mesh", grooved, "--json"});
  std::vector<std::string> arguments = {"replay", stroke, "--mesh", grooved, "--json"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  return json::parse(burin_output(arguments))["merges"][0];
}

// The groove is as narrow as the solid, whose field is torn above its bottom, beyond the surface's focal
// points.
TEST(SolidMerges, WorkAlongTheGrooveOfTheSameStroke) {
  for (const std::vector<std::string>& options :
       {std::vector<std::string>{"--brush", "org.burin.tube", "--solid", "union"},
        {"--brush", "org.burin.carve", "--solid", "difference", "--voxel", "0.01"}}) {
    const json merge = merged_along_the_groove(options);
    EXPECT_GE(merge["least_angle"], 5) << options[1];
    EXPECT_GT(merge["triangles_added"], 10000) << options[1];
  }
}

TEST(SolidMerges, AreListedAndSavedAsOneSurface) {
  const Laid laid;
  const std::string saved = laid.folder.path("out.ply");
  const json told = laid.replayed({"--solid", "union", "--blend", "0.02", "--voxel", "0.02", "--param",
                                   "height=0", "--save-mesh", saved});
  EXPECT_FALSE(told.contains("parts"));
  ASSERT_EQ(told["merges"].size(), 1u);
  const json& merge = told["merges"][0];
  EXPECT_EQ(merge["voxel"], 0.02);
  EXPECT_EQ(merge["euler_before"], 2);
  EXPECT_EQ(merge["euler_after"], 2);
  EXPECT_GE(merge["least_angle"], 5);
  for (const char* step : {"solid", "distances", "contour", "join", "remesh", "rebuild"})
    EXPECT_GT(merge["seconds"][step], 0) << step;
  const PolygonMesh mesh = read_mesh(saved);
  EXPECT_EQ(mesh.face_sizes.size(), laid.mesh.triangles.size() -
                                        merge["triangles_removed"].get<std::size_t>() +
                                        merge["triangles_added"].get<std::size_t>());
}

// Manifold repairs nothing: what is no closed, oriented 2-manifold is refused.
TEST(SolidMerges, AreTakenByManifold) {
  if (!is_installed("node")) GTEST_SKIP() << not_installed("node");
  if (!std::filesystem::exists(BURIN_TESTS "/host_stub/programs/node_modules/manifold-3d"))
    GTEST_SKIP() << not_installed("Manifold");
  const Laid laid;
  const std::string saved = laid.folder.path("out.ply");
  for (const char* operation : {"union", "difference"})
    for (const char* blend : {"0", "0.02"}) {
      laid.replayed({"--solid", operation, "--blend", blend, "--voxel", "0.02", "--param", "height=0",
                     "--save-mesh", saved});
      const ProcessResult result =
          run_process({"node", BURIN_TESTS "/host_stub/programs/manifold_check.mjs", saved});
      std::istringstream told(result.out);
      std::string status;
      int genus = -1;
      double volume = 0;
      told >> status >> genus >> volume;
      EXPECT_EQ(status, "NoError") << result.err;
      EXPECT_EQ(genus, 0);
      const double own = extent_of(triangulate(read_mesh(saved))).volume;
      EXPECT_NEAR(volume, own, 1e-4 * own);
    }
}

TEST(SolidMerges, AreRefusedOnOpenSurfacesAndBelowTheFinestLevel) {
  const Laid laid;
  TriangleMesh open = laid.mesh;
  std::erase_if(open.triangles, [&](const Triangle& t) {
    const Vec3f& p = open.positions[t[0]];
    return p.z() > 0.9F && std::abs(p.x()) < 0.1F && p.y() > 0.02F && p.y() < 0.2F;
  });
  const std::string path = laid.folder.write("open.obj", obj_text(open)), saved = laid.folder.path("out.ply");
  const auto refused = [&](const std::vector<std::string>& options) {
    std::vector<std::string> arguments = {"replay",  laid.stroke,  "--param",     "height=0",
                                          "--solid", "difference", "--save-mesh", saved};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const ProcessResult result = burin(arguments);
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_FALSE(std::filesystem::exists(saved));
    return result.err;
  };
  EXPECT_NE(refused({"--mesh", path}).find("the surface is open at ("), std::string::npos);
  EXPECT_NE(
      refused({"--mesh", laid.mesh_path, "--subdivide", "1", "--sculpt-level", "0"}).find("--sculpt-level"),
      std::string::npos);
}

/// The stroke of a Laid, with a box bent along it; no brush.
struct LaidBox : Laid {
  std::string box = folder.write("box.obj",
                                 "v 0 0 0\nv 4 0 0\nv 0 1 0\nv 4 1 0\nv 0 0 2\nv 4 0 2\nv 0 1 2\nv 4 1 2\n"
                                 "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
                                 "f 1/1 3/2 4/3 2/4\nf 5/1 6/2 8/3 7/4\nf 1/1 2/2 6/3 5/4\n"
                                 "f 3/1 7/2 8/3 4/4\nf 1/1 5/2 7/3 3/4\nf 2/1 4/2 8/3 6/4\n");

  ProcessResult refused(const std::vector<std::string>& options) const {
    std::vector<std::string> arguments = {"replay", stroke, "--mesh", mesh_path, "--save-mesh", saved};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return burin(arguments);
  }
  std::string saved = folder.path("out.ply");
};

// A box of 1.2 x 0.4 x 0.2 before it is bent, on a sphere.
TEST(BentParts, AreListedAndSavedBesideTheSurface) {
  const LaidBox laid;
  const json told = laid.replayed({"--along-mesh", laid.box, "--save-mesh", laid.saved});
  ASSERT_EQ(told["parts"].size(), 1u);
  const json& part = told["parts"][0];
  EXPECT_FALSE(part.contains("voxel"));
  const double volume = 1.2 * 2 * std::sin(0.2) * (std::pow(1.2, 3) - 1) / 3;
  EXPECT_NEAR(part["volume"].get<double>(), volume, 0.005 * volume);
  const PolygonMesh mesh = read_mesh(laid.saved);
  EXPECT_EQ(mesh.positions.size(), laid.mesh.positions.size() + part["vertices"].get<std::size_t>());
  ASSERT_EQ(mesh.corner_uv.size(), mesh.face_vertices.size());
  EXPECT_EQ(std::ranges::max(mesh.corner_uv, {}, [](const Vec2f& uv) { return uv.x(); }).x(), 1);
  const auto two =
      laid.replayed({"--along-mesh", laid.box, "--along-spacing", "4.5", "--along-axes=-z,y", "--along-start",
                     laid.box, "--along-end", laid.box, "--along-twist", "0.5", "--along-height", "-0.5"});
  EXPECT_NE(two["result_hash"], told["result_hash"]);
}

// The box of 0.4 x 0.2, sunk by half of its height: what is above the sphere is added to it.
TEST(BentParts, BecomePartOfTheSurface) {
  const LaidBox laid;
  const json told = laid.replayed({"--along-mesh", laid.box, "--along-height", "-0.5", "--solid", "union",
                                   "--voxel", "0.01", "--save-mesh", laid.saved});
  EXPECT_FALSE(told.contains("parts"));
  ASSERT_EQ(told["merges"].size(), 1u);
  EXPECT_EQ(told["merges"][0]["voxel"], 0.01);
  EXPECT_EQ(told["merges"][0]["euler_after"], 2);
  EXPECT_GE(told["merges"][0]["least_angle"], 5);
  const double added = 1.2 * 2 * std::sin(0.2) * (std::pow(1.1, 3) - 1) / 3;
  EXPECT_NEAR(extent_of(triangulate(read_mesh(laid.saved))).volume - extent_of(laid.mesh).volume, added,
              0.02 * added);
  const json coarse = laid.replayed({"--along-mesh", laid.box, "--along-height", "-0.5", "--solid", "union"});
  const double voxel = coarse["merges"][0]["voxel"];
  EXPECT_TRUE(voxel >= 0.2 / 24 && voxel <= 0.2 / 8) << voxel;
}

TEST(BentParts, AreRefusedInOneLine) {
  const LaidBox laid;
  const std::string empty = laid.folder.write("empty.obj", "v 0 0 0\n"),
                    flat = laid.folder.write("flat.obj", "v 0 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\n");
  const auto line = [&](const std::vector<std::string>& options) {
    const ProcessResult result = laid.refused(options);
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(std::ranges::count(result.err, '\n'), 1) << result.err;
    EXPECT_FALSE(std::filesystem::exists(laid.saved));
    return result.err;
  };
  const std::string stroke = "burin: " + laid.stroke + ": stroke 1: ";
  EXPECT_EQ(line({"--along-mesh", laid.folder.path("none.obj")}),
            stroke + laid.folder.path("none.obj") + ": No such file or directory\n");
  EXPECT_EQ(line({"--along-mesh", empty}), stroke + empty + ": has no face\n");
  EXPECT_EQ(line({"--along-mesh", flat}), stroke + flat + ": the mesh has no length along the stroke\n");
  EXPECT_EQ(line({"--along-mesh", laid.box, "--along-end", flat}),
            stroke + flat + ": the mesh has no length along the stroke\n");
  EXPECT_NE(line({"--along-mesh", laid.box, "--along-spacing", "0"}).find("must be a number above 0"),
            std::string::npos);
  EXPECT_NE(line({"--along-mesh", laid.box, "--along-spacing", "1e-9"}).find("copies of the mesh"),
            std::string::npos);
  EXPECT_NE(line({"--along-mesh", laid.box, "--along-axes", "x,-x"}).find("must be two axes"),
            std::string::npos);
  EXPECT_NE(line({"--along-mesh", laid.box, "--dabs", "1"}).find("row of dabs"), std::string::npos);
  EXPECT_NE(line({"--along-twist", "1"}).find("--along-mesh"), std::string::npos);
}

TEST(SolidParts, RepeatWhatSaveVdbWrote) {
  const Laid laid;
  const std::string vdb = laid.folder.path("tube.vdb");
  laid.replayed({"--save-vdb", vdb, "--voxel", "0.02"});
  const json told = laid.replayed({"--brush", "org.burin.vdb-trail", "--param", "stamp=" + vdb});
  ASSERT_EQ(told["parts"].size(), 1u);
  EXPECT_GT(told["parts"][0]["volume"].get<double>(), 0);
}

TEST(SolidParts, AreNotMadeOfABrokenFile) {
  const Laid laid;
  const std::string vdb = laid.folder.path("tube.vdb"), saved = laid.folder.path("out.ply");
  laid.replayed({"--save-vdb", vdb, "--voxel", "0.02"});
  const std::string whole = read_file(vdb);
  for (const std::string& bytes :
       {std::string(), whole.substr(0, whole.size() / 2), std::string("no volume")}) {
    const std::string broken = laid.folder.write("broken.vdb", bytes);
    const ProcessResult refused =
        burin({"replay", laid.stroke, "--mesh", laid.mesh_path, "--brush", "org.burin.vdb-trail", "--param",
               "stamp=" + broken, "--save-mesh", saved});
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_NE(refused.err.find("broken.vdb: "), std::string::npos) << refused.err;
    EXPECT_EQ(std::count(refused.err.begin(), refused.err.end(), '\n'), 1) << refused.err;
    EXPECT_FALSE(std::filesystem::exists(saved));
  }
}

}  // namespace
}  // namespace burin::test
