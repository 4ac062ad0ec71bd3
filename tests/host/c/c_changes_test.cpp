// What libburin.so tells of changes, held against the values before and after.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <random>

#include <burin/host/c/ranges.h>
#include <burin/surface/mesh_file.h>
#include <burin/surface/triangulate.h>
#include "c_host.h"

namespace burin::test {
namespace {

struct Attribute {
  burin_attribute name;
  std::size_t size;
};
constexpr Attribute attributes[] = {
    {BURIN_POSITIONS, 3}, {BURIN_NORMALS, 3}, {BURIN_COLOURS, 4}, {BURIN_MASKS, 1}};

/// A caller's copies of all values, held against the session's after every call.
class Watched {
 public:
  explicit Watched(const TriangleMesh& mesh, burin_order order = BURIN_ORDER_CALLER)
      : session(with(mesh, order)) {
    for (const Attribute& attribute : attributes) {
      const std::vector<burin_range> all = session.update(attribute.name);
      EXPECT_EQ(all.size(), 1u);
      EXPECT_EQ(all.front().begin, 0u);
      EXPECT_EQ(all.front().end, mesh.positions.size());
      seen_.push_back(session.read(attribute.name, attribute.size));
    }
  }

  /// Updates, and expects the ranges to be the vertices where a bit differs; returns their number, of all
  /// attributes.
  std::size_t expect_differences() {
    std::size_t different = 0;
    for (std::size_t i = 0; i < seen_.size(); ++i) {
      const auto [name, size] = attributes[i];
      const std::vector<float> now = session.read(name, size);
      const std::vector<burin_range> ranges = session.update(name);
      std::vector<bool> told(now.size() / size);
      std::uint64_t last = 0;
      for (const burin_range& range : ranges) {
        EXPECT_LT(range.begin, range.end);
        EXPECT_TRUE(range.begin > last || last == 0);
        last = range.end;
        std::fill(told.begin() + static_cast<std::ptrdiff_t>(range.begin),
                  told.begin() + static_cast<std::ptrdiff_t>(range.end), true);
      }
      for (std::size_t vertex = 0; vertex < told.size(); ++vertex) {
        const bool differs =
            std::memcmp(&seen_[i][vertex * size], &now[vertex * size], size * sizeof(float)) != 0;
        if (differs != told[vertex]) ADD_FAILURE() << "attribute " << name << ", vertex " << vertex;
        different += differs;
      }
      EXPECT_EQ(
          std::memcmp(IN_C(burin_session_values)(session, name), now.data(), now.size() * sizeof(float)), 0);
      seen_[i] = now;
    }
    return different;
  }

  CSession session;

 private:
  static burin_mesh with(const TriangleMesh& mesh, burin_order order) {
    burin_mesh arrays = arrays_of(mesh);
    arrays.order = order;
    return arrays;
  }

