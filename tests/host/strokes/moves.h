#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "host/sessions.h"

namespace burin::test {

/// A row of pens, each a ray.
using Pens = std::vector<Ray>;

/// The displacement of each vertex by a stroke, in the vertex order of the original mesh. The stroke must
/// have one piece.
inline std::vector<Vec3d> added(Session& session, const StrokeSettings& settings, const Pens& pens) {
  const std::vector<Vec3f> before(session.positions().begin(), session.positions().end());
  session.begin_stroke(settings);
  for (std::size_t i = 0; i < pens.size(); ++i) {
    const auto time = static_cast<double>(i) / 240;
    EXPECT_EQ(session.add_sample(pens[i], time, {}, Show::later).outcome, StrokeEvent::Outcome::drawn)
        << "sample " << i;
  }
  session.end_stroke();
  std::vector<Vec3d> moves(before.size());
  for (std::size_t v = 0; v < before.size(); ++v)
    moves[session.surface().source_vertex[v]] = (session.positions()[v] - before[v]).cast<double>();
  return moves;
}

/// The differences of displacements from expected ones, over the vertices that move in either.
struct MoveError {
  double rms = 0;       ///< object units
  double farthest = 0;  ///< longest move, object units
  std::size_t moved = 0;
};

inline MoveError move_error(const std::vector<Vec3d>& moves, const std::vector<Vec3d>& expected) {
  MoveError error;
  double squares = 0;
  for (std::size_t v = 0; v < moves.size(); ++v) {
    if (moves[v].isZero(0) && expected[v].isZero(0)) continue;
    squares += (moves[v] - expected[v]).squaredNorm();
    error.farthest = std::max(error.farthest, moves[v].norm());
    ++error.moved;
  }
  error.rms = std::sqrt(squares / static_cast<double>(std::max<std::size_t>(error.moved, 1)));
  return error;
}

/// 41 points at even distances.
inline std::vector<Vec3d> line(const Vec3d& from, const Vec3d& to) {
  std::vector<Vec3d> places;
  for (int i = 0; i <= 40; ++i) places.push_back(from + i / 40. * (to - from));
  return places;
}

}  // namespace burin::test
