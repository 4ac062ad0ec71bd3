// Futexes on the turns of lanes; see futex(2).
#if defined(__linux__)
#include <burin/host/isolate/shared_memory.h>
#include <linux/futex.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <ctime>

namespace burin::isolate {
namespace {

void futex(std::atomic<Turn>& turn, int operation, std::uint32_t value, const timespec* time) {
  syscall(SYS_futex, &turn, operation, value, time, nullptr, 0);
}

}  // namespace

void wait_on(std::atomic<Turn>& turn, Turn while_it_is, std::uint64_t nanoseconds) {
  const timespec time{static_cast<std::time_t>(nanoseconds / 1000000000),
                      static_cast<long>(nanoseconds % 1000000000)};
  futex(turn, FUTEX_WAIT, static_cast<std::uint32_t>(while_it_is), &time);
}

void pass_turn(std::atomic<Turn>& turn, Turn next) {
  turn.store(next);
  futex(turn, FUTEX_WAKE, 1, nullptr);
}

}  // namespace burin::isolate
#endif
