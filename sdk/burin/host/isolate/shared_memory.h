#pragma once
#include <burin/abi/stroke.h>

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

/// What the host and the process of a brush have in common in memory: a header, then lanes. The host takes
/// nothing from it on trust: it never reads a place or a size from there, and copies what it checks first.
namespace burin::isolate {

inline constexpr std::size_t lane_bytes = std::size_t{1} << 20;
inline constexpr std::size_t most_lanes = 256;
inline constexpr std::size_t text_bytes = 512;

/// The descriptors that the process finds open at its start, besides the standard streams.
enum : int { socket_descriptor = 3, memory_descriptor = 4, life_descriptor = 5, log_descriptor = 6 };

/// How far a call of a lane has come. The host asks, the process answers.
enum class Turn : std::uint32_t { idle, asked, answered };

/// What is asked of a lane.
enum class Batch : std::uint32_t { evaluate = 1, distance };

/// An array within a lane: bytes from its start; or one value for all elements; or none.
struct Column {
  enum Kind : std::uint32_t { none, one, each };
  Kind kind = none;
  std::uint32_t offset = 0;
};

/// The members of burin_batch from `t` on and those of burin_outputs from `along` on are arrays that are
/// alike.
inline constexpr std::size_t batch_arrays =
    (sizeof(burin_batch) - offsetof(burin_batch, t)) / sizeof(burin_floats);
inline constexpr std::size_t output_arrays =
    (sizeof(burin_outputs) - offsetof(burin_outputs, along)) / sizeof(burin_floats_out);
static_assert(offsetof(burin_batch, t) + batch_arrays * sizeof(burin_floats) == sizeof(burin_batch));
static_assert(offsetof(burin_outputs, along) + output_arrays * sizeof(burin_floats_out) ==
              sizeof(burin_outputs));
static_assert(sizeof(burin_floats) == sizeof(burin_floats_out) &&
              sizeof(burin_floats) == sizeof(burin_indices) && sizeof(float) == sizeof(std::uint32_t));

/// Number and colour of a parameter.
inline constexpr std::size_t param_arrays = 5;

/// A call of a lane, at its start; its columns follow: those of the parameters, then what they refer to.
struct LaneCall {
  std::atomic<Turn> turn;
  Batch what;
  std::uint32_t stroke, count, param_count;
  burin_status status;  ///< the answer
  char text[text_bytes];
  burin_stroke_context context;
  std::array<Column, batch_arrays> inputs;
  std::array<Column, output_arrays> outputs;
  Column height, distance;
};
static_assert(std::atomic<Turn>::is_always_lock_free);

/// Where a crash, an exit or a call that takes too long was, as its signal handler tells. The names come
/// last, since to find them may crash again.
struct CrashRecord {
  std::atomic<std::uint32_t> claimed;  ///< by the first thread that fails
  std::atomic<std::uint32_t> told;     ///< 1: all but a readable name of the function, 2: that too
  std::int32_t signal;                 ///< 0: exit()
  std::int32_t code;                   ///< si_code, or the status of exit()
  std::uint64_t address;               ///< that was accessed, of signals that have one
  char place[256];                     ///< "brush.burin+0x1139"; may be empty
  char function[256];                  ///< may be empty
  char readable[256];                  ///< of the function; may be empty
};

/// The start of the memory.
struct SharedHeader {
  std::uint32_t lanes;                              ///< set by the host
  std::atomic<std::uint32_t> logged;                ///< lines that were written to the log
  std::uint64_t memory;                             ///< Isolation::memory, set by the host
  std::array<std::int32_t, most_lanes> processors;  ///< where the threads of lanes run, set by the host
  CrashRecord crash;
};

inline constexpr std::size_t header_bytes = 4096;
static_assert(sizeof(SharedHeader) <= header_bytes && sizeof(LaneCall) < lane_bytes / 4);

constexpr std::size_t shared_bytes(std::size_t lanes) { return header_bytes + lanes * lane_bytes; }

/// Waits while the turn is `while_it_is`, at most this time; may return earlier.
void wait_on(std::atomic<Turn>& turn, Turn while_it_is, std::uint64_t nanoseconds);

/// Sets the turn and wakes the other side.
void pass_turn(std::atomic<Turn>& turn, Turn next);

}  // namespace burin::isolate
