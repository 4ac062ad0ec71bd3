// Creases of CAD models that Gmsh meshes, against the curves from which it made their edges.
#include <burin/stroke/stroke_file.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <numbers>
#include <sstream>

#include "host_stub/programs.h"
#include "host_stub/run_command.h"
#include "support/process.h"

namespace burin::test {
namespace {

constexpr double pi = std::numbers::pi;

/// A mesh of Gmsh's format 2: triangles, and the edges that it made of the model's curves.
struct CurveMesh {
  TriangleMesh mesh;
  std::vector<std::array<Index, 2>> curve_edges;
};

CurveMesh read_curve_mesh(const std::string& path) {
  std::ifstream in(path);
  CurveMesh result;
  std::map<int, Index> index_of;
  std::string line;
  std::size_t count = 0;
  while (std::getline(in, line)) {
    if (line == "$Nodes") {
      in >> count;
      for (std::size_t i = 0; i < count; ++i) {
        int id = 0;
        double x = 0, y = 0, z = 0;
        in >> id >> x >> y >> z;
        index_of[id] = static_cast<Index>(i);
        result.mesh.positions.push_back(Vec3d(x, y, z).cast<float>());
      }
    }
    if (line != "$Elements") continue;
    in >> count;
    for (std::size_t i = 0; i <= count && std::getline(in, line); ++i) {
      std::istringstream words(line);
      int id = 0, type = 0, tags = 0;
      words >> id >> type >> tags;
      std::vector<int> rest;
      for (int word = 0; words >> word;) rest.push_back(word);
      const auto node = [&](std::size_t k) { return index_of.at(rest[static_cast<std::size_t>(tags) + k]); };
      if (type == 1) result.curve_edges.push_back({node(0), node(1)});
      if (type == 2) result.mesh.triangles.push_back({node(0), node(1), node(2)});
    }
  }
  return result;
}

/// A model with a curve on it, of which a point is known.
struct CadModel {
  std::string name, geometry;                    ///< of Gmsh
  double edge;                                   ///< length that it asks for
  std::function<double(const Vec3d&)> distance;  ///< from the whole curve
  Vec3d beside;                                  ///< from the curve to the middle of the stroke
  std::vector<Vec3d> corners;                    ///< sharp ones of the curve
};

void PrintTo(const CadModel& model, std::ostream* out) { *out << model.name; }

/// The vertices of the curve, one after the other, from an end or, of closed curves, from any one on.
std::vector<Vec3d> chain(const CurveMesh& cad, const CadModel& model) {
  std::map<Index, std::vector<Index>> next;
  for (const auto& [a, b] : cad.curve_edges) {
    // Gmsh's splines of a helix are up to a third of an edge beside it.
    const bool on_curve = std::ranges::all_of(std::array{a, b}, [&](Index vertex) {
      return model.distance(cad.mesh.positions[vertex].cast<double>()) < 0.4 * model.edge;
    });
    if (!on_curve) continue;
    next[a].push_back(b);
    next[b].push_back(a);
  }
  if (next.empty()) return {};
  const auto end = std::ranges::find_if(next, [](const auto& entry) { return entry.second.size() == 1; });
  Index at = end == next.end() ? next.begin()->first : end->first, before = no_index;
  std::vector<Vec3d> points;
  while (at != no_index && points.size() < next.size()) {
    points.push_back(cad.mesh.positions[at].cast<double>());
    const auto& around = next[at];
    const auto onward = std::ranges::find_if(around, [&](Index vertex) { return vertex != before; });
    before = at;
    at = onward == around.end() ? no_index : *onward;
  }
  return points;
}

double distance_from(const std::vector<Vec3d>& polyline, const Vec3d& x) {
  double least = 1e9;
  for (std::size_t i = 1; i < polyline.size(); ++i) {
    const Vec3d& from = polyline[i - 1];
    const Vec3d way = polyline[i] - from;
    const double share = std::clamp((x - from).dot(way) / way.squaredNorm(), 0., 1.);
    least = std::min(least, (x - from - share * way).norm());
  }
  return least;
}

double quantile(std::vector<double> values, double share) {
  std::ranges::sort(values);
  return values.at(static_cast<std::size_t>(share * static_cast<double>(values.size() - 1)));
}

class CadCurves : public ::testing::TestWithParam<CadModel> {};

/// Meshes a geometry of Gmsh.
CurveMesh meshed(CommandFolder& folder, const std::string& geometry) {
  const std::string msh = folder.path("a.msh");
  const ProcessResult made =
      run_process({"gmsh", "-2", "-format", "msh2", "-o", msh, folder.write("a.geo", geometry), "-v", "2"});
  EXPECT_EQ(made.exit_code, 0) << made.out << made.err;
  return read_curve_mesh(msh);
}

TEST_P(CadCurves, AreFoundExactly) {
  if (!is_installed("gmsh")) GTEST_SKIP() << not_installed("gmsh");
  const CadModel& model = GetParam();
  CommandFolder folder;
  const CurveMesh cad = meshed(folder, model.geometry);
  const std::vector<Vec3d> curve = chain(cad, model);
  ASSERT_GT(curve.size(), 45u);

  std::string text = fmt::format(
      "{{\"burin_stroke\":1,\"space\":\"object\"}}\n{{\"begin\":{{\"radius\":{}}},\"fields\":[\"x\",\"y\","
      "\"z\"]}}\n",
      10 * model.edge);
  for (std::size_t i = 0; i < curve.size(); i += 2) {
    const Vec3d at = curve[i] + (1 + 0.5 * std::sin(static_cast<double>(i) / 4)) * model.beside;
    text += fmt::format("[{},{},{}]\n", at.x(), at.y(), at.z());
  }
  const std::string out = folder.path("out.stroke");
  // Warns of the points from which Gmsh made splines.
  const ProcessResult snapped =
      burin({"snap", folder.write("a.stroke", text + "{\"end\":true}\n"), "--mesh",
             folder.write("a.obj", obj_text(cad.mesh)), "--feature", "crease", "--out", out, "--json"});
  ASSERT_EQ(snapped.exit_code, 0) << snapped.err;
  const auto report = nlohmann::json::parse(snapped.out);
  ASSERT_EQ(report["strokes"].size(), 1u) << report.dump();
  EXPECT_GT(report["strokes"][0]["snapped_share"], 0.95) << report.dump();
  std::vector<double> from_edges, from_curve;
  const auto samples = read_strokes(out).strokes[0].samples;
  for (const Sample& sample : samples) {
    from_edges.push_back(distance_from(curve, sample.position) / model.edge);
    from_curve.push_back(model.distance(sample.position) / model.edge);
  }
  std::cout << model.name << ": " << samples.size() << " points, p95 from Gmsh's edges "
            << quantile(from_edges, 0.95) << ", median from the curve " << quantile(from_curve, 0.5)
            << " edges\n";
  EXPECT_LT(quantile(from_edges, 0.95), 0.001);
  EXPECT_LT(quantile(from_curve, 0.5), 0.1);
  for (const Vec3d& corner : model.corners)
    EXPECT_TRUE(std::ranges::any_of(
        samples, [&](const Sample& sample) { return (sample.position - corner).norm() < 1e-4; }))
        << "the corner " << corner.transpose();
}

TEST(CadFillet, IsARidgeAlongItsMiddle) {
  if (!is_installed("gmsh")) GTEST_SKIP() << not_installed("gmsh");
  // A quarter of a cylinder of radius 0.4 about x = 1.6, z = 0.4 between two planes. A stroke along it swings
  // between 6 and 18 degrees beside its middle.
  constexpr double edge = 0.06, radius = 0.4;
  CommandFolder folder;
  const CurveMesh cad = meshed(folder,
                               "SetFactory(\"OpenCASCADE\");\nBox(1) = {0, 0, 0, 2, 5, 2};\n"
                               "Fillet{1}{8}{0.4}\nMeshSize{:} = 0.06;\n");
  std::string text =
      "{\"burin_stroke\":1,\"space\":\"object\"}\n{\"begin\":{\"radius\":0.9},\"fields\":[\"x\",\"y\","
      "\"z\"]}\n";
  for (int i = 0; i <= 40; ++i) {
    const double angle = (57 + 6 * std::sin(i / 3.)) * pi / 180;
    text += fmt::format("[{},{},{}]\n", 1.6 + radius * std::sin(angle), 1.2 + 2.6 * i / 40,
                        radius - radius * std::cos(angle));
  }
  const std::string out = folder.path("out.stroke");
  const auto report = burin_json({"snap", folder.write("a.stroke", text + "{\"end\":true}\n"), "--mesh",
                                  folder.write("a.obj", obj_text(cad.mesh)), "--feature", "ridge", "--scale",
                                  "0.2", "--out", out});
  EXPECT_GT(report["strokes"][0]["snapped_share"], 0.95) << report.dump();
  std::vector<double> errors;
  const std::vector<Sample> samples = read_strokes(out).strokes[0].samples;
  for (const Sample& sample : samples) {
    const double angle = std::atan2(sample.position.x() - 1.6, radius - sample.position.z());
    errors.push_back(std::abs(angle - pi / 4) * radius / edge);
  }
  std::cout << "median " << quantile(errors, 0.5) << ", p95 " << quantile(errors, 0.95) << " edges\n";
  EXPECT_LT(quantile(errors, 0.5), 0.1);
  EXPECT_LT(quantile(errors, 0.95), 0.25);
}

/// The rim of a box whose lower right edge has a fillet, in the plane y = 0.
double from_rim(const Vec3d& x) {
  const auto segment = [&](double x0, double z0, double x1, double z1) {
    const Vec3d from(x0, 0, z0), way = Vec3d(x1, 0, z1) - from;
    return (x - from - std::clamp((x - from).dot(way) / way.squaredNorm(), 0., 1.) * way).norm();
  };
  const bool by_arc = x.x() > 1.6 && x.z() < 0.4;
  const double arc = std::hypot(std::hypot(x.x() - 1.6, x.z() - 0.4) - 0.4, x.y());
  return std::min({segment(0, 0, 1.6, 0), segment(2, 0.4, 2, 1), segment(2, 1, 0, 1), segment(0, 1, 0, 0),
                   by_arc ? arc : 10.});
}

/// The curve where a cylinder of radius 0.6 about x leaves one of radius 1 about z.
double from_both_cylinders(const Vec3d& x) {
  double least = 10;
  for (int i = 0; i <= 4000; ++i) {
    const double angle = 2 * pi * i / 4000, y = 0.6 * std::cos(angle);
    least = std::min(least, (Vec3d(std::sqrt(1 - y * y), y, 0.6 * std::sin(angle)) - x).norm());
  }
  return least;
}

/// The crest of a thread: a helix of radius 1 that rises by 0.1 in a third of a turn.
double from_helix(const Vec3d& x) {
  double least = 10;
  for (int i = 0; i <= 4000; ++i) {
    const double angle = 4 * pi / 3 * i / 4000;
    least = std::min(least,
                     (Vec3d(std::cos(angle), std::sin(angle), 0.15 + 0.1 * angle / (2 * pi / 3)) - x).norm());
  }
  return least;
}

INSTANTIATE_TEST_SUITE_P(
    Models, CadCurves,
    ::testing::Values(
        CadModel{"fillet",
                 "SetFactory(\"OpenCASCADE\");\nBox(1) = {0, 0, 0, 2, 1.5, 1};\nFillet{1}{8}{0.4}\n"
                 "MeshSize{:} = 0.06;\n",
                 0.06,
                 from_rim,
                 {0, 0.1, 0},
                 {{0, 0, 1}, {2, 0, 1}}},
        CadModel{"pipes",
                 "SetFactory(\"OpenCASCADE\");\nCylinder(1) = {0, 0, -1.5, 0, 0, 3, 1};\n"
                 "Cylinder(2) = {0, 0, 0, 2, 0, 0, 0.6};\n"
                 "BooleanUnion(3) = { Volume{1}; Delete; }{ Volume{2}; Delete; };\nMeshSize{:} = 0.08;\n",
                 0.08,
                 from_both_cylinders,
                 {0.15, 0, 0},
                 {}},
        CadModel{"thread",
                 "Point(1) = {0.8, 0, 0, 0.04};\nPoint(2) = {1, 0, 0.15, 0.04};\n"
                 "Point(3) = {0.8, 0, 0.3, 0.04};\nLine(1) = {1, 2};\nLine(2) = {2, 3};\n"
                 "a[] = Extrude { {0, 0, 0.1}, {0, 0, 1}, {0, 0, 0}, 2*Pi/3 } { Line{1, 2}; };\n"
                 "b[] = Extrude { {0, 0, 0.1}, {0, 0, 1}, {0, 0, 0}, 2*Pi/3 } { Line{a[0], a[4]}; };\n",
                 0.04,
                 from_helix,
                 {0, 0, 0.05},
                 {}}),
    [](const auto& model) { return model.param.name; });

}  // namespace
}  // namespace burin::test
