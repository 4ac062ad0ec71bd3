#include <burin/surface/mesh_file.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <sstream>

#include "host_stub/run_command.h"
#include "sanitizers/sanitized.h"
#include "support/shapes.h"

namespace burin::test {
namespace {

constexpr const char* groove = "\"brush\":\"org.burin.groove\",\"radius\":0.3";

/// Every triangle with vertices of its own.
TriangleMesh split(const TriangleMesh& mesh) {
  TriangleMesh apart;
  for (const Triangle& triangle : mesh.triangles) {
    const auto first = static_cast<Index>(apart.positions.size());
    for (const Index vertex : triangle) apart.positions.push_back(mesh.positions[vertex]);
    apart.triangles.push_back({first, first + 1, first + 2});
  }
  return apart;
}

std::string read_text(const std::string& path) {
  std::ifstream in(path);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// The rows of a chart's table by their vertex, without it.
std::map<Index, std::string> rows(const std::string& path) {
  std::istringstream lines(read_text(path));
  std::map<Index, std::string> rows;
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    const std::size_t comma = line.find(',');
    rows[static_cast<Index>(std::stoul(line.substr(0, comma)))] += line.substr(comma) + '\n';
  }
  return rows;
}

/// A sphere, and the same with vertices apart.
struct Spheres {
  CommandFolder folder;
  TriangleMesh mesh = sphere(4, 0.2, 3), apart = split(mesh);
  std::string whole_path = folder.write("whole.obj", obj_text(mesh));
  std::string apart_path = folder.write("apart.obj", obj_text(apart));
  std::string stroke = folder.write("a.stroke", equator_stroke(-0.6, 0.6, 41, groove));

