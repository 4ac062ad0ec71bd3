// Strokes over several objects, beside the same samples drawn on each by itself.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "../../refine/refined.h"
#include "c_host.h"

namespace burin::test {
namespace {

/// The plane, moved.
TriangleMesh plane_at(double x, double z) {
  TriangleMesh mesh = shuffled(plane(1, 0.04, 4), 5);
  for (Vec3f& p : mesh.positions) p += Vec3f(static_cast<float>(x), 0, static_cast<float>(z));
  return mesh;
}

/// Rays from above along x, at y = 0.
std::vector<burin_sample> rays(double from, double to, int count = 60) {
  std::vector<burin_sample> samples;
  for (int i = 0; i < count; ++i) {
    auto sample = sized<burin_sample>();
    sample.pressure = 1;
    sample.time = 0.01 * i;
    sample.position[0] = from + (to - from) * i / (count - 1);
    sample.position[2] = 5;
    sample.direction[2] = -1;
    samples.push_back(sample);
  }
  return samples;
}

/// A group of libburin.so whose calls must succeed, unless a test calls by itself.
class CGroup {
 public:
  explicit CGroup(const std::vector<burin_session*>& sessions) {
    check(IN_C(burin_group_create)(sessions.data(), sessions.size(), &group_, &error));
  }
  CGroup(const CGroup&) = delete;
  CGroup& operator=(const CGroup&) = delete;
  ~CGroup() { IN_C(burin_group_destroy)(group_); }

  operator burin_group*() const { return group_; }

  burin_status try_begin(std::vector<const char*> settings, const std::vector<burin_sample>& path = {}) {
    settings.push_back(nullptr);
    auto stroke = sized<burin_stroke>();
    stroke.fields = BURIN_PEN_PRESSURE;
    stroke.settings = settings.data();
    stroke.path = path.data();
    stroke.path_count = path.size();
    return IN_C(burin_group_begin)(group_, &stroke, &error);
  }
  burin_group_event add(const std::vector<burin_sample>& samples) {
    auto event = sized<burin_group_event>();
    check(IN_C(burin_group_add)(group_, samples.data(), samples.size(), &event, &error));
    return event;
  }
  void end() { check(IN_C(burin_group_end)(group_, &error)); }
  /// Returns the sessions that the samples went to; the count of sessions for those off all surfaces.
  std::vector<std::size_t> draw(const std::vector<const char*>& settings,
                                const std::vector<burin_sample>& samples, std::size_t none) {
    std::vector<std::size_t> hit;
    check(try_begin(settings));
    for (const burin_sample& sample : samples) {
      const burin_group_event event = add({sample});
      hit.push_back(event.outcome == BURIN_OUTCOME_DRAWN ? event.session : none);
    }
    end();
    return hit;
  }
  void undo() { check(IN_C(burin_group_undo)(group_, &error)); }
  void redo() { check(IN_C(burin_group_redo)(group_, &error)); }
  void check(burin_status status) {
    if (status != BURIN_OK) throw std::runtime_error(error.str());
  }

  CText error;

 private:
  burin_group* group_ = nullptr;
};

/// Three planes that overlap as seen from above: the middle one lies highest, the right one lowest.
class CGroups : public ::testing::Test {
 protected:
  TriangleMesh meshes[3] = {plane_at(-1.5, 0), plane_at(0, 0.5), plane_at(1.5, -0.5)};
  CSession left{meshes[0]}, middle{meshes[1]}, right{meshes[2]};
  CSession* all[3] = {&left, &middle, &right};
  CGroup group{{left, middle, right}};

  std::vector<std::uint64_t> hashes() {
    std::vector<std::uint64_t> found;
    for (CSession* session : all) found.push_back(session->hash());
    return found;
  }
};

TEST_F(CGroups, DrawOnWhatThePenMeetsFirst) {
  std::vector<burin_sample> samples = rays(-2.3, 2.8);
  const std::vector<burin_sample> back = rays(2.8, 0.3, 30);
  for (burin_sample sample : back) {
    sample.time += 1;
    sample.position[1] = 0.3;
    samples.push_back(sample);
  }
  const std::vector<std::uint64_t> before = hashes();
  const std::vector<std::size_t> hit = group.draw(groove, samples, 3);
  std::vector<std::size_t> runs = hit;
  runs.erase(std::unique(runs.begin(), runs.end()), runs.end());
  EXPECT_EQ(runs, (std::vector<std::size_t>{0, 1, 2, 3, 2, 1}));
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const double x = samples[k].position[0];
    const std::size_t there = x < -1 ? 0 : x < 1 ? 1 : x < 2.5 ? 2 : 3;
    EXPECT_EQ(hit[k], there) << x;
  }