  std::vector<std::vector<float>> seen_;  ///< of attributes, in their order
};

class CChanges : public ::testing::TestWithParam<burin_order> {
 protected:
  Watched watched{shuffled(plane(1, 0.03, 4), 5), GetParam()};
  CSession& session = watched.session;
};
INSTANTIATE_TEST_SUITE_P(Orders, CChanges, testing::Values(BURIN_ORDER_CALLER, BURIN_ORDER_SURFACE));

TEST_P(CChanges, AreTheDifferencesAfterEveryCall) {
  std::size_t events = 0;
  for (const auto* settings : {&every_input, &groove}) {
    session.begin(*settings);
    EXPECT_EQ(watched.expect_differences(), 0u);
    for (const burin_sample& sample : in_c(wave(15))) {
      session.add({sample});
      events += watched.expect_differences() > 0;
    }
    session.end();
    watched.expect_differences();
  }
  EXPECT_GT(events, 20u);
  for (int i = 0; i < 2; ++i) {
    session.check(IN_C(burin_session_undo)(session, &session.error));
    EXPECT_GT(watched.expect_differences(), 200u);
  }
  for (int i = 0; i < 2; ++i) {
    session.check(IN_C(burin_session_redo)(session, &session.error));
    EXPECT_GT(watched.expect_differences(), 200u);
  }
}

TEST_P(CChanges, AreTheDifferencesAfterCancelling) {
  session.begin(every_input);
  session.add(in_c(wave(15)));
  EXPECT_GT(watched.expect_differences(), 200u);
  session.check(IN_C(burin_session_cancel)(session, &session.error));
  EXPECT_GT(watched.expect_differences(), 200u);
  EXPECT_EQ(session.info().stroke_open, 0u);
}

TEST_P(CChanges, GatherUntilTheyAreAskedFor) {
  session.begin(every_input);
  for (const burin_sample& sample : in_c(wave(15))) session.add({sample});
  session.check(IN_C(burin_session_cancel)(session, &session.error));
  EXPECT_EQ(watched.expect_differences(), 0u) << "all is as it was seen";
  session.draw(every_input, in_c(wave(15)));
  session.draw(groove, in_c(wave(15)));
  session.check(IN_C(burin_session_undo)(session, &session.error));
  EXPECT_GT(watched.expect_differences(), 200u);
}

TEST_P(CChanges, AreTheDifferencesAcrossPieces) {
  std::vector<burin_sample> samples = in_c(wave(15));
  samples[7].position[2] = 5;
  session.begin(every_input);
  for (const burin_sample& sample : samples) {
    session.add({sample});
    watched.expect_differences();
  }
  session.end();
  watched.expect_differences();
  session.check(IN_C(burin_session_undo)(session, &session.error));
  EXPECT_GT(watched.expect_differences(), 200u);
}

TEST_P(CChanges, AreTheDifferencesThatOtherToolsMake) {
  const auto write = [&](burin_attribute attribute, burin_range range, const std::vector<double>& values) {
    auto source = sized<burin_source>();
    source.type = BURIN_FLOAT64;
    source.data = values.data();
    session.check(IN_C(burin_session_write)(session, attribute, &range, &source, &session.error));
  };
  const std::vector<float> flat = session.read(BURIN_POSITIONS, 3);
  std::vector<double> raised(flat.begin() + 300, flat.begin() + 900);
  const std::vector<double> before = raised;
  for (std::size_t i = 2; i < raised.size(); i += 9) raised[i] += 0.25;
  write(BURIN_POSITIONS, {100, 300}, raised);
  EXPECT_GT(watched.expect_differences(), 67u);
  const std::vector<float> now = session.read(BURIN_POSITIONS, 3);
  EXPECT_TRUE(std::equal(raised.begin(), raised.end(), now.begin() + 300));
  EXPECT_EQ(session.info().undo_count, 0u);
  session.draw(groove, in_c(wave(15)));
  watched.expect_differences();
  session.check(IN_C(burin_session_undo)(session, &session.error));
  watched.expect_differences();
  EXPECT_EQ(session.read(BURIN_POSITIONS, 3), now);
  write(BURIN_POSITIONS, {100, 300}, before);
  watched.expect_differences();
  EXPECT_EQ(session.read(BURIN_POSITIONS, 3), flat);
  session.check(IN_C(burin_session_redo)(session, &session.error));
  watched.expect_differences();

  write(BURIN_MASKS, {10, 13}, {0, 0.5, 1});
  EXPECT_EQ(watched.expect_differences(), 2u);
  write(BURIN_COLOURS, {20, 21}, {0.25, 0.5, 0.75, 1});
  EXPECT_EQ(watched.expect_differences(), 1u);
  EXPECT_EQ(session.read(BURIN_COLOURS, 4)[4 * 20 + 2], 0.75f);
  EXPECT_EQ(session.read(BURIN_MASKS, 1)[11], 0.5f);
}

/// Cancels what it watches at the call of this number.
struct Watcher {
  static int32_t BURIN_CALL look(void* user, const char* stage, double done) {
    auto& watcher = *static_cast<Watcher*>(user);
    EXPECT_STREQ(stage, "replaying strokes");
    EXPECT_GE(done, watcher.done);
    watcher.done = done;
    return ++watcher.calls == watcher.cancels_at;
  }
  int calls = 0, cancels_at = 0;
  double done = 0;
};

TEST(CInfo, TellsWhetherThereAreColoursAndMasks) {
  CSession session(plane(1, 0.05, 4));
  const auto expect = [&](std::uint32_t colours, std::uint32_t masks) {
    EXPECT_EQ(session.info().has_colours, colours);
    EXPECT_EQ(session.info().has_masks, masks);
  };
  expect(0, 0);
  session.draw(every_input, in_c(wave(15)));
  expect(1, 1);
  session.check(IN_C(burin_session_undo)(session, &session.error));
  expect(0, 0);
  const std::vector<float> free(session.info().vertex_count, 1);
  auto source = sized<burin_source>();
  source.type = BURIN_FLOAT32;
  source.data = free.data();
  const burin_range all{0, free.size()};
  session.check(IN_C(burin_session_write)(session, BURIN_MASKS, &all, &source, &session.error));
  expect(0, 1);
}

TEST(CChangesOfFailures, AreTheDifferencesWhenARecordingIsCancelled) {
  const std::string stroke = std::string(BURIN_SAMPLES) + "/strokes/meander.stroke";
  Watched watched(triangulate(read_mesh(std::string(BURIN_SAMPLES) + "/meshes/ewer.obj")));
  CSession& session = watched.session;
  const std::uint64_t before = session.hash();
  Watcher watcher{.cancels_at = 100};
  session.check(IN_C(burin_session_set_progress)(session, Watcher::look, &watcher, &session.error));
  EXPECT_EQ(IN_C(burin_session_replay)(session, stroke.c_str(), nullptr, &session.error), BURIN_ERROR);
  EXPECT_EQ(session.error.str(), "stroke 1: cancelled");
  EXPECT_EQ(watcher.calls, 100);
  EXPECT_EQ(watched.expect_differences(), 0u);
  EXPECT_EQ(session.hash(), before);
  EXPECT_EQ(session.info().stroke_open, 0u);
  watcher = {};
  session.check(IN_C(burin_session_replay)(session, stroke.c_str(), nullptr, &session.error));
  EXPECT_EQ(watcher.done, 1);
  EXPECT_GT(watched.expect_differences(), 50u);
}

TEST(CChangesOfFailures, AreTheDifferencesWhenTheBrushFails) {
  // Far below the plane to which the brush raises it, at last farther than brushes may.
  TriangleMesh deep = sphere(5, 0.2, 6);
  for (Vec3f& position : deep.positions) position.z() -= 10;
  Watched watched(deep);
  CSession& session = watched.session;
  const std::uint64_t before = session.hash();
  session.begin(raise_to);
  std::size_t drawn = 0;
  burin_status status = BURIN_OK;
  for (double a = 0.3; status == BURIN_OK && a < 2; a += 0.1, ++drawn) {
    auto sample = sized<burin_sample>();
    sample.pressure = 1;
    sample.position[0] = std::sin(a);
    sample.position[2] = std::cos(a) - 10;
    status = session.try_add({sample});
    if (status == BURIN_OK) EXPECT_GT(watched.expect_differences(), 0u);
  }
  EXPECT_GT(drawn, 5u);
  EXPECT_EQ(status, BURIN_ERROR);
  EXPECT_NE(session.error.str().find("org.burin.test.raise-to: "), std::string::npos) << session.error.str();
  EXPECT_GT(watched.expect_differences(), 200u);
  EXPECT_EQ(session.hash(), before);
  EXPECT_EQ(session.info().stroke_open, 0u);
  std::vector<Sample> wave = wave_on_sphere(10);
  for (Sample& sample : wave) sample.position.z() -= 10;
  session.draw(groove, in_c(wave));
  EXPECT_GT(watched.expect_differences(), 200u) << "the session goes on";
}

/// The vertices of ranges.
std::vector<std::uint64_t> vertices_of(const std::vector<burin_range>& ranges) {
  std::vector<std::uint64_t> vertices;
  for (const burin_range& range : ranges)
    for (std::uint64_t vertex = range.begin; vertex < range.end; ++vertex) vertices.push_back(vertex);
  return vertices;
}

std::uint64_t distance(const burin_range& a, const burin_range& b) { return b.begin - a.end; }

TEST(CRanges, AreMoreThanTheGapApartAndClosestWhereTheyAreTooMany) {
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  std::size_t joined = 0, cut = 0;
  for (int round = 0; round < 500; ++round) {
    const std::uint64_t gap = random() % 6;
    const std::size_t most = 1 + random() % 12;
    std::vector<std::uint64_t> vertices;
    for (std::uint64_t at = random() % 9, i = 0; i < 60; ++i, at += 1 + (random() % 3 ? 0 : random() % 9))
      vertices.push_back(at);
    c::Ranges exact(0), gaps(gap);
    for (const std::uint64_t vertex : vertices) exact.add(vertex), gaps.add(vertex);
    const std::vector<burin_range> all = exact.at_most(1000), apart = gaps.at_most(1000),
                                   few = gaps.at_most(most);
    EXPECT_EQ(vertices_of(all), vertices);
    joined += apart.size() < all.size();
    for (std::size_t i = 1; i < apart.size(); ++i) EXPECT_GT(distance(apart[i - 1], apart[i]), gap);
    // A greater gap gives fewer vertices between: those of the gaps that were closed, each at most `gap`.
    std::uint64_t closed = 0;
    for (std::size_t i = 1; i < all.size(); ++i)
      if (distance(all[i - 1], all[i]) <= gap) closed += distance(all[i - 1], all[i]);
    EXPECT_EQ(vertices_of(apart).size(), vertices.size() + closed);
    // Where they are too many, the widest gaps stay open.
    ASSERT_LE(few.size(), most);
    EXPECT_EQ(few.size(), std::min(most, apart.size()));
    EXPECT_EQ(few.front().begin, apart.front().begin);
    EXPECT_EQ(few.back().end, apart.back().end);
    if (few.size() == apart.size()) continue;
    ++cut;
    std::vector<std::uint64_t> widths, kept;
    for (std::size_t i = 1; i < apart.size(); ++i) widths.push_back(distance(apart[i - 1], apart[i]));
    for (std::size_t i = 1; i < few.size(); ++i) kept.push_back(distance(few[i - 1], few[i]));
    std::ranges::sort(widths, std::greater<>());
    std::ranges::sort(kept, std::greater<>());
    widths.resize(kept.size());
    EXPECT_EQ(kept, widths);
  }
  EXPECT_GT(joined, 100u);
  EXPECT_GT(cut, 100u);
}

TEST(CRanges, OfASessionObeyGapAndCapacity) {
  CSession session(plane(1, 0.03, 4));
  session.update(BURIN_POSITIONS);
  session.draw(groove, in_c(wave(15)));
  const std::vector<burin_range> ranges = session.update(BURIN_POSITIONS, 5);
  EXPECT_GT(ranges.size(), 3u);
  for (std::size_t i = 1; i < ranges.size(); ++i) EXPECT_GT(distance(ranges[i - 1], ranges[i]), 5u);
  session.check(IN_C(burin_session_undo)(session, &session.error));
  EXPECT_EQ(session.update(BURIN_POSITIONS, 0, 3).size(), 3u);
  EXPECT_TRUE(session.update(BURIN_POSITIONS).empty());
}

}  // namespace
}  // namespace burin::test