  Index corner(std::size_t vertex_apart) const { return mesh.triangles[vertex_apart / 3][vertex_apart % 3]; }
};

TEST(MeshInput, ChartsVerticesOfTheFileAsOneSurface) {
  const Spheres spheres;
  for (const std::string& path : {spheres.whole_path, spheres.apart_path})
    burin_output({"chart", spheres.stroke, "--mesh", path, "--csv", path + ".csv"});
  const auto whole = rows(spheres.whole_path + ".csv"), apart = rows(spheres.apart_path + ".csv");
  ASSERT_GT(whole.size(), 100u);
  std::size_t charted = 0;
  for (Index vertex = 0; vertex < spheres.apart.positions.size(); ++vertex) {
    const auto expected = whole.find(spheres.corner(vertex));
    const auto found = apart.find(vertex);
    ASSERT_EQ(expected == whole.end(), found == apart.end());
    if (found == apart.end()) continue;
    EXPECT_EQ(found->second.substr(0, 8), expected->second.substr(0, 8)) << vertex;
    ++charted;
  }
  EXPECT_GT(charted, 5 * whole.size());
}

TEST(MeshInput, TellsWhatItJoined) {
  const Spheres spheres;
  const nlohmann::json json = burin_json({"chart", spheres.stroke, "--mesh", spheres.apart_path})["mesh"];
  EXPECT_EQ(json["vertices"], spheres.mesh.positions.size());
  EXPECT_EQ(json["vertices_joined"], spheres.apart.positions.size() - spheres.mesh.positions.size());
  EXPECT_NEAR(json["weld_tolerance"].get<double>(), 4e-6, 1e-7);
  const std::string text = burin_output({"chart", spheres.stroke, "--mesh", spheres.apart_path});
  EXPECT_NE(
      text.find(fmt::format("; {} of {} vertices joined to others within 4e-06",
                            json["vertices_joined"].get<std::size_t>(), spheres.apart.positions.size())),
      std::string::npos)
      << text;
}

TEST(MeshInput, JoinsWithinTheToleranceAskedFor) {
  Spheres spheres;
  for (std::size_t i = 0; i < spheres.apart.positions.size(); ++i)
    spheres.apart.positions[i] *= 1 + 1e-3F * static_cast<float>(i % 3);
  const std::string path = spheres.folder.write("off.obj", obj_text(spheres.apart));
  const auto joined = [&](const std::vector<std::string>& options) {
    std::vector<std::string> arguments = {"chart", spheres.stroke, "--mesh", path, "--json"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return nlohmann::json::parse(burin(arguments).out)["mesh"]["vertices"].get<std::size_t>();
  };
  EXPECT_GT(joined({}), 2 * spheres.mesh.positions.size());
  EXPECT_EQ(joined({"--weld", "0.01"}), spheres.mesh.positions.size());
  EXPECT_EQ(joined({"--weld", "0"}), joined({}));
}

TEST(MeshInput, SavesTheVerticesOfTheFile) {
  const Spheres spheres;
  std::vector<PolygonMesh> saved;
  for (const std::string& path : {spheres.whole_path, spheres.apart_path}) {
    burin_output({"replay", spheres.stroke, "--mesh", path, "--save-mesh", spheres.folder.path("out.ply")});
    saved.push_back(read_mesh(spheres.folder.path("out.ply")));
  }
  ASSERT_EQ(saved[1].positions.size(), spheres.apart.positions.size());
  std::size_t moved = 0;
  for (std::size_t i = 0; i < spheres.apart.positions.size(); ++i) {
    EXPECT_LT((saved[1].positions[i] - saved[0].positions[spheres.corner(i)]).norm(), 1e-5) << i;
    moved += saved[1].positions[i] != spheres.apart.positions[i];
  }
  EXPECT_GT(moved, 500u);
  for (std::size_t i = 0; i < spheres.apart.triangles.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_EQ(saved[1].face_vertices[3 * i + k], spheres.apart.triangles[i][k]);
}

TEST(MeshInput, KeepsColoursOfVerticesAtOnePlace) {
  const Spheres spheres;
  std::string text;
  for (std::size_t i = 0; i < spheres.apart.positions.size(); ++i) {
    const Vec3f& p = spheres.apart.positions[i];
    text += fmt::format("v {} {} {} {}\n", p.x(), p.y(), p.z(), i % 3 == 0 ? "1 0 0" : "0 0 1");
  }
  for (const Triangle& t : spheres.apart.triangles)
    text += fmt::format("f {} {} {}\n", t[0] + 1, t[1] + 1, t[2] + 1);
  burin_output({"replay", spheres.stroke, "--mesh", spheres.folder.write("coloured.obj", text), "--save-mesh",
                spheres.folder.path("out.ply")});
  const PolygonMesh saved = read_mesh(spheres.folder.path("out.ply"));
  for (std::size_t i = 0; i < saved.paint.colours.size(); ++i)
    EXPECT_EQ(saved.paint.colours[i][0], i % 3 == 0 ? 255 : 0);
}

TEST(MeshInput, KeepsTextureCoordinatesOfWhatItSaves) {
  const CommandFolder folder;
  std::string cube = "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n" + cube_obj();
  for (std::size_t at = 0; (at = cube.find("\nf ", at)) != std::string::npos; at += 3)
    for (int corner = 1; corner <= 4; ++corner) {
      const std::size_t digit =
          cube.find_first_of("12345678", at + 3 + 4 * (static_cast<std::size_t>(corner) - 1));
      cube.insert(digit + 1, "/" + std::to_string(corner));
    }
  const std::string path = folder.write("cube.obj", cube);
  const std::string stroke = folder.write(
      "a.stroke", equator_stroke(-0.6, 0.6, 41, "\"brush\":\"org.burin.groove\",\"radius\":1.5"));
  const std::vector<std::string> all_options[] = {
      {"--refine", "off"}, {"--subdivide", "2"}, {"--refine", "auto"}};
  for (const std::vector<std::string>& options : all_options) {
    std::vector<std::string> command = {"replay", stroke,        "--mesh",
                                        path,     "--save-mesh", folder.path("out.ply")};
    command.insert(command.end(), options.begin(), options.end());
    burin_output(command);
    const PolygonMesh saved = read_mesh(folder.path("out.ply"));
    ASSERT_EQ(saved.corner_uv.size(), saved.face_vertices.size()) << options[1];
    for (const Vec2f& uv : saved.corner_uv) EXPECT_TRUE(uv.minCoeff() >= 0 && uv.maxCoeff() <= 1);
  }
}

TEST(MeshInput, DrawsFarFromTheOriginAsNearIt) {
  const CommandFolder folder;
  const TriangleMesh mesh = plane(1, 0.04, 5);
  const Vec3d far(448262.25, 5411932.5, -117);
  const auto files = [&](const Vec3d& at, const std::string& name) {
    std::string obj, stroke = fmt::format(
                         "{{\"burin_stroke\":1,\"space\":\"object\"}}\n{{\"begin\":{{{}}},"
                         "\"fields\":[\"x\",\"y\",\"z\"]}}\n",
                         groove);
    for (const Vec3f& p : mesh.positions)
      obj += fmt::format("v {} {} {}\n", p.x() + at.x(), p.y() + at.y(), p.z() + at.z());
    for (const Triangle& t : mesh.triangles) obj += fmt::format("f {} {} {}\n", t[0] + 1, t[1] + 1, t[2] + 1);
    for (int i = -20; i <= 20; ++i) stroke += fmt::format("[{},{},{}]\n", at.x() + 0.02 * i, at.y(), at.z());
    folder.write(name + ".obj", obj);
    folder.write(name + ".stroke", stroke + "{\"end\":true}\n");
    burin_output({"replay", folder.path(name + ".stroke"), "--mesh", folder.path(name + ".obj"), "--mirror",
                  "x", "--symmetry-centre", fmt::format("{},{},{}", at.x() + 0.25, at.y(), at.z()),
                  "--save-mesh", folder.path(name + ".ply")});
    return read_mesh(folder.path(name + ".ply"));
  };
  const PolygonMesh here = files(Vec3d::Zero(), "here"), there = files(far, "there");
  EXPECT_TRUE(here.origin.isZero(0));
  ASSERT_EQ(here.positions.size(), there.positions.size());
  double deepest = 0;
  for (std::size_t i = 0; i < here.positions.size(); ++i) {
    const Vec3d place = there.positions[i].cast<double>() + there.origin - far;
    EXPECT_LT((place - here.positions[i].cast<double>()).norm(), 1e-6) << i;
    deepest = std::min(deepest, place.z());
  }
  EXPECT_LT(deepest, -0.048) << "a groove was drawn";
}

TEST(MeshInput, TellsWhatItMakesNoUseOf) {
  const CommandFolder folder;
  const std::string mesh = folder.write("a.obj", "g one\nvn 0 0 1\n" + obj_text(sphere(3, 0, 1)));
  const std::string stroke = folder.write("a.stroke", equator_stroke(-0.6, 0.6, 41, groove));
  EXPECT_EQ(burin_json({"chart", stroke, "--mesh", mesh})["mesh"]["not_used"], "1 group, 1 normal");
  const std::string text = burin_output({"chart", stroke, "--mesh", mesh});
  EXPECT_NE(text.find("; not used: 1 group, 1 normal\n"), std::string::npos) << text;
}

TEST(MeshInput, RefusesWhatMemoryCannotHold) {
  if (sanitized) GTEST_SKIP() << "the address sanitizer needs terabytes of address space";
  const CommandFolder folder;
  const std::string mesh = folder.write("cube.obj", cube_obj());
  const ProcessResult result =
      run_process({"sh", "-c", "ulimit -v 4000000 && exec \"$0\" \"$@\"", BURIN_COMMAND, "render", "--mesh",
                   mesh, "--subdivide", "12", "--png", folder.path("a.png")});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(result.err,
            "burin: " + mesh +
                ": level 12 of this cage has 201326592 triangles, which need about 30 GB of memory; "
                "here are 4.1\n");
}

}  // namespace
}  // namespace burin::test
