// Strokes over what finer strokes refined, drawn through sessions: what they take out of it, what they keep,
// and that undo brings it back.
#include <burin/host/replay.h>
#include <burin/surface/topology/euler.h>

#include <algorithm>
#include <limits>
#include <set>
#include <tuple>

#include "refining.h"

namespace burin::test {
namespace {

constexpr double narrow_radius = radius / 4;

StrokeSettings stroke_of(double wide, double strength) {
  StrokeSettings made = refining_if_coarse();
  made.radius = wide;
  made.strength = strength;
  return made;
}

const std::vector<Vec3d> along = straight({-0.4, 0, 0}, {0.4, 0.02, 0}),
                         beside = straight({-0.4, 0.4, 0}, {0.4, 0.42, 0});

Session coarse_session() { return Session(make_surface(shuffled(plane(1, 0.1, 7), 8)), brushes()); }

using Place = std::tuple<float, float, float>;

/// Positions and the triangles between them where y is more than this, whatever their order.
std::set<std::set<Place>> triangles_beyond(const Session& session, float y) {
  std::set<std::set<Place>> found;
  for (const Triangle& t : session.surface().triangles) {
    std::set<Place> places;
    bool is_beyond = true;
    for (const Index v : t) {
      const Vec3f& p = session.positions()[v];
      is_beyond &= p.y() > y;
      places.emplace(p.x(), p.y(), p.z());
    }
    if (is_beyond) found.insert(places);
  }
  return found;
}

TEST(CoarsenPath, TakesOutWhatAWiderStrokeDoesNotNeed) {
  Session session = coarse_session(), wide_only = coarse_session();
  draw_along(session, stroke_of(narrow_radius, 0), along);
  draw_along(session, stroke_of(narrow_radius, 1), beside);
  const std::size_t fine = session.surface().triangles.size();
  constexpr float between = 0.36F;
  const auto relief = triangles_beyond(session, between);
  draw_along(session, stroke_of(radius, 1), along);
  draw_along(wide_only, stroke_of(radius, 1), along);
  ASSERT_EQ(session.refinements().size(), 3u);
  const RefineReport& report = session.refinements().back();
  EXPECT_EQ(report.edge, radius / Refining::fine);
  EXPECT_GT(report.vertices_removed, 1000u);
  EXPECT_EQ(session.surface().triangles.size(), fine + report.triangles_added - report.triangles_removed);
  EXPECT_TRUE(triangles_beyond(session, between) == relief);
  EXPECT_GT(relief.size(), 4000u);
  const auto count = [](const Session& of) {
    return std::ranges::count_if(of.surface().positions, [](const Vec3f& p) {
      return std::abs(p.x()) < 0.3F && std::abs(p.y()) < 0.1F;
    });
  };
  EXPECT_LT(static_cast<double>(count(session)), 1.3 * static_cast<double>(count(wide_only)));
  EXPECT_EQ(euler_characteristic(session.surface()), 1);
  EXPECT_EQ(session.changed().size(), session.surface().vertex_count());
}

// With a length of edges or an error given, a stroke splits what it stretched itself, whatever was there.
TEST(CoarsenPath, ChangesNoTriangleTheSecondTime) {
  using Kind = Refining::Kind;
  for (const auto& [kind, strength] :
       {std::pair{Kind::automatic, 0.}, {Kind::automatic, 1.}, {Kind::edge, 0.}, {Kind::error, 0.}}) {
    SCOPED_TRACE(testing::Message() << static_cast<int>(kind) << ' ' << strength);
    Session session = coarse_session();
    draw_along(session, stroke_of(narrow_radius, 1), along);
    StrokeSettings wide = stroke_of(radius, strength);
    wide.refining = {.kind = kind, .edge = radius / 16, .error = 0.02};
    draw_along(session, wide, along);
    ASSERT_EQ(session.refinements().size(), 2u);
    EXPECT_GT(session.refinements()[1].vertices_removed, 100u);
    const std::vector<Triangle> triangles = session.surface().triangles;
    draw_along(session, wide, along);
    EXPECT_EQ(session.refinements().size(), 2u);
    EXPECT_TRUE(session.surface().triangles == triangles);
  }
}

TEST(CoarsenPath, IsUndoneAndMadeAgainWithItsStroke) {
  Session session = coarse_session();
  const Index count = session.surface().vertex_count();
  session.set_paint({std::vector<Vec4f>(count, Vec4f(0.1F, 0.2F, 0.3F, 1)), {}});
  draw_along(session, stroke_of(narrow_radius, 1), along);
  const Everything fine(session);
  const StrokeSettings wide = stroke_of(radius, 1);
  draw_along(session, wide, along);
  const Everything coarse(session);
  EXPECT_LT(coarse.triangles.size(), fine.triangles.size());
  EXPECT_EQ(session.undo_count(), 2u);
  ASSERT_TRUE(session.undo());
  EXPECT_EQ(Everything(session), fine);
  EXPECT_EQ(session.refinements().size(), 1u);
  EXPECT_GE(session.kept_vertices(), count);
  EXPECT_LT(session.kept_vertices(), count + 100);
  ASSERT_TRUE(session.redo());
  EXPECT_EQ(Everything(session), coarse);
  ASSERT_TRUE(session.undo());
  draw_along(session, wide, along);
  EXPECT_EQ(Everything(session), coarse) << "drawn anew, as what was looked at is undone too";
  ASSERT_TRUE(session.undo() && session.undo());
  EXPECT_EQ(session.surface().vertex_count(), count);
}

/// A grid of steps, which no triangle can do without.
Session session_with_steps() {
  Session session = coarse_session();
  StrokeSettings dashes = stroke_of(narrow_radius, 2);
  dashes.brush = "org.burin.dashed-line";
  draw_along(session, dashes, along);
  return session;
}

/// The greatest distance of vertices that one session has near the line from the surface of another one.
double farthest(const Session& from, const Session& to) {
  double most = 0;
  for (const Vec3f& p : from.positions())
    most =
        std::max(most, static_cast<double>(
                           (to.picker().closest(p, std::numeric_limits<float>::max())->position - p).norm()));
  return most;
}

TEST(CoarsenPath, LosesNoReliefThatOtherStrokesDrew) {
  Session session = session_with_steps(), fine = session_with_steps();
  const std::size_t before = session.surface().triangles.size();
  draw_along(session, stroke_of(radius, 0), along);
  EXPECT_LT(session.surface().triangles.size(), before);
  EXPECT_LE(farthest(fine, session), 0.0101 * radius / Refining::fine);
  // Strokes of ever the same radius do not wear it off either.
  const std::vector<Triangle> left = session.surface().triangles;
  for (int i = 0; i < 3; ++i)
    draw_along(session, stroke_of(radius, 0), straight({-0.4, -0.01, 0}, {0.4, 0, 0}));
  EXPECT_LE(farthest(fine, session), 0.0101 * radius / Refining::fine);
}

TEST(CoarsenPath, LosesAQuarterOfTheErrorAskedForAtMost) {
  Session session = session_with_steps(), fine = session_with_steps();
  const std::size_t before = session.surface().triangles.size();
  const std::vector<Vec3f> bare = fine.surface().positions;
  StrokeSettings shallow = stroke_of(radius, 0.1);
  shallow.refining = {};
  draw_along(fine, shallow, along);
  float height = 0;
  for (std::size_t v = 0; v < bare.size(); ++v)
    height = std::max(height, (fine.surface().positions[v] - bare[v]).norm());
  shallow.refining = {.kind = Refining::Kind::error, .error = 0.02};
  draw_along(session, shallow, along);
  EXPECT_LT(session.surface().triangles.size(), before);
  const double most = 0.25 * 0.02 * static_cast<double>(height);
  EXPECT_LT(most, 0.005 * radius / Refining::fine);
  EXPECT_LE(farthest(fine, session), 1.01 * most);
}

TEST(CoarsenPath, DoesTheSameAsThePenComes) {
  Session told = coarse_session(), live = coarse_session();
  for (Session* session : {&told, &live}) draw_along(*session, stroke_of(narrow_radius, 1), along);
  const StrokeSettings wide = stroke_of(radius, 1);
  draw_along(told, wide, along);
  live.begin_stroke(wide);
  double time = 0;
  for (const Vec3d& place : along)
    ASSERT_EQ(live.add_sample(place, time += 0.01, {}).outcome, StrokeEvent::Outcome::drawn);
  live.end_stroke();
  ASSERT_EQ(live.refinements().size(), 2u);
  EXPECT_NEAR(static_cast<double>(live.refinements()[1].vertices_removed),
              static_cast<double>(told.refinements()[1].vertices_removed),
              0.05 * static_cast<double>(told.refinements()[1].vertices_removed));
}

TEST(CoarsenPath, LeavesTheMeshAsItWasGivenAlone) {
  Session session(make_surface(shuffled(plane(1, 0.01, 7), 8)), brushes());
  const std::size_t before = session.surface().triangles.size();
  StrokeSettings fine = refining(0.004);
  draw_along(session, fine, along);
  EXPECT_GT(session.surface().triangles.size(), before);
  StrokeSettings wide = refining(0.05);
  wide.radius = 0.3;
  wide.strength = 0;
  draw_along(session, wide, along);
  // All that was given has its place; vertices keep their numbers.
  EXPECT_GE(session.kept_vertices(), 201u * 201u);
  EXPECT_GE(session.surface().triangles.size(), before);
  EXPECT_GT(session.refinements().back().vertices_removed, 1000u);
}

TEST(CoarsenPath, KeepsWhatIsPaintedAndWhatMasksSay) {
  Session session = coarse_session();
  draw_along(session, stroke_of(narrow_radius, 0), along);
  Paint paint;
  for (const Vec3f& p : session.surface().positions) {
    paint.colour.push_back(p.y() > 0.01F ? Vec4f(1, 0, 0, 1) : Vec4f(0, 0, 1, 1));
    paint.mask.push_back(p.x() > 0 ? 1.F : 0.5F);
  }
  session.set_paint(paint);
  const std::vector<Vec3f> places(session.positions().begin(), session.positions().end());
  draw_along(session, stroke_of(radius, 0), along);
  EXPECT_GT(session.refinements().back().vertices_removed, 1000u);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto at = session.picker().closest(places[i], 1);
    Vec4f colour = Vec4f::Zero();
    float mask = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      colour += static_cast<float>(at->weights[k]) * session.paint().colour[at->corners[k]];
      mask += static_cast<float>(at->weights[k]) * session.paint().mask[at->corners[k]];
    }
    ASSERT_LT((colour - paint.colour[i]).cwiseAbs().maxCoeff(), 0.006F);
    ASSERT_NEAR(mask, paint.mask[i], 0.006F);
  }
}

