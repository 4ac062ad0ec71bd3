// Steps of undo as objects that an application holds, beside the undo that sessions have themselves.
#include <gtest/gtest.h>

#include <random>

#include "c_host.h"

namespace burin::test {
namespace {

const std::vector<const char*> small_groove = {"brush=org.burin.groove", "radius=0.06"};
constexpr const char* other_state = "the surface is not in the state that the step belongs to";

TriangleMesh rough_coarse_plane() { return shuffled(plane(1, 0.03, 4), 5); }

/// The wave, moved along y.
std::vector<burin_sample> wave_at(double y) {
  std::vector<burin_sample> samples = in_c(wave(15));
  for (burin_sample& sample : samples) sample.position[1] = sample.position[1] / 3 + y;
  return samples;
}

/// All that a session shows.
struct Shown {
  explicit Shown(CSession& session)
      : positions(session.read(BURIN_POSITIONS, 3)),
        normals(session.read(BURIN_NORMALS, 3)),
        colours(session.read(BURIN_COLOURS, 4)),
        masks(session.read(BURIN_MASKS, 1)) {}
  bool operator==(const Shown&) const = default;

  std::vector<float> positions, normals, colours, masks;
};

/// A step of a session, or one that was loaded.
class Step {
 public:
  explicit Step(CSession& session) {
    session.check(IN_C(burin_session_take_step)(session, &step_, &session.error));
  }
  explicit Step(const std::vector<char>& bytes) {
    if (IN_C(burin_step_load)(bytes.data(), bytes.size(), &step_, &error) != BURIN_OK)
      throw std::runtime_error(error.str());
  }
  Step(Step&& other) noexcept : step_(std::exchange(other.step_, nullptr)) {}
  Step(const Step&) = delete;
  Step& operator=(const Step&) = delete;
  ~Step() { IN_C(burin_step_destroy)(step_); }

  burin_status try_apply(CSession& session) {
    return IN_C(burin_session_apply_step)(session, step_, &session.error);
  }
  void apply(CSession& session) { session.check(try_apply(session)); }
  burin_step_info info() {
    auto info = sized<burin_step_info>();
    EXPECT_EQ(IN_C(burin_step_get_info)(step_, &info, &error), BURIN_OK);
    return info;
  }
  std::vector<char> saved() {
    std::vector<char> bytes(info().saved_bytes);
    EXPECT_EQ(IN_C(burin_step_save)(step_, bytes.data(), bytes.size() - 1, &error), BURIN_INVALID_ARGUMENT);
    EXPECT_EQ(IN_C(burin_step_save)(step_, bytes.data(), bytes.size(), &error), BURIN_OK) << error.str();
    return bytes;
  }

  CText error;

