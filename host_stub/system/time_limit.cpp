// A thread that waits for the end of the limit, since the others may never return.
#include "system/time_limit.h"

#include <chrono>
#include <cstdlib>

#include "system/console.h"
#include "system/platform.h"

namespace burin {

TimeLimit::TimeLimit(double seconds, std::string line)
    : thread_([this, seconds, text = std::move(line)] { wait(seconds, text); }) {}

TimeLimit::~TimeLimit() {
  {
    const std::lock_guard lock(mutex_);
    over_ = true;
  }
  kept_.notify_one();
  thread_.join();
}

void TimeLimit::wait(double seconds, const std::string& line) {
  std::unique_lock lock(mutex_);
  if (kept_.wait_for(lock, std::chrono::duration<double>(seconds), [this] { return over_; })) return;
  if (is_debugged()) return;
  say("", line);
  // Without destructors, whose objects the hanging threads use.
  std::_Exit(1);
}

}  // namespace burin
