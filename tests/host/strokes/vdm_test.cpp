#include <burin/stamp/float_image.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "host/sessions.h"
#include "support/shared_data.h"

namespace burin {
namespace {

using std::numbers::pi;

/// The points of a vector displacement map, in halves of the stamp's width: x to the right, y up, z outward.
/// They form a tube along x that overhangs its foot on both sides; its points are also moved along it.
struct Tube {
  static constexpr double radius = 0.3, height = 0.5;
  static constexpr double half_foot = 0.8;   // |y| from which on the map is 0
  static constexpr double half_sheet = 0.6;  // |y| up to which the sheet is on the tube

  static Vec3d place(double x, double y) {
    const double s = std::clamp((std::abs(y) - half_sheet) / (half_foot - half_sheet), 0.0, 1.0);
    const double blend = 1 - s * s * s * (s * (6 * s - 15) + 10);
    const double angle = 0.8 * pi * y / half_sheet;
    const Vec3d on_tube(x + 0.2 * std::sin(pi * x), radius * std::sin(angle),
                        height + radius * std::cos(angle));
    return Vec3d(x, y, 0) + blend * (on_tube - Vec3d(x, y, 0));
  }
};

void write_map(const std::filesystem::path& path, int size) {
  FloatImage image{size, size, {"R", "G", "B"}, {}};
  for (int row = 0; row < size; ++row)
    for (int column = 0; column < size; ++column) {
      const double x = 2 * (column + 0.5) / size - 1, y = 1 - 2 * (row + 0.5) / size;
      const Vec3d moved = Tube::place(x, y) - Vec3d(x, y, 0);
      for (const double component : moved) image.texels.push_back(static_cast<float>(component));
    }
  write_exr(path, image);
}

/// A surface that unrolls into the plane: places and frames by plane coordinates.
struct Developable {
  Vec3d (*position)(double x, double y);
  Vec3d (*right)(double x);  // unit vectors along x and along y
  Vec3d up;
  TriangleMesh mesh;
  double (*x)(const Vec3d& position);
  double (*y)(const Vec3d& position);
};

Developable flat() {
  return {[](double x, double y) -> Vec3d {
            return {x, y, 0};
          },
          [](double) -> Vec3d { return Vec3d::UnitX(); },
          Vec3d::UnitY(),
          test::plane(0.8, 0.006, 3),
          [](const Vec3d& p) { return p.x(); },
          [](const Vec3d& p) { return p.y(); }};
}

Developable rolled() {
  return {[](double x, double y) -> Vec3d {
            return {std::cos(x), std::sin(x), y};
          },
          [](double x) -> Vec3d {
            return {-std::sin(x), std::cos(x), 0};
          },
          Vec3d::UnitZ(),
          test::cylinder(1, 0.8, 0.006, 0.3, 3),
          [](const Vec3d& p) { return std::atan2(p.y(), p.x()); },
          [](const Vec3d& p) { return p.z(); }};
}

constexpr double bend = 0.5;  // radius of the stroke, a circle run through counter-clockwise: left is inward
constexpr double stroke_radius = 0.2;

/// The point of the tube along the stroke that belongs to a point of the unrolled surface.
Vec3d on_tube(const Developable& surface, double x, double y) {
  const double from_middle = std::hypot(x, y), angle = std::atan2(y, x) + pi;  // drawn from -pi on
  const double t = bend * angle, d = bend - from_middle;
  const double column = std::round(t / (2 * stroke_radius));  // stamps stand around 0, 0.4, 0.8...
  const Vec3d stamp((t - column * 2 * stroke_radius) / stroke_radius, d / stroke_radius, 0);
  const Vec3d moved = stroke_radius * (Tube::place(stamp.x(), stamp.y()) - stamp);
  const Vec3d right = surface.right(x), normal = right.cross(surface.up);
  const Vec3d e1 = (-y * right + x * surface.up) / from_middle, e2 = normal.cross(e1);
  return surface.position(x, y) + moved.x() * e1 + moved.y() * e2 + moved.z() * normal;
}

Session drawn(const Developable& surface, const std::filesystem::path& map, double follow) {
  Session session(make_surface(test::shuffled(surface.mesh, 4)), test::brushes());
  StrokeSettings trail = test::settings("org.burin.vdm-trail", stroke_radius);
  trail.params["stamp"] = map.string();
  trail.follow = follow;
  session.begin_stroke(trail);
  for (int i = 0; i < 600; ++i) {
    const double angle = -pi + 1.7 * pi * i / 599;
    session.add_sample(surface.position(bend * std::cos(angle), bend * std::sin(angle)), 0.01 * i, {},
                       Show::later);
  }
  session.end_stroke();
  return session;
}

/// Distances from where the analytic tube has a vertex, over the tube's radius.
struct TubeError {
  double greatest = 0, rms = 0;
  int vertices = 0, underside = 0;
};

TubeError tube_error(const Developable& surface, const std::filesystem::path& map, double follow,
                     double around_begin) {
  const Session session = drawn(surface, map, follow);
  const Surface base = make_surface(test::shuffled(surface.mesh, 4));
  const double last = 2 * stroke_radius * std::floor(session.curve().length() / (2 * stroke_radius));
  TubeError error;
  for (Index node = 0; node < session.chart().size(); ++node) {
    const double t = session.chart().t[node], y = std::abs(session.chart().d[node]) / stroke_radius;
    // Points around the caps, and where the sheet leaves the tube, are skipped.
    if (t < around_begin || t > last || y > Tube::half_sheet) continue;
    const Vec3d at = base.positions[session.chart().vertex[node]].cast<double>();
    const Vec3d expected = on_tube(surface, surface.x(at), surface.y(at));
    const Vec3d found = session.positions()[session.chart().vertex[node]].cast<double>();
    const double off = (found - expected).norm() / (Tube::radius * stroke_radius);
    error.greatest = std::max(error.greatest, off);
    error.rms += off * off;
    ++error.vertices;
    error.underside += y > Tube::half_sheet / 1.6;
  }
  error.rms = std::sqrt(error.rms / error.vertices);
  return error;
}

class VdmTube : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(All, VdmTube, testing::Bool(),
                         [](const auto& test) { return test.param ? "Cylinder" : "Plane"; });

void expect_on_tube(const Developable& surface, double follow, double around_begin) {
  const test::TemporaryFolder folder;
  double coarser = 1;
  for (const int size : {32, 64, 128}) {
    SCOPED_TRACE(size);
    const auto map = folder.path() / (std::to_string(size) + ".exr");
    write_map(map, size);
    const TubeError error = tube_error(surface, map, follow, around_begin);
    std::cout << size << " texels: rms " << 100 * error.rms << " %, max " << 100 * error.greatest << " % of "
              << error.vertices << " vertices\n";
    EXPECT_GT(error.vertices, 6000);
    EXPECT_GT(error.underside, 1000) << "some hang over";
    EXPECT_LT(error.rms, coarser);
    coarser = error.rms;
    if (size >= 64) {
      EXPECT_LE(error.rms, 0.005);
    }
    if (size >= 128) {
      EXPECT_LE(error.greatest, 0.005);
    }
  }
}

TEST_P(VdmTube, IsWhereTheAnalyticTubeIs) { expect_on_tube(GetParam() ? rolled() : flat(), 1, 0.05); }

// The cap's straight lines, which do not bend as the stroke does, are felt within five nodes of the base
// surface.
TEST_P(VdmTube, IsThereAtTheBrushsOwnScale) { expect_on_tube(GetParam() ? rolled() : flat(), 0, 0.07); }

}  // namespace
}  // namespace burin