 private:
  burin_step* step_ = nullptr;
};

TEST(CSteps, UndoAndMakeAgainToTheBitInTheOrderOfStrokes) {
  CSession session(rough_coarse_plane()), own(rough_coarse_plane());
  std::vector<Step> steps;
  std::vector<Shown> states{Shown(session)};
  for (const auto* settings : {&groove, &every_input, &groove}) {
    session.draw(*settings, wave_at(0.1));
    own.draw(*settings, wave_at(0.1));
    steps.emplace_back(session);
    states.emplace_back(session);
    EXPECT_EQ(session.info().undo_count, 0u);
    EXPECT_EQ(session.info().undo_bytes, 0u);
  }
  for (int round = 0; round < 2; ++round) {
    for (std::size_t i = 3; i-- > 0;) {
      steps[i].apply(session);
      own.check(IN_C(burin_session_undo)(own, &own.error));
      EXPECT_TRUE(Shown(session) == states[i]) << i;
      EXPECT_TRUE(Shown(session) == Shown(own)) << i;
    }
    for (std::size_t i = 0; i < 3; ++i) {
      steps[i].apply(session);
      own.check(IN_C(burin_session_redo)(own, &own.error));
      EXPECT_TRUE(Shown(session) == states[i + 1]) << i;
      EXPECT_EQ(session.hash(), own.hash());
    }
  }
  steps.pop_back();
  session.draw(small_groove, wave_at(0.1));
  own.draw(small_groove, wave_at(0.1));
  EXPECT_EQ(session.hash(), own.hash());
}

TEST(CSteps, AreRefusedInAnyOtherState) {
  CSession session(rough_coarse_plane());
  session.draw(small_groove, wave_at(-0.6));
  Step first(session);
  session.draw(small_groove, wave_at(0.6));
  Step second(session);
  session.update(BURIN_POSITIONS);
  const auto expect_refused = [&](Step& step) {
    const Shown before(session);
    EXPECT_EQ(step.try_apply(session), BURIN_INVALID_ARGUMENT);
    EXPECT_EQ(session.error.str(), other_state);
    EXPECT_TRUE(Shown(session) == before);
  };
  expect_refused(first);  // although it changes other vertices
  EXPECT_TRUE(session.update(BURIN_POSITIONS).empty());
  second.apply(session);
  EXPECT_FALSE(session.update(BURIN_POSITIONS).empty());
  first.apply(session);
  expect_refused(second);
  first.apply(session);
  second.apply(session);

  const auto write = [&](burin_attribute attribute, float value) {
    auto source = sized<burin_source>();
    source.type = BURIN_FLOAT32;
    const std::vector<float> values(3, value);
    source.data = values.data();
    const burin_range range{17, 18};
    session.check(IN_C(burin_session_write)(session, attribute, &range, &source, &session.error));
  };
  const Shown here(session);
  write(BURIN_MASKS, 0.5f);
  expect_refused(second);
  write(BURIN_MASKS, 1);
  second.apply(session);
  second.apply(session);
  write(BURIN_POSITIONS, 0.75f);
  expect_refused(second);
  auto source = sized<burin_source>();
  source.type = BURIN_FLOAT32;
  source.data = &here.positions[3 * 17];
  const burin_range range{17, 18};
  session.check(IN_C(burin_session_write)(session, BURIN_POSITIONS, &range, &source, &session.error));
  second.apply(session);
  EXPECT_EQ(IN_C(burin_session_undo)(session, &session.error), BURIN_NOT_FOUND);

  session.begin(groove);
  EXPECT_EQ(second.try_apply(session), BURIN_INVALID_ARGUMENT);
  EXPECT_EQ(session.error.str(), "a stroke is open");
  session.check(IN_C(burin_session_cancel)(session, &session.error));
  second.apply(session);
}

TEST(CSteps, AreRefusedByAnotherMesh) {
  CSession session(rough_coarse_plane()), smaller(plane(0.5, 0.03, 4));
  session.draw(groove, wave_at(0.1));
  Step step(session);
  EXPECT_EQ(step.try_apply(smaller), BURIN_INVALID_ARGUMENT);
  EXPECT_EQ(smaller.error.str(), other_state);
}

TEST(CSteps, OutliveTheirSessionInADocument) {
  const TriangleMesh mesh = rough_coarse_plane();
  std::vector<char> saved;
  TriangleMesh sculpted = mesh;
  std::vector<float> flat, drawn, colours;
  {
    CSession session(mesh);
    flat = session.read(BURIN_POSITIONS, 3);
    session.draw(every_input, wave_at(0.1));
    Step step(session);
    saved = step.saved();
    drawn = session.read(BURIN_POSITIONS, 3);
    colours = session.read(BURIN_COLOURS, 4);
    EXPECT_GT(step.info().vertex_count, 100u);
    EXPECT_GT(step.info().painted_count, 100u);
    EXPECT_GE(step.info().bytes, 16 * step.info().vertex_count + 4 * step.info().painted_count);
  }
  for (std::size_t i = 0; i < sculpted.positions.size(); ++i)
    sculpted.positions[i] = Vec3f(drawn[3 * i], drawn[3 * i + 1], drawn[3 * i + 2]);
  burin_mesh arrays = arrays_of(sculpted);
  // Sorted by its positions as they are now, the vertices have other numbers than in the session before.
  arrays.order = BURIN_ORDER_SURFACE;
  CSession reopened(arrays);
  Step loaded(saved);
  EXPECT_EQ(loaded.try_apply(reopened), BURIN_INVALID_ARGUMENT) << "its colours are missing";
  const burin_range all{0, sculpted.positions.size()};
  std::vector<std::uint32_t> source(sculpted.positions.size());
  reopened.check(IN_C(burin_session_read_map)(reopened, BURIN_MAP_SURFACE_TO_CALLER, source.data(),
                                              source.size(), &reopened.error));
  std::vector<float> sorted;
  for (const std::uint32_t vertex : source)
    sorted.insert(sorted.end(), &colours[4 * vertex], &colours[4 * vertex] + 4);
  auto from = sized<burin_source>();
  from.type = BURIN_FLOAT32;
  from.data = sorted.data();
  reopened.check(IN_C(burin_session_write)(reopened, BURIN_COLOURS, &all, &from, &reopened.error));
  const std::vector<float> masks = [&] {
    CSession drawn_again(mesh);
    drawn_again.draw(every_input, wave_at(0.1));
    return drawn_again.read(BURIN_MASKS, 1);
  }();
  std::vector<float> sorted_masks;
  for (const std::uint32_t vertex : source) sorted_masks.push_back(masks[vertex]);
  from.data = sorted_masks.data();
  reopened.check(IN_C(burin_session_write)(reopened, BURIN_MASKS, &all, &from, &reopened.error));
  loaded.apply(reopened);
  const std::vector<float> undone = reopened.read(BURIN_POSITIONS, 3);
  for (std::size_t i = 0; i < source.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) ASSERT_EQ(undone[3 * i + k], flat[3 * source[i] + k]) << i;
  loaded.apply(reopened);
  EXPECT_EQ(reopened.read(BURIN_COLOURS, 4), sorted);
  const std::vector<float> again = reopened.read(BURIN_POSITIONS, 3);
  for (std::size_t i = 0; i < source.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) ASSERT_EQ(again[3 * i + k], drawn[3 * source[i] + k]) << i;
}

TEST(CSteps, AreRefusedWhereTheirBytesAreDamaged) {
  CSession session(plane(1, 0.1, 4));
  session.draw(every_input, wave_at(0.1));
  const std::vector<char> saved = Step(session).saved();
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  CText error;
  burin_step* step = nullptr;
  const auto load = [&](const std::vector<char>& bytes) {
    return IN_C(burin_step_load)(bytes.data(), bytes.size(), &step, &error);
  };
  for (int round = 0; round < 300; ++round) {
    std::vector<char> damaged = saved;
    damaged[random() % (round < 150 ? 80 : damaged.size())] ^= static_cast<char>(1 + random() % 255);
    EXPECT_EQ(load(damaged), BURIN_ERROR);
    std::vector<char> cut = saved;
    cut.resize(random() % saved.size());
    EXPECT_EQ(load(cut), BURIN_ERROR);
  }
  EXPECT_EQ(step, nullptr);
  EXPECT_EQ(error.str().find("a saved step "), 0u) << error.str();
  EXPECT_EQ(load(saved), BURIN_OK);
  IN_C(burin_step_destroy)(step);
}

TEST(CSteps, OfTheSessionItselfAreBoundedOldestFirst) {
  CSession session(rough_coarse_plane());
  for (const double y : {-0.6, -0.2, 0.2, 0.6}) session.draw(groove, wave_at(y));
  const burin_session_info before = session.info();
  EXPECT_EQ(before.undo_count, 4u);
  EXPECT_EQ(before.undo_dropped, 0u);
  session.check(IN_C(burin_session_limit_undo)(session, before.undo_bytes * 6 / 10, &session.error));
  EXPECT_EQ(session.info().undo_count, 2u);
  EXPECT_EQ(session.info().undo_dropped, 2u);
  EXPECT_LE(session.info().undo_bytes, before.undo_bytes * 6 / 10);
  session.draw(groove, wave_at(0));
  EXPECT_EQ(session.info().undo_count, 2u);
  EXPECT_EQ(session.info().undo_dropped, 3u);
  Step step(session);
  EXPECT_EQ(session.info().undo_count, 1u);
  EXPECT_EQ(session.info().undo_dropped, 3u) << "taken, not dropped";

  // A program of an older header has no room for the number.
  auto old = sized<burin_session_info>();
  old.struct_size = offsetof(burin_session_info, undo_dropped);
  old.undo_dropped = 77;
  session.check(IN_C(burin_session_get_info)(session, &old, &session.error));
  EXPECT_EQ(old.undo_count, 1u);
  EXPECT_EQ(old.undo_dropped, 77u);
}

}  // namespace
}  // namespace burin::test
