#include "run_command.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

namespace burin::test {

std::string CommandFolder::write(const std::string& name, const std::string& text) const {
  std::ofstream(path(name), std::ios::binary) << text;
  return path(name);
}

std::set<std::string> CommandFolder::content() const {
  std::set<std::string> content;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_.path())) {
    content.insert(
        fmt::format("{} {}", entry.path().string(), entry.is_regular_file() ? entry.file_size() : 0));
  }
  return content;
}

ProcessResult burin(const std::vector<std::string>& arguments) {
  std::vector<std::string> command = {BURIN_COMMAND};
  command.insert(command.end(), arguments.begin(), arguments.end());
  return run_process(command, {"BURIN_PLUGIN_PATH="});
}

std::string burin_output(const std::vector<std::string>& arguments) {
  const ProcessResult result = burin(arguments);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  return result.out;
}

nlohmann::json burin_json(std::vector<std::string> arguments) {
  arguments.push_back("--json");
  return nlohmann::json::parse(burin_output(arguments));
}

std::string bad_plugin(const std::string& name) {
  return std::string(BURIN_BAD_PLUGINS) + "/" + name + ".burin";
}

std::string obj_text(const TriangleMesh& mesh) {
  std::string text;
  for (const Vec3f& p : mesh.positions) text += fmt::format("v {} {} {}\n", p.x(), p.y(), p.z());
  for (const Triangle& t : mesh.triangles) text += fmt::format("f {} {} {}\n", t[0] + 1, t[1] + 1, t[2] + 1);
  return text;
}

std::string ply_text(const PointSet& points) {
  std::string text = fmt::format("ply\nformat ascii 1.0\nelement vertex {}\n", points.positions.size());
  for (const char* name : {"x", "y", "z", "nx", "ny", "nz"}) text += fmt::format("property float {}\n", name);
  text += "end_header\n";
  for (std::size_t i = 0; i < points.positions.size(); ++i) {
    const Vec3f &p = points.positions[i], &n = points.normals[i];
    text += fmt::format("{} {} {} {} {} {}\n", p.x(), p.y(), p.z(), n.x(), n.y(), n.z());
  }
  return text;
}

std::string cube_obj() {
  return "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
         "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 3 4 8 7\nf 2 3 7 6\nf 4 1 5 8\n";
}

std::string equator_stroke_lines(double from, double to, int samples, const std::string& settings) {
  std::string text = fmt::format("{{\"begin\":{{{}}},\"fields\":[\"time\",\"x\",\"y\",\"z\"]}}\n", settings);
  for (int i = 0; i < samples; ++i) {
    const double angle = from + (to - from) * i / (samples - 1);
    text += fmt::format("[{},{},0,{}]\n", 0.01 * i, std::sin(angle), std::cos(angle));
  }
  return text + "{\"end\":true}\n";
}

std::string equator_stroke(double from, double to, int samples, const std::string& settings) {
  return "{\"burin_stroke\":1,\"space\":\"object\"}\n" + equator_stroke_lines(from, to, samples, settings);
}

}  // namespace burin::test
