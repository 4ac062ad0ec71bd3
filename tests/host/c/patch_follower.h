#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <set>
#include <vector>

#include "c_host.h"

namespace burin::test {

/// The arrays of a mesh whose triangles strokes may change. It must outlive them.
inline burin_mesh refinable(const TriangleMesh& mesh) {
  burin_mesh arrays = arrays_of(mesh);
  arrays.refines = 1;
  return arrays;
}

/// Arrays of a caller's that follow a session by what it tells.
class Follower {
 public:
  explicit Follower(CSession& session) : session_(session), triangles(session.info().triangle_count) {
    session.check(IN_C(burin_session_read_triangles)(session, triangles.front().data(), triangles.size(),
                                                     &session.error));
    follow();
  }

  /// Takes the news, and expects that the arrays are the surface then; returns how many triangles changed.
  std::size_t follow() {
    auto patch = sized<burin_patch>();
    session_.check(IN_C(burin_session_take_patch)(session_, &patch, &session_.error));
    const std::vector<float> before = positions;
    apply(patch);
    for (const burin_range& range : session_.update(BURIN_POSITIONS))
      std::copy_n(IN_C(burin_session_values)(session_, BURIN_POSITIONS) + 3 * range.begin,
                  3 * (range.end - range.begin),
                  positions.begin() + static_cast<std::ptrdiff_t>(3 * range.begin));
    expect_surface();
    return patch.removed_count + patch.added_count;
  }

 private:
  void apply(const burin_patch& patch) {
    EXPECT_LE(patch.kept_vertices, patch.vertex_count);
    kept = patch.kept_vertices;
    EXPECT_TRUE(std::is_sorted(patch.removed, patch.removed + patch.removed_count));
    std::vector<bool> gone(triangles.size());
    for (std::uint64_t i = 0; i < patch.removed_count; ++i) gone.at(patch.removed[i]) = true;
    std::vector<Triangle> left;
    for (std::size_t i = 0; i < triangles.size(); ++i)
      if (!gone[i]) left.push_back(triangles[i]);
    EXPECT_EQ(left.size() + patch.removed_count, triangles.size()) << "each once";
    for (std::uint64_t i = 0; i < patch.added_count; ++i)
      left.push_back({patch.added[3 * i], patch.added[3 * i + 1], patch.added[3 * i + 2]});
    triangles = left;
    // What is new is told as changed.
    positions.resize(3 * patch.kept_vertices);
    positions.resize(3 * patch.vertex_count, 77);
  }

  void expect_surface() {
    const burin_session_info info = session_.info();
    EXPECT_EQ(positions.size(), 3 * info.vertex_count);
    EXPECT_EQ(triangles.size(), info.triangle_count);
    const std::vector<float> now = session_.read(BURIN_POSITIONS, 3);
    EXPECT_EQ(std::memcmp(positions.data(), now.data(), now.size() * sizeof(float)), 0);
    std::vector<Triangle> list(triangles.size());
    session_.check(
        IN_C(burin_session_read_triangles)(session_, list.front().data(), list.size(), &session_.error));
    EXPECT_EQ(triangles, list);
  }

  CSession& session_;

 public:
  std::vector<Triangle> triangles;
  std::vector<float> positions;
  std::uint64_t kept = 0;  ///< vertices, by the last patch
};

inline std::multiset<Triangle> as_set(const std::vector<Triangle>& triangles) {
  return {triangles.begin(), triangles.end()};
}

}  // namespace burin::test
