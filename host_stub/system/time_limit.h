#pragma once
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace burin {

/// A time limit for what this process does while the object lives. When it is over the process ends with a
/// line on stderr and exit code 1, unless a debugger watches the process by then.
class TimeLimit {
 public:
  TimeLimit(double seconds, std::string line);
  TimeLimit(const TimeLimit&) = delete;
  TimeLimit& operator=(const TimeLimit&) = delete;
  ~TimeLimit();

 private:
  void wait(double seconds, const std::string& line);

  std::mutex mutex_;
  std::condition_variable kept_;
  bool over_ = false;  ///< the object's life, guarded by the mutex
  std::thread thread_;
};

}  // namespace burin