  // Each by itself draws its samples, with a piece wherever the pen was elsewhere.
  for (std::size_t i = 0; i < 3; ++i) {
    CSession expected(meshes[i]);
    expected.begin(groove, BURIN_PEN_PRESSURE);
    for (std::size_t k = 0; k < samples.size(); ++k) {
      burin_sample sample = samples[k];
      if (hit[k] != i) sample.position[0] = 100;
      expected.add({sample});
    }
    expected.end();
    EXPECT_EQ(all[i]->hash(), expected.hash()) << i;
    EXPECT_NE(all[i]->hash(), before[i]) << i;
    EXPECT_EQ(all[i]->info().undo_count, 1u);
  }
  const std::vector<std::uint64_t> drawn = hashes();
  group.undo();
  EXPECT_EQ(hashes(), before);
  group.redo();
  EXPECT_EQ(hashes(), drawn);
}

TEST_F(CGroups, OfOneSessionDrawAsTheSession) {
  CSession alone(meshes[1]), expected(meshes[1]);
  CGroup one({alone});
  for (const char* closed : {"closed=no", "closed=yes"}) {
    std::vector<const char*> settings = groove;
    settings.push_back(closed);
    settings.push_back("stabilise=string:0.05");
    std::vector<burin_sample> samples = in_c(wave(30));
    for (burin_sample& sample : samples) sample.position[2] = 0.5;
    one.check(one.try_begin(settings));
    expected.begin(settings, BURIN_PEN_PRESSURE);
    one.add(samples);
    expected.add(samples);
    one.end();
    expected.end();
    EXPECT_EQ(alone.hash(), expected.hash()) << closed;
  }
}

TEST(CGroup, RefinesEachSurfaceWhereItsSamplesWillBe) {
  const std::vector<const char*> refining = {"brush=org.burin.groove", "radius=0.15", "refine=auto"};
  const TriangleMesh meshes[] = {box({2, 1, 1}), box({1, 1, 0.5f})};
  std::vector<std::unique_ptr<CSession>> told, untold;
  for (auto* sessions : {&told, &untold})
    for (const TriangleMesh& mesh : meshes) {
      burin_mesh arrays = arrays_of(mesh);
      arrays.refines = 1;
      sessions->push_back(std::make_unique<CSession>(arrays));
    }
  std::vector<burin_sample> samples = rays(0.3, 1.7);  // over the first, above the second
  for (burin_sample& sample : samples) sample.position[1] = 0.5;
  CGroup group({*told[0], *told[1]}), later({*untold[0], *untold[1]});
  group.check(group.try_begin(refining, samples));
  const std::uint64_t begun = told[0]->info().generation;
  EXPECT_EQ(begun, 1u);
  EXPECT_EQ(told[1]->info().generation, 0u) << "the pen will not be there";
  group.add(samples);
  group.end();
  EXPECT_EQ(told[0]->info().generation, begun);
  later.draw(refining, samples, 2);
  EXPECT_GT(untold[0]->info().generation, 1u);
  group.undo();
  EXPECT_EQ(told[0]->info().vertex_count, 8u);
}

TEST_F(CGroups, GoToTheClosestSurfaceOfAPosition) {
  std::vector<burin_sample> samples = rays(-1.2, 1.2);
  for (burin_sample& sample : samples) {
    sample.direction[2] = 0;
    sample.position[2] = sample.position[0] < -0.6 ? 0.1 : sample.position[0] < 0.6 ? 0.45 : -0.55;
  }
  std::vector<std::size_t> hit = group.draw(groove, samples, 3);
  hit.erase(std::unique(hit.begin(), hit.end()), hit.end());
  EXPECT_EQ(hit, (std::vector<std::size_t>{0, 1, 2}));
}

TEST_F(CGroups, UndoOneStrokeInAllTheSessionsItChanged) {
  std::vector<std::vector<std::uint64_t>> states{hashes()};
  const std::vector<burin_sample> strokes[] = {rays(-2.3, -0.2), rays(-0.8, 2.3), rays(10, 11),
                                               rays(1.2, 2.3)};
  for (const auto& samples : strokes) {
    group.draw(groove, samples, 3);
    states.push_back(hashes());
  }
  EXPECT_EQ(states[2], states[3]) << "beside all surfaces, which is no step";
  states.erase(states.begin() + 3);
  for (std::size_t i = 3; i-- > 0;) {
    group.undo();
    EXPECT_EQ(hashes(), states[i]) << i;
  }
  EXPECT_EQ(IN_C(burin_group_undo)(group, &group.error), BURIN_NOT_FOUND);
  for (std::size_t i = 1; i < 4; ++i) {
    group.redo();
    EXPECT_EQ(hashes(), states[i]) << i;
  }
  EXPECT_EQ(IN_C(burin_group_redo)(group, &group.error), BURIN_NOT_FOUND);
  group.undo();
  group.draw(groove, rays(-2.3, -1.2), 3);
  EXPECT_EQ(IN_C(burin_group_redo)(group, &group.error), BURIN_NOT_FOUND);
}

TEST_F(CGroups, DoNotUndoWhatIsNotTheirs) {
  group.draw(groove, rays(-1.2, 1.2), 3);
  right.draw({"brush=org.burin.groove", "radius=0.15"}, rays(1.2, 2.3));
  const std::vector<std::uint64_t> drawn = hashes();
  EXPECT_EQ(IN_C(burin_group_undo)(group, &group.error), BURIN_INVALID_ARGUMENT);
  EXPECT_EQ(group.error.str(), "a session has drawn, undone or made again a stroke by itself");
  EXPECT_EQ(hashes(), drawn);
  right.check(IN_C(burin_session_undo)(right, &right.error));
  group.undo();
  group.redo();
  middle.check(IN_C(burin_session_limit_undo)(middle, 0, &middle.error));
  EXPECT_EQ(IN_C(burin_group_undo)(group, &group.error), BURIN_NOT_FOUND);
  EXPECT_EQ(group.error.str(), "a session holds the step no more");
}

TEST_F(CGroups, AreCancelledAndFailInAllSessions) {
  const std::vector<std::uint64_t> before = hashes();
  group.check(group.try_begin(groove));
  group.add(rays(-2.3, 1.8));
  EXPECT_NE(hashes(), before);
  EXPECT_EQ(middle.info().stroke_open, 1u);
  EXPECT_EQ(IN_C(burin_session_end)(middle, &middle.error), BURIN_INVALID_ARGUMENT);
  EXPECT_EQ(middle.error.str(), "the stroke is one of a group");
  EXPECT_EQ(IN_C(burin_session_cancel)(middle, &middle.error), BURIN_INVALID_ARGUMENT);
  EXPECT_EQ(middle.try_begin(groove), BURIN_INVALID_ARGUMENT);
  EXPECT_EQ(IN_C(burin_group_undo)(group, &group.error), BURIN_INVALID_ARGUMENT);
  group.check(IN_C(burin_group_cancel)(group, &group.error));
  EXPECT_EQ(hashes(), before);

  // On a ball whose side goes up far above it the brush returns what is not allowed.
  TriangleMesh deep = sphere(5, 0.2, 6);
  for (Vec3f& p : deep.positions) p += Vec3f(4, 0, -10);
  CSession ball(deep);
  CGroup failing({left, ball});
  const std::uint64_t whole = ball.hash();
  failing.check(failing.try_begin(raise_to));
  auto sample = sized<burin_sample>();
  sample.pressure = 1;
  sample.position[0] = -1.5;
  failing.add({sample});
  EXPECT_NE(left.hash(), 0u);
  burin_status status = BURIN_OK;
  for (double a = 0.3; status == BURIN_OK && a < 2; a += 0.1) {
    sample.position[0] = 4 + std::sin(a);
    sample.position[2] = std::cos(a) - 10;
    status = IN_C(burin_group_add)(failing, &sample, 1, nullptr, &failing.error);
  }
  EXPECT_EQ(status, BURIN_ERROR);
  EXPECT_EQ(hashes(), before);
  EXPECT_EQ(ball.hash(), whole);
  EXPECT_EQ(left.info().stroke_open + ball.info().stroke_open, 0u);
  failing.draw(groove, rays(-2.3, -1.2), 2);
  EXPECT_NE(left.hash(), before[0]);
}

TEST_F(CGroups, OfNothingOrTheSameTwiceAreRefused) {
  burin_group* made = nullptr;
  CText error;
  burin_session* const twice[] = {left, middle, left};
  EXPECT_EQ(IN_C(burin_group_create)(twice, 3, &made, &error), BURIN_INVALID_ARGUMENT);
  EXPECT_EQ(error.str(), "a session is there twice");
  EXPECT_EQ(IN_C(burin_group_create)(twice, 0, &made, &error), BURIN_INVALID_ARGUMENT);
  EXPECT_EQ(error.str(), "a group wants a session");
  EXPECT_EQ(made, nullptr);
  EXPECT_EQ(group.try_begin({"brush=org.burin.groove"}), BURIN_INVALID_ARGUMENT);
  EXPECT_EQ(group.error.str(), "settings lack the radius");
  EXPECT_EQ(group.try_begin({"brush=no.such", "radius=0.1"}), BURIN_NOT_FOUND);
  EXPECT_EQ(left.info().stroke_open, 0u);
  right.begin(groove);
  EXPECT_EQ(group.try_begin(groove), BURIN_INVALID_ARGUMENT);
  EXPECT_EQ(group.error.str(), "session 2 has an open stroke");
  right.check(IN_C(burin_session_cancel)(right, &right.error));
  const auto sample = sized<burin_sample>();
  EXPECT_EQ(IN_C(burin_group_add)(group, &sample, 1, nullptr, &group.error), BURIN_INVALID_ARGUMENT);
  EXPECT_EQ(group.error.str(), "no stroke is open");
  group.check(group.try_begin(groove));
  auto wrong = sized<burin_sample>();
  wrong.pressure = 2;
  EXPECT_EQ(IN_C(burin_group_add)(group, &wrong, 1, nullptr, &group.error), BURIN_INVALID_ARGUMENT);
  EXPECT_EQ(group.error.str(), "sample 0: its pressure is not from 0 to 1");
  group.add(rays(-2.3, 1.8));
  group.end();
}

}  // namespace
}  // namespace burin::test
