#include <burin/base/file.h>
#include <burin/subdiv/refine.h>
#include <burin/surface/mesh_file.h>
#include <burin/surface/triangulate.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <set>
#include <sstream>

#include "run_command.h"
#include "support/point_shapes.h"
#include "support/shapes.h"

namespace burin::test {
namespace {

/// The first cells of the rows of the table below a heading of docs/files.md, without their code marks; of
/// rows that begin so.
std::set<std::string> first_cells(const std::string& heading, const std::string& begin = "| `.") {
  const std::string page = read_file(std::filesystem::path(BURIN_SOURCE_FOLDER) / "docs/files.md");
  std::istringstream lines(page.substr(page.find("\n## " + heading + "\n")));
  std::set<std::string> cells;
  std::string line;
  std::getline(lines, line);
  std::getline(lines, line);
  while (std::getline(lines, line) && !line.starts_with("## ")) {
    if (!line.starts_with(begin)) continue;
    std::string cell = line.substr(2, line.find(" |", 2) - 2);
    std::erase(cell, '`');
    cells.insert(cell);
  }
  return cells;
}

std::string stl_text(const TriangleMesh& mesh) {
  std::string text = "solid a\n";
  for (const Triangle& triangle : mesh.triangles) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const Index vertex : triangle) {
      const Vec3f& p = mesh.positions[vertex];
      text += fmt::format("vertex {} {} {}\n", p.x(), p.y(), p.z());
    }
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid a\n";
}

/// A GLB file as a document with its buffer beside it.
std::string gltf_of(const CommandFolder& folder, const std::string& glb) {
  const std::string bytes = read_file(glb);
  const auto size = static_cast<std::size_t>(static_cast<unsigned char>(bytes[12])) |
                    static_cast<std::size_t>(static_cast<unsigned char>(bytes[13])) << 8;
  nlohmann::json json = nlohmann::json::parse(bytes.substr(20, size));
  json["buffers"][0]["uri"] = "a.bin";
  folder.write("a.bin", bytes.substr(28 + size));
  return json.dump();
}

/// A box without lid, with creases of different sharpness, and a tag more; refined twice.
TriangleMesh refined_box(const CommandFolder& folder, std::string tag) {
  const std::vector<std::pair<std::string, std::string>> values = {
      {" a b ", " 2 3 "}, {" v ", " 0 "},          {" face", " 0"},
      {" rule", " 0"},    {" method", " chaikin"}, {" sharpness", " 3"}};
  for (const auto& [name, value] : values)
    if (const std::size_t at = tag.find(name); at != std::string::npos) tag.replace(at, name.size(), value);
  const std::string box =
      "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
      "f 4 3 2 1\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\nt crease 4/2/0 0 1 1 2 1 2.5\n";
  const PolygonMesh cage = read_mesh(folder.write("box.obj", box + tag + "\n"));
  EXPECT_EQ(cage.not_used, "") << tag;
  return refine(cage, SubdivisionScheme::catmull_clark, 2);
}

class FilesPage : public testing::Test {
 protected:
  /// A sphere in the format of a row.
  std::string file_for(const std::string& row) {
    const std::string name = "mesh" + row.substr(0, row.find(' '));
    if (row == ".obj") return folder.write(name, obj_text(mesh));
    if (row == ".stl") return folder.write(name, stl_text(mesh));
    if (row == ".gltf") return folder.write(name, gltf_of(folder, file_for(".glb")));
    if (row == ".ply without faces") return folder.write("points.ply", ply_text(sphere_points(4, 1)));
    write_mesh(folder.path(name), mesh);
    return folder.path(name);
  }

  CommandFolder folder;
  TriangleMesh mesh = sphere(3, 0.2, 5);
  std::string stroke = folder.write(
      "a.stroke", equator_stroke(-0.6, 0.6, 41, "\"brush\":\"org.burin.groove\",\"radius\":0.4"));
};

TEST_F(FilesPage, NamesWhatIsRead) {
  const std::set<std::string> rows = first_cells("What is read");
  EXPECT_EQ(rows,
            (std::set<std::string>{".obj", ".ply", ".ply without faces", ".stl", ".off", ".gltf", ".glb"}));
  const nlohmann::json reference = burin_json({"chart", stroke, "--mesh", file_for(".obj")});
  for (const std::string& row : rows) {
    const nlohmann::json json = burin_json({"chart", stroke, "--mesh", file_for(row)});
    EXPECT_NEAR(json["length"].get<double>(), reference["length"].get<double>(), 0.02) << row;
    if (row == ".ply without faces") continue;
    EXPECT_EQ(json["mesh"]["vertices"], mesh.positions.size()) << row;
    EXPECT_EQ(json["vertices"], reference["vertices"]) << row;
  }
}

TEST_F(FilesPage, NamesWhatIsWritten) {
  const std::set<std::string> rows = first_cells("What is written");
  EXPECT_EQ(rows, (std::set<std::string>{".ply", ".glb", ".obj", ".off"}));
  std::vector<std::vector<Vec3f>> saved;
  for (const std::string& row : rows) {
    burin_output({"replay", stroke, "--mesh", file_for(".obj"), "--save-mesh", folder.path("saved" + row)});
    saved.push_back(read_mesh(folder.path("saved" + row)).positions);
    EXPECT_EQ(saved.back(), saved.front()) << row;
  }
  EXPECT_NE(saved.front(), mesh.positions);
  const ProcessResult refused =
      burin({"replay", stroke, "--mesh", file_for(".obj"), "--save-mesh", folder.path("a.fbx")});
  EXPECT_EQ(refused.err,
            "burin: " + folder.path("a.fbx") + ": meshes are written as .ply, .glb, .obj or .off files\n");
}

TEST_F(FilesPage, NamesTheTagsOfObj) {
  const std::set<std::string> rows = first_cells("Subdivision tags of OBJ", "| `t ");
  EXPECT_EQ(rows.size(), 5u);
  const TriangleMesh plain = refined_box(folder, "");
  for (const std::string& row : rows) {
    const TriangleMesh tagged = refined_box(folder, row);
    EXPECT_NE(std::pair(tagged.positions, tagged.triangles), std::pair(plain.positions, plain.triangles))
        << row;
  }
}

/// The table in the document has the options that AxesOption tests.
TEST_F(FilesPage, NamesTheAxes) {
  EXPECT_EQ(first_cells("Which way is up", "| "),
            (std::set<std::string>{"option", "---", "none, or --axes as-is", "--axes z-up",
                                   "--axes z-up:as-is", "--axes y-up:z-up", "--axes as-is:z-up"}));
}

}  // namespace
}  // namespace burin::test