TEST(CoarsenPath, KeepsWhatAStrokeToComeNeeds) {
  const StrokeSettings narrow = stroke_of(narrow_radius, 0), wide = stroke_of(radius, 0);
  Session told = coarse_session();
  draw_along(told, narrow, along);
  const std::size_t fine = told.surface().triangles.size();
  std::size_t asked = 0;
  told.begin_stroke(wide, along, [&] {
    ++asked;
    return std::vector<PlannedStroke>{{narrow, along}};
  });
  for (std::size_t i = 0; i < along.size(); ++i) told.add_sample(along[i], 0.01 * static_cast<double>(i), {});
  told.end_stroke();
  EXPECT_GE(asked, 1u);
  EXPECT_GE(told.surface().triangles.size(), fine);
}

// A replay tells of the strokes to come until each stroke ends.
TEST(CoarsenPath, KeepsWhatLaterStrokesOfARecordingNeed) {
  const auto removed_by_all = [](const std::vector<double>& radii) {
    Recording recording;
    for (const double wide : radii) {
      RecordedStroke& stroke = recording.strokes.emplace_back();
      stroke.settings[&StrokeSettings::brush] = "org.burin.groove";
      stroke.settings[&StrokeSettings::radius] = wide;
      stroke.settings[&StrokeSettings::strength] = 0;
      stroke.settings[&StrokeSettings::refining] = refining_if_coarse().refining;
      for (const Vec3d& place : along) stroke.samples.push_back({0, place, {}});
    }
    Session session = coarse_session();
    replay(session, recording);
    // A wide stroke that changes nothing has no report.
    std::size_t removed = 0;
    for (const RefineReport& report : session.refinements()) removed += report.vertices_removed;
    return removed;
  };
  const std::size_t all = removed_by_all({narrow_radius, radius});
  EXPECT_GT(all, 10'000u);
  // Around what the third stroke needs edges grow, and may go.
  EXPECT_LT(removed_by_all({narrow_radius, radius, narrow_radius}), all / 10);
}

}  // namespace
}  // namespace burin::test
