// Tests strokes that overlap themselves, with real brushes.
#include <algorithm>
#include <array>
#include <map>
#include <numbers>

#include "host/one_go.h"

namespace burin {
namespace {

using test::add;
using test::draw;

constexpr Overlap all_modes[] = {Overlap::latest, Overlap::max,     Overlap::min,
                                 Overlap::add,    Overlap::average, Overlap::strongest};
constexpr Overlap without_order[] = {Overlap::max, Overlap::min, Overlap::add, Overlap::average,
                                     Overlap::strongest};

std::vector<Sample> samples_at(const std::vector<Vec3d>& places) {
  std::vector<Sample> samples;
  for (const Vec3d& place : places) {
    Sample sample;
    sample.time = 0.01 * static_cast<double>(samples.size());
    sample.position = place;
    sample.pen.pressure = static_cast<float>(0.5 + 0.4 * std::sin(0.1 * static_cast<double>(samples.size())));
    samples.push_back(sample);
  }
  return samples;
}

constexpr double star_reach = 0.6, star_step = std::numbers::pi / 5;

Vec3d direction(double angle) { return {std::cos(angle), std::sin(angle), 0}; }

/// Five straight lines through the origin, a fifth of a half turn from each to the next, joined outside
/// `star_reach` by the arcs that touch both.
std::vector<Vec3d> star() {
  std::vector<Vec3d> places;
  const double size = star_reach * std::tan(star_step / 2);
  for (int line = 0; line < 5; ++line) {
    const double sense = line % 2 == 0 ? 1 : -1, angle = line * star_step;
    for (int i = -20; i <= 20; ++i) places.push_back(sense * i / 20. * star_reach * direction(angle));
    if (line == 4) break;
    const Vec3d centre = sense * star_reach / std::cos(star_step / 2) * direction(angle + star_step / 2);
    const double from = angle - std::numbers::pi / 2, turn = std::numbers::pi + star_step;
    for (int i = 1; i < 30; ++i) places.push_back(centre + sense * size * direction(from + turn * i / 30));
  }
  return places;
}

/// Twice around the origin and through it.
std::vector<Vec3d> figure_eight() {
  std::vector<Vec3d> places;
  for (int i = 0; i <= 150; ++i) {
    const double angle = 2 * std::numbers::pi * i / 150 + 0.8;
    places.emplace_back(0.6 * std::sin(angle), 0.4 * std::sin(2 * angle), 0);
  }
  return places;
}

std::vector<Vec3d> spiral() {
  std::vector<Vec3d> places;
  for (int i = 0; i <= 300; ++i) {
    const double turns = 4. * i / 300;
    places.push_back((0.3 + 0.1 * turns) * direction(2 * std::numbers::pi * turns));
  }
  return places;
}

/// Five times along a line.
std::vector<Vec3d> to_and_fro() {
  std::vector<Vec3d> places;
  for (int i = 0; i <= 100; ++i) {
    const double way = i % 40 / 20.;
    places.emplace_back(way <= 1 ? way - 0.5 : 1.5 - way, 0.3, 0);
  }
  return places;
}

StrokeSettings ridge(double radius, Overlap overlap) {
  StrokeSettings ridge = test::settings("org.burin.groove", radius);
  ridge.params = {{"depth", -1.0}, {"taper", 0.0}};
  ridge.overlap = overlap;
  return ridge;
}

/// The effect of one line of the star on a point.
struct LineSheet {
  double height, weight;
};

/// The sheets of a point, in the order in which the lines were drawn.
std::vector<LineSheet> star_sheets(const Vec3f& place, double radius) {
  std::vector<LineSheet> sheets;
  for (int line = 0; line < 5; ++line) {
    const Vec3d along = direction(line * star_step);
    const double x = std::abs(along.x() * place.y() - along.y() * place.x()) / radius;
    const double s = std::min((1 - x) / 0.75, 1.0);
    if (x <= 1) sheets.push_back({radius * (1 - x * x) * (1 - x * x), s * s * (3 - 2 * s)});
  }
  return sheets;
}

/// The height of stacked sheets, the first of which is on top.
double stacked(const std::vector<LineSheet>& sheets) {
  double height = 0, covered = 0;
  for (const LineSheet& sheet : sheets) {
    height += (1 - covered) * sheet.weight * sheet.height;
    covered += (1 - covered) * sheet.weight;
  }
  return height / covered;
}

double blended(std::vector<LineSheet> sheets, Overlap overlap) {
  if (sheets.empty()) return 0;
  double sum = 0, weighed = 0, weights = 0, highest = 0;
  for (const LineSheet& sheet : sheets) {
    sum += sheet.height;
    weighed += sheet.weight * sheet.height;
    weights += sheet.weight;
    highest = std::max(highest, sheet.height);
  }
  if (overlap == Overlap::add) return sum;
  if (overlap == Overlap::average) return weighed / weights;
  if (overlap == Overlap::strongest) return highest;
  std::ranges::reverse(sheets);
  if (overlap == Overlap::max) std::ranges::sort(sheets, std::ranges::greater{}, &LineSheet::height);
  if (overlap == Overlap::min) std::ranges::sort(sheets, {}, &LineSheet::height);
  return stacked(sheets);
}

/// Whether a place is at a rim of one of the star's lines, where a node may or may not be.
bool at_a_rim(const Vec3f& place, double radius) {
  for (int line = 0; line < 5; ++line) {
    const Vec3d along = direction(line * star_step);
    const double d = std::abs(along.x() * place.y() - along.y() * place.x());
    if (std::abs(d - radius) < 1e-4 * radius) return true;
  }
  return false;
}

TEST(SelfOverlap, BlendsFiveSheetsByTheClosedForm) {
  constexpr double radius = 0.1;
  for (const Overlap overlap : all_modes) {
    SCOPED_TRACE(static_cast<int>(overlap));
    Session session = test::plane_session();
    const Surface base = session.surface();
    draw(session, ridge(radius, overlap), samples_at(star()));
    std::map<std::size_t, int> seen;
    double worst = 0;
    for (Index vertex = 0; vertex < base.vertex_count(); ++vertex) {
      const Vec3f& place = base.positions[vertex];
      if (place.norm() > 0.4f || at_a_rim(place, radius)) continue;
      const std::vector<LineSheet> sheets = star_sheets(place, radius);
      ++seen[sheets.size()];
      worst = std::max(worst, std::abs(session.positions()[vertex].z() - blended(sheets, overlap)));
    }
    EXPECT_LT(worst, 2e-5 * radius);
    for (std::size_t sheets = 0; sheets <= 5; ++sheets) EXPECT_GT(seen[sheets], 10) << sheets;
  }
}

TEST(SelfOverlap, DoesNotSeeTheDirectionOfTheStroke) {
  constexpr double radius = 0.15;
  std::vector<Vec3d> backward = star();
  std::ranges::reverse(backward);
  for (const Overlap overlap : without_order) {
    SCOPED_TRACE(static_cast<int>(overlap));
    Session one = test::plane_session(), other = test::plane_session();
    draw(one, ridge(radius, overlap), samples_at(star()));
    draw(other, ridge(radius, overlap), samples_at(backward));
    double worst = 0;
    // Only the region where lines overlap is compared; farther out the points on the arcs differ.
    for (Index vertex = 0; vertex < one.surface().vertex_count(); ++vertex) {
      if (one.surface().positions[vertex].head<2>().norm() > 0.3f) continue;
      const Vec3f &a = one.positions()[vertex], &b = other.positions()[vertex];
      worst = std::max(worst, static_cast<double>((a - b).norm()));
    }
    EXPECT_LE(worst, 1e-6 * radius);
  }
}

TEST(SelfOverlap, GrowsToWhatOneEvaluationGives) {
  const std::array shapes{star(), figure_eight(), spiral(), to_and_fro()};
  for (std::size_t mode = 0; mode < std::size(all_modes); ++mode) {
    const Overlap overlap = all_modes[mode];
    // Two of the shapes with each mode.
    for (std::size_t i = 0; i < 2; ++i) {
      const std::vector<Vec3d>& places = shapes[(mode + 2 * i) % shapes.size()];
      Session session = test::plane_session();
      const Surface base = session.surface();
      const StrokeSettings settings = test::every_input(overlap);
      draw(session, settings, samples_at(places));
      ASSERT_GT(std::ranges::max(session.chart().sheet), 0u);
      ASSERT_TRUE(session.surface().positions == test::in_one_go(base, session.curve(), settings));
    }
  }
}

TEST(SelfOverlap, IsUndoneBitForBit) {
  Session session = test::plane_session();
  const test::Snapshot before(session);
  draw(session, ridge(0.15, Overlap::add), samples_at(star()));
  EXPECT_FALSE(test::Snapshot(session) == before);
  EXPECT_TRUE(session.undo());
  EXPECT_TRUE(test::Snapshot(session) == before);
  session.begin_stroke(ridge(0.15, Overlap::average));
  add(session, samples_at(star()));
  session.cancel_stroke();
  EXPECT_TRUE(test::Snapshot(session) == before);
}

/// The number of sheets of the chart at the vertex nearest to a place.
std::size_t sheets_at(const Session& session, const Vec3f& place) {
  Index nearest = 0;
  const auto distance = [&](Index vertex) {
    return (session.surface().positions[vertex] - place).head<2>().norm();
  };
  for (Index vertex = 1; vertex < session.surface().vertex_count(); ++vertex)
    if (distance(vertex) < distance(nearest)) nearest = vertex;
  return static_cast<std::size_t>(std::ranges::count(session.chart().vertex, nearest));
}

TEST(SelfOverlap, HasASheetForEveryVisit) {
  struct Case {
    std::vector<Vec3d> places;
    std::map<std::size_t, std::vector<Vec3f>> expected;  ///< by the number of sheets
  };
  const Case cases[] = {
      {star(), {{5, {{0, 0, 0}}}, {1, {{0.5f, 0, 0}}}, {0, {{0, 0.97f, 0}}}}},
      {figure_eight(), {{2, {{0, 0, 0}, {0.02f, 0.03f, 0}}}, {1, {{0.6f, 0, 0}}}}},
      {spiral(),
       {{3, {{0.5f, 0, 0}, {0.4f, 0, 0}}}, {2, {{0, 0.475f, 0}, {0, -0.425f, 0}}}, {0, {{0, 0, 0}}}}},
      {to_and_fro(), {{5, {{0, 0.3f, 0}, {0.1f, 0.35f, 0}}}, {0, {{0, 0, 0}}}}},
  };
  for (const auto& [places, expected] : cases) {
    for (const Overlap overlap : all_modes) {
      Session session = test::plane_session();
      const double radius = places.size() == 301 ? 0.11 : 0.15;
      draw(session, ridge(radius, overlap), samples_at(places));
      for (const Vec3f& position : session.positions()) ASSERT_TRUE(position.allFinite());
      for (const auto& [count, where] : expected)
        for (const Vec3f& place : where) EXPECT_EQ(sheets_at(session, place), count) << place.transpose();
    }
  }
}

// Every visit has a plane of its own. If the highest rise and the deepest cut of all were taken, hollows
// would be raised to the highest plane and bumps sunk to the lowest.
TEST(Flatten, LevelsWhatItScrubs) {
  TriangleMesh mesh = test::plane(1, 0.02, 4);
  for (Vec3f& p : mesh.positions) p.z() = 0.02F * std::sin(32 * p.x() + 3) * std::sin(32 * p.y() + 1);
  Session session(make_surface(mesh), test::brushes());
  const std::vector<Vec3f> relief = session.surface().positions;
  session.begin_stroke(test::settings("org.burin.flatten", 0.2));
  for (int i = 0; i < 400; ++i)
    session.add_sample({-0.6 + 0.003 * i, 0.35 * std::sin(0.25 * i), 0}, 0.01 * i, {}, Show::later);
  session.end_stroke();
  double before = 0, after = 0;
  for (Index v = 0; v < session.surface().vertex_count(); ++v) {
    if (std::abs(relief[v].x()) > 0.4F || std::abs(relief[v].y()) > 0.3F) continue;
    before += relief[v].z() * relief[v].z();
    after += session.positions()[v].z() * session.positions()[v].z();
  }
  std::cout << "RMS height left: " << std::sqrt(after / before) << '\n';
  EXPECT_LT(std::sqrt(after / before), 0.1);
}

}  // namespace
}  // namespace burin
