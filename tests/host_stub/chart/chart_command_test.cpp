#include <burin/stroke/stroke_file.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <map>
#include <numbers>
#include <sstream>

#include "host_stub/picture_file.h"
#include "host_stub/run_command.h"
#include "support/point_shapes.h"
#include "support/shapes.h"

namespace burin::test {
namespace {

struct Row {
  Index vertex, sheet;
  double t;
  float d;
  Vec3f e1;
};

constexpr const char* header = "vertex,sheet,t,d,e1x,e1y,e1z";

std::vector<std::string> lines_of(const std::string& path) {
  std::ifstream in(path);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

Row parse_row(const std::string& line) {
  std::istringstream in(line);
  std::vector<std::string> cells;
  for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
  if (cells.size() != 7) throw std::runtime_error("not seven cells: " + line);
  return {static_cast<Index>(std::stoul(cells[0])), static_cast<Index>(std::stoul(cells[1])),
          std::stod(cells[2]), std::stof(cells[3]),
          Vec3f(std::stof(cells[4]), std::stof(cells[5]), std::stof(cells[6]))};
}

std::vector<Row> read_csv(const std::string& path) {
  const std::vector<std::string> lines = lines_of(path);
  if (lines.empty() || lines[0] != header) throw std::runtime_error("wrong header");
  std::vector<Row> rows;
  std::transform(lines.begin() + 1, lines.end(), std::back_inserter(rows), parse_row);
  return rows;
}

/// A unit sphere in random vertex order and a stroke of this radius along its equator, angles -0.6 .. 0.6.
struct Equator {
  CommandFolder folder;
  TriangleMesh mesh = shuffled(sphere(5, 0.2, 7), 8);
  std::string mesh_path = folder.write("sphere.obj", obj_text(mesh));
  std::string stroke = folder.write("a.stroke", equator_stroke(-0.6, 0.6, 61, "\"radius\":0.2"));

  std::vector<Row> chart(const std::vector<std::string>& options) {
    std::vector<std::string> arguments = {"chart",   stroke,  "--mesh",
                                          mesh_path, "--csv", folder.path("a.csv")};
    arguments.insert(arguments.end(), options.begin(), options.end());
    burin_output(arguments);
    return read_csv(folder.path("a.csv"));
  }
};

/// Rows of the file's points on the unit sphere, for the stroke along the equator.
void expect_equator(const std::vector<Row>& rows, const std::vector<Vec3f>& positions) {
  ASSERT_GT(rows.size(), 300u);
  std::size_t beside = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Row& row = rows[i];
    if (i > 0) {
      EXPECT_LT(rows[i - 1].vertex, row.vertex);
    }
    EXPECT_EQ(row.sheet, 0u);
    EXPECT_NEAR(row.e1.norm(), 1, 1e-5);
    const Vec3d p = positions[row.vertex].cast<double>();
    if (row.t < 0 || row.t > 1.2) continue;
    ++beside;
    EXPECT_NEAR(row.d, std::asin(p.y()), 0.004) << "left of the travel from -x to x, seen from z, is up";
    EXPECT_NEAR(row.t, std::atan2(p.x(), p.z()) + 0.6, 0.01);
    EXPECT_GT(row.e1.dot(Vec3f(static_cast<float>(p.z()), 0, static_cast<float>(-p.x()))), 0.95f);
  }
  EXPECT_GT(beside, 250u);
}

TEST(ChartCommand, TabulatesTheStrokeByTheVerticesOfTheFile) {
  Equator equator;
  expect_equator(equator.chart({}), equator.mesh.positions);
}

TEST(ChartCommand, ChartsAPointSet) {
  Equator equator;
  equator.mesh_path =
      equator.folder.write("points.ply", ply_text(points_of(equator.mesh, [](const Vec3f& x) { return x; })));
  expect_equator(equator.chart({}), equator.mesh.positions);
  const auto report = burin_json({"chart", equator.stroke, "--mesh", equator.mesh_path});
  EXPECT_EQ(report["mesh"]["vertices"], equator.mesh.positions.size());
  EXPECT_EQ(report["mesh"]["triangles"], 0);
  const std::string text = burin_output({"chart", equator.stroke, "--mesh", equator.mesh_path});
  EXPECT_NE(text.find(fmt::format("{} points\n", equator.mesh.positions.size())), std::string::npos) << text;
}

TEST(ChartCommand, WritesNumbersThatReadBackAsTheyWere) {
  Equator equator;
  equator.chart({});
  const std::vector<std::string> lines = lines_of(equator.folder.path("a.csv"));
  std::size_t long_numbers = 0;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const Row row = parse_row(lines[i]);
    EXPECT_EQ(lines[i], fmt::format("{},{},{},{},{},{},{}", row.vertex, row.sheet, row.t, row.d, row.e1.x(),
                                    row.e1.y(), row.e1.z()));
    long_numbers += lines[i].size() > 60 ? 1 : 0;
  }
  EXPECT_GT(long_numbers, lines.size() / 2) << "all digits of the numbers are there";
}

TEST(ChartCommand, EndsAsTheCapSays) {
  Equator equator;
  const auto [first, last] = [&] {
    const std::vector<Row> rows = equator.chart({"--cap", "round"});
    const auto less = [](const Row& a, const Row& b) { return a.t < b.t; };
    return std::pair(std::min_element(rows.begin(), rows.end(), less)->t,
                     std::max_element(rows.begin(), rows.end(), less)->t);
  }();
  EXPECT_LT(first, -0.12);
  EXPECT_GT(last, 1.2 + 0.12);
  const std::vector<Row> butt = equator.chart({"--cap", "butt"});
  ASSERT_GT(butt.size(), 200u);
  for (const Row& row : butt) {
    EXPECT_GE(row.t, 0);
    EXPECT_LE(row.t, 1.2001);
  }
}

TEST(ChartCommand, TakesTheRadiusOfTheCommandLine) {
  Equator equator;
  float widest = 0;
  for (const Row& row : equator.chart({"--radius", "0.35"})) widest = std::max(widest, std::abs(row.d));
  EXPECT_LE(widest, 0.35f);
  EXPECT_GT(widest, 0.32f);
}

TEST(ChartCommand, ChoosesTheStroke) {
  Equator equator;
  equator.stroke = equator.folder.write("b.stroke", equator_stroke(-0.6, 0.6, 61, "\"radius\":0.2") +
                                                        equator_stroke_lines(0, 0.5, 26, "\"radius\":0.1"));
  const auto chart = [&](const std::string& number) {
    return burin_json({"chart", equator.stroke, "--mesh", equator.mesh_path, "--stroke", number});
  };
  EXPECT_NEAR(chart("1")["length"], 1.2, 1e-3);
  EXPECT_NEAR(chart("2")["length"], 0.5, 1e-3);
  EXPECT_EQ(chart("2")["radius"], 0.1);
}

TEST(ChartCommand, TakesTheLongestPieceOfABrokenStroke) {
  Equator equator;
  std::string text = equator_stroke(-0.6, 0.6, 61, "\"radius\":0.2");
  // Far off the surface for one sample after 0.4 of length.
  const std::string sample = "[0.2,";
  const std::size_t at = text.find(sample);
  text.replace(at, text.find('\n', at) - at, "[0.2,9,9,9]");
  equator.stroke = equator.folder.write("b.stroke", text);
  const ProcessResult result = burin({"chart", equator.stroke, "--mesh", equator.mesh_path, "--json"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_NE(result.err.find("2 pieces"), std::string::npos) << result.err;
  EXPECT_NEAR(nlohmann::json::parse(result.out)["length"], 39 * 0.02, 1e-3);
}

TEST(ChartCommand, TabulatesASheetForEachTimeAround) {
  Equator equator;
  equator.stroke = equator.folder.write("b.stroke", equator_stroke(0, 12, 601, "\"radius\":0.2"));
  const std::vector<Row> rows = equator.chart({});
  std::size_t twice = 0;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const Row &before = rows[i - 1], &row = rows[i];
    ASSERT_EQ(row.sheet, row.vertex == before.vertex ? before.sheet + 1 : 0);
    if (row.sheet == 0) continue;
    ++twice;
    EXPECT_NEAR(row.t - before.t, 2 * std::numbers::pi, 0.01);
    EXPECT_NEAR(row.d, before.d, 0.01);
  }
  EXPECT_GT(twice, 1000u);
  const auto report = burin_json({"chart", equator.stroke, "--mesh", equator.mesh_path});
  EXPECT_EQ(report["sheets"], 2);
  EXPECT_EQ(report["nodes"], rows.size());
  EXPECT_EQ(report["vertices"], rows.size() - twice);
  const std::string text = burin_output({"chart", equator.stroke, "--mesh", equator.mesh_path});
  EXPECT_NE(text.find("up to 2 sheets"), std::string::npos) << text;
}

TEST(ChartCommand, ClosesTheStrokeAsRecordedOrTold) {
  Equator equator;
  const double around = 2 * std::numbers::pi;
  const std::string text = equator_stroke(0, around - 0.05, 120, "\"radius\":0.2,\"closed\":true");
  equator.stroke = equator.folder.write("b.stroke", text);
  const std::vector<Row> rows = equator.chart({});
  for (const Row& row : rows) {
    ASSERT_EQ(row.sheet, 0u);
    ASSERT_GE(row.t, 0);
    ASSERT_LT(row.t, around);
    const Vec3d p = equator.mesh.positions[row.vertex].cast<double>();
    EXPECT_NEAR(std::remainder(row.t - std::atan2(p.x(), p.z()), around), 0, 0.01);
  }
  const auto report = [&](const std::string& closed) {
    return burin_json({"chart", equator.stroke, "--mesh", equator.mesh_path, "--closed", closed});
  };
  EXPECT_EQ(report("no")["closed"], false);
  EXPECT_NEAR(report("no")["length"], around - 0.05, 2e-3);
  EXPECT_EQ(report("auto")["closed"], true);
  EXPECT_NEAR(report("auto")["length"], around, 2e-3);
  equator.stroke = equator.folder.write("c.stroke", equator_stroke(0, 3, 120, "\"radius\":0.2"));
  EXPECT_EQ(report("auto")["closed"], false);
  equator.stroke = equator.folder.write("d.stroke", equator_stroke(0, 3, 2, "\"radius\":0.2"));
  const ProcessResult result =
      burin({"chart", equator.stroke, "--mesh", equator.mesh_path, "--closed", "yes"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_NE(result.err.find("stroke 1 stays open"), std::string::npos) << result.err;
}

TEST(ChartCommand, ChartsToTheOrderAskedFor) {
  Equator equator;
  const auto t_of = [](const std::vector<Row>& rows) {
    std::vector<double> numbers;
    for (const Row& row : rows) numbers.push_back(row.t);
    return numbers;
  };
  const std::vector<double> first = t_of(equator.chart({"--order", "1"}));
  EXPECT_NE(t_of(equator.chart({})), first);
  EXPECT_EQ(t_of(equator.chart({})), t_of(equator.chart({"--order", "2"})));
  EXPECT_NE(burin({"chart", equator.stroke, "--mesh", equator.mesh_path, "--order", "3"}).exit_code, 0);
}

// Bumps of a fifth of an edge of the equator's sphere are narrow against the brush.
TEST(ChartCommand, FollowsReliefAsRecordedOrTold) {
  Equator equator;
  equator.mesh = shuffled(sphere(6, 0.2, 7), 8);
  for (Vec3f& at : equator.mesh.positions)
    at *= 1 + 0.008F * std::sin(80 * at.x()) * std::sin(80 * at.y()) * std::sin(80 * at.z());
  equator.mesh_path = equator.folder.write("bumpy.obj", obj_text(equator.mesh));
  const auto worst_d = [&](const std::vector<std::string>& options) {
    double worst = 0;
    for (const Row& row : equator.chart(options)) {
      if (row.t < 0 || row.t > 1.2) continue;
      const Vec3d p = equator.mesh.positions[row.vertex].cast<double>().normalized();
      worst = std::max(worst, std::abs(row.d - std::asin(p.y())));
    }
    return worst;
  };
  const double own_scale = worst_d({}), every_bump = worst_d({"--follow", "1"});
  EXPECT_LT(own_scale, 0.002);
  EXPECT_GT(every_bump, 5 * own_scale);
  EXPECT_EQ(worst_d({"--follow", "0"}), own_scale);
  equator.stroke =
      equator.folder.write("b.stroke", equator_stroke(-0.6, 0.6, 61, "\"radius\":0.2,\"follow\":1"));
  EXPECT_EQ(worst_d({}), every_bump);
  EXPECT_EQ(worst_d({"--follow", "0"}), own_scale);
}

TEST(ChartCommand, JoinsBendsAsTold) {
  const CommandFolder folder;
  const TriangleMesh plane = test::plane(1, 0.02, 1);
  const std::string mesh = folder.write("plane.obj", obj_text(plane));
  std::string text =
      "{\"burin_stroke\":1,\"space\":\"object\"}\n"
      "{\"begin\":{\"radius\":0.2},\"fields\":[\"time\",\"x\",\"y\",\"z\"]}\n";
  for (int i = 0; i <= 60; ++i)  // along x to the origin, then along y
    text += fmt::format("[{},{},{},0]\n", i, std::min(0.03 * i - 0.9, 0.), std::max(0.03 * i - 0.9, 0.));
  const std::string stroke = folder.write("corner.stroke", text + "{\"end\":true}\n");
  const auto rows_of = [&](const std::string& join) {
    const std::string csv = folder.path(join + ".csv");
    burin_output({"chart", stroke, "--mesh", mesh, "--join", join, "--csv", csv});
    return read_csv(csv);
  };
  const auto farthest = [&](const std::vector<Row>& rows) {
    float out = 0;
    for (const Row& row : rows)
      out =
          std::max(out, (plane.positions[row.vertex].x() - plane.positions[row.vertex].y()) / std::sqrt(2.F));
    return out;
  };
  EXPECT_NEAR(farthest(rows_of("round")), 0.2, 0.03);
  EXPECT_NEAR(farthest(rows_of("smooth")), 0.2, 0.03);
  EXPECT_NEAR(farthest(rows_of("miter")), 0.2 * std::sqrt(2), 0.03);
  const auto sheets = [](const std::vector<Row>& rows) {
    return std::ranges::count_if(rows, [](const Row& row) { return row.sheet > 0; });
  };
  EXPECT_EQ(sheets(rows_of("miter")), 0);
  EXPECT_GT(sheets(rows_of("overlap")), 50);
  EXPECT_NE(burin({"chart", stroke, "--mesh", mesh, "--join", "bevel"}).exit_code, 0);
}

TEST(ChartCommand, NarrowsTheStrokeWithThePressure) {
  const auto expect_narrowing = [](const std::string& settings, const std::vector<std::string>& options) {
    Equator equator;
    std::string text = "{\"burin_stroke\":1,\"space\":\"object\"}\n{\"begin\":{\"radius\":0.2" + settings +
                       "},\"fields\":[\"time\",\"x\",\"y\",\"z\",\"pressure\"]}\n";
    for (int i = 0; i <= 60; ++i) {
      const double angle = 0.02 * i;
      text += fmt::format("[{},{},0,{},{}]\n", 0.01 * i, std::sin(angle), std::cos(angle), i / 60.);
    }
    equator.stroke = equator.folder.write("b.stroke", text + "{\"end\":true}\n");
    std::size_t wide = 0;
    for (const Row& row : equator.chart(options)) {
      const double half_width = 0.1 + 0.1 * std::clamp(row.t / 1.2, 0., 1.);
      EXPECT_LE(std::abs(row.d), half_width + 1e-3) << row.t;
      wide += std::abs(row.d) > 0.8 * half_width ? 1 : 0;
    }
    EXPECT_GT(wide, 50u);
  };
  expect_narrowing("", {"--pressure-width", "0.5"});
  expect_narrowing(R"(,"dynamics":[{"target":"radius","source":"pressure","curve":[0,0.5,1,1]}])", {});
}

// The picture ------------------------------------------------------------------------------------------

/// Writes a stroke as pixels in front of a camera that looks along -z at the sphere, which is about 400
/// pixels wide and high in a picture of 640 x 480.
Camera write_screen_stroke(const std::string& path,
                           const std::function<Vec3d(const Camera&, double share)>& place, int samples) {
  const Vec3d corner = Vec3d::Ones();
  const Camera camera = framing_camera(-corner, corner, -Vec3d::UnitZ(), Vec3d::UnitY(), 640, 480, 0.5);
  RecordedStroke stroke;
  stroke.settings[&StrokeSettings::radius] = 0.2;
  stroke.fields.time = true;
  StrokeWriter writer(path, StrokeSpace::screen, camera);
  writer.begin(stroke);
  for (int i = 0; i <= samples; ++i) {
    Sample sample;
    sample.time = 0.01 * i;
    sample.position = place(camera, static_cast<double>(i) / samples);
    writer.add(sample);
  }
  writer.end();
  return camera;
}

Camera write_screen_stroke(const std::string& path) {
  const auto along_equator = [](const Camera& camera, double share) {
    const double angle = -0.6 + 1.2 * share;
    const Eigen::Vector4d clip =
        camera.projection * camera.view * Eigen::Vector4d(std::sin(angle), 0, std::cos(angle), 1);
    return Vec3d((0.5 + 0.5 * clip.x() / clip.w()) * 640, 240, 0);
  };
  return write_screen_stroke(path, along_equator, 60);
}

double linear(int srgb) { return std::pow(srgb / 255.0, 2.2); }

/// Warm or cool, deep or pale.
std::pair<bool, bool> square_class(const Rgb& rgb) {
  const double r = linear(rgb[0]), g = linear(rgb[1]), b = linear(rgb[2]);
  return {r > b, g / std::max(r, b) < 0.55};
}

double to_square_border(double x) { return std::abs(x - std::round(x)); }

TEST(ChartCommand, DrawsACheckerboardThatAgreesWithTheTable) {
  Equator equator;
  equator.stroke = equator.folder.path("screen.stroke");
  const Camera camera = write_screen_stroke(equator.stroke);
  const std::vector<Row> rows = equator.chart({"--png", equator.folder.path("a.png")});
  const Picture picture = read_png(equator.folder.path("a.png"));
  ASSERT_EQ(picture.width, 640);
  std::map<std::pair<bool, bool>, int> seen;
  for (const Row& row : rows) {
    const double t = row.t * 4 / 0.2, d = row.d * 4 / 0.2;
    if (to_square_border(t) < 0.25 || to_square_border(d) < 0.25 || std::abs(d) > 3.5) continue;
    if (row.t < 0 || row.t > 1.2) continue;
    const Vec3d p = equator.mesh.positions[row.vertex].cast<double>();
    const Eigen::Vector4d clip = camera.projection * camera.view * p.homogeneous();
    const Rgb rgb = pixel(picture, static_cast<int>((0.5 + 0.5 * clip.x() / clip.w()) * 640),
                          static_cast<int>((0.5 - 0.5 * clip.y() / clip.w()) * 480));
    const bool odd = (static_cast<int>(std::floor(t)) + static_cast<int>(std::floor(d))) % 2 != 0;
    EXPECT_EQ(square_class(rgb), std::pair(row.d > 0, odd))
        << "vertex " << row.vertex << " t " << t << " d " << d;
    ++seen[{row.d > 0, odd}];
  }
  for (const bool left : {false, true}) {
    for (const bool odd : {false, true}) EXPECT_GT((seen[{left, odd}]), 5);
  }
}

TEST(ChartCommand, DrawsTheLatestSheetOnTop) {
  Equator equator;
  equator.stroke = equator.folder.path("screen.stroke");
  const auto eight = [](const Camera&, double share) {
    const double angle = 6 * share + 0.8;
    return Vec3d(320 + 120 * std::sin(angle), 240 + 80 * std::sin(2 * angle), 0);
  };
  const Camera camera = write_screen_stroke(equator.stroke, eight, 150);
  const std::vector<Row> rows = equator.chart({"--png", equator.folder.path("a.png")});
  const Picture picture = read_png(equator.folder.path("a.png"));
  int overlapped = 0;
  for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
    const Row& row = rows[i];
    const double t = row.t * 4 / 0.2, d = row.d * 4 / 0.2;
    if (rows[i + 1].vertex == row.vertex || std::abs(d) > 2.5) continue;
    if (to_square_border(t) < 0.25 || to_square_border(d) < 0.25) continue;
    const Eigen::Vector4d clip =
        camera.projection * camera.view * equator.mesh.positions[row.vertex].cast<double>().homogeneous();
    const Rgb rgb = pixel(picture, static_cast<int>((0.5 + 0.5 * clip.x() / clip.w()) * 640),
                          static_cast<int>((0.5 - 0.5 * clip.y() / clip.w()) * 480));
    const bool odd = (static_cast<int>(std::floor(t)) + static_cast<int>(std::floor(d))) % 2 != 0;
    EXPECT_EQ(square_class(rgb), std::pair(row.d > 0, odd)) << "t " << t << " d " << d;
    overlapped += row.sheet > 0 ? 1 : 0;
  }
  EXPECT_GT(overlapped, 10);
}

TEST(ChartCommand, DrawsTheCurve) {
  Equator equator;
  equator.stroke = equator.folder.path("screen.stroke");
  write_screen_stroke(equator.stroke);
  equator.chart({"--png", equator.folder.path("a.png")});
  const Picture picture = read_png(equator.folder.path("a.png"));
  for (const int column : {280, 320, 360}) {
    for (const int channel : {0, 1, 2}) {
      EXPECT_LT(pixel(picture, column, 240)[static_cast<std::size_t>(channel)], 40) << column;
    }
  }
  EXPECT_GT(pixel(picture, 320, 230)[0] + pixel(picture, 320, 230)[2], 200);
}

TEST(ChartCommand, LooksAtTheStroke) {
  Equator equator;
  equator.chart({"--png", equator.folder.path("a.png"), "--width", "300", "--height", "200"});
  const Picture picture = read_png(equator.folder.path("a.png"));
  ASSERT_EQ(picture.width, 300);
  ASSERT_EQ(picture.height, 200);
  const Rgb middle = pixel(picture, 150, 100);
  EXPECT_LT(middle[0] + middle[1] + middle[2], 120) << "the curve crosses the middle of the picture";
}

}  // namespace
}  // namespace burin::test
