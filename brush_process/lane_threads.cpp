// The threads that evaluate. They are never joined: the process ends with them.
#include "lane_threads.h"

#include <unistd.h>

#include <future>
#include <thread>

#include "crash_handler.h"

namespace burin::process {
namespace {

using isolate::LaneCall;
using isolate::Turn;

void serve(std::byte* lane, ServedBrush& brush) {
  auto& call = *reinterpret_cast<LaneCall*>(lane);
  while (true) {
    if (!isolate::spin_for(call.turn, Turn::asked)) {
      call.process_sleeps = 1;
      constexpr std::uint64_t long_time = 1'000'000'000;
      for (Turn turn = call.turn; turn != Turn::asked; turn = call.turn)
        isolate::wait_on(call.turn, turn, long_time);
      call.process_sleeps = 0;
    }
    brush.answer(lane);
    isolate::pass_turn(call.turn, Turn::answered, call.host_sleeps);
  }
}

}  // namespace

std::vector<pid_t> start_lane_threads(std::byte* memory, ServedBrush& brush) {
  const auto& header = *reinterpret_cast<const isolate::SharedHeader*>(memory);
  std::vector<pid_t> numbers;
  for (std::size_t i = 0; i < header.lanes; ++i) {
    std::promise<pid_t> number;
    std::thread([&number, lane = memory + isolate::header_bytes + i * isolate::lane_bytes, &brush] {
      use_handler_stack();
      number.set_value(gettid());
      serve(lane, brush);
    }).detach();
    numbers.push_back(number.get_future().get());
  }
  return numbers;
}

}  // namespace burin::process
