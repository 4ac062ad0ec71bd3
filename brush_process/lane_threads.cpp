// The threads that evaluate. They are never joined: the process ends with them.
#include "lane_threads.h"

#include <sched.h>
#include <unistd.h>

#include <future>
#include <thread>

#include "crash_handler.h"

namespace burin::process {
namespace {

using isolate::LaneCall;
using isolate::Turn;

/// The calling thread runs on this processor only. Without effect if the system does not allow it.
void run_on(int processor) {
  cpu_set_t here;
  CPU_ZERO(&here);
  CPU_SET(static_cast<std::size_t>(processor), &here);
  sched_setaffinity(0, sizeof here, &here);
}

void serve(std::byte* lane, ServedBrush& brush) {
  auto& call = *reinterpret_cast<LaneCall*>(lane);
  while (true) {
    constexpr std::uint64_t long_time = 1'000'000'000;
    for (Turn turn = call.turn; turn != Turn::asked; turn = call.turn)
      isolate::wait_on(call.turn, turn, long_time);
    brush.answer(lane);
    isolate::pass_turn(call.turn, Turn::answered);
  }
}

}  // namespace

std::vector<pid_t> start_lane_threads(std::byte* memory, ServedBrush& brush) {
  const auto& header = *reinterpret_cast<const isolate::SharedHeader*>(memory);
  std::vector<pid_t> numbers;
  for (std::size_t i = 0; i < header.lanes; ++i) {
    std::promise<pid_t> number;
    std::thread([&number, lane = memory + isolate::header_bytes + i * isolate::lane_bytes, &brush,
                 processor = header.processors[i]] {
      use_handler_stack();
      run_on(processor);
      number.set_value(gettid());
      serve(lane, brush);
    }).detach();
    numbers.push_back(number.get_future().get());
  }
  return numbers;
}

}  // namespace burin::process
