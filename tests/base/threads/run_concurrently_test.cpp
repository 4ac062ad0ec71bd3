#include <burin/base/threads/run_concurrently.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <numeric>
#include <vector>

namespace burin {
namespace {

constexpr std::size_t steps = 100;

using Board = std::vector<std::uint64_t>;

/// The next value of body `own` after it has read the values of all.
std::uint64_t after(const Board& board, std::size_t own) {
  return 3 * std::accumulate(board.begin(), board.end(), std::uint64_t{0}) + own;
}

/// The final values if each step waits for all of the previous step.
Board one_after_another(std::size_t bodies) {
  Board board(bodies), next(bodies);
  for (std::size_t step = 0; step < steps; ++step) {
    for (std::size_t own = 0; own < bodies; ++own) next[own] = after(board, own);
    board.swap(next);
  }
  return board;
}

TEST(SideBySide, BodiesReadAtEachStepWhatAllWroteBeforeIt) {
  // More of them than most machines have processors, too.
  for (const std::size_t bodies : {1U, 2U, 3U, 7U}) {
    std::array<Board, 2> boards{Board(bodies), Board(bodies)};
    StepBarrier barrier(bodies);
    run_concurrently(bodies, [&](std::size_t own) {
      for (std::size_t step = 0; step < steps; ++step) {
        boards[(step + 1) % 2][own] = after(boards[step % 2], own);
        barrier.arrive_and_wait();
      }
    });
    EXPECT_EQ(boards[steps % 2], one_after_another(bodies)) << bodies << " bodies";
  }
}

}  // namespace
}  // namespace burin
