#pragma once
#include <cstddef>
#include <functional>

namespace burin {

/// Runs tasks that are independent of each other, for parallel loops in place of oneTBB: on threads that an
/// application lends.
class TaskRunner {
 public:
  virtual ~TaskRunner() = default;

  /// How many threads it has; a hint.
  virtual std::size_t threads() const = 0;

  /// Calls task(i) for all i below `count`, on any threads and in any order; returns when all are done.
  /// Rethrows one of the exceptions thrown.
  virtual void run(std::size_t count, const std::function<void(std::size_t)>& task) const = 0;

  /// That of the loops which this thread starts now; null: oneTBB.
  static const TaskRunner* current() { return current_; }

 private:
  friend class TaskRunnerScope;
  static inline thread_local const TaskRunner* current_ = nullptr;
};

/// Makes a runner, or null, the current one of this thread during its lifetime.
class TaskRunnerScope {
 public:
  explicit TaskRunnerScope(const TaskRunner* runner) : before_(TaskRunner::current_) {
    TaskRunner::current_ = runner;
  }
  TaskRunnerScope(const TaskRunnerScope&) = delete;
  TaskRunnerScope& operator=(const TaskRunnerScope&) = delete;
  ~TaskRunnerScope() { TaskRunner::current_ = before_; }

 private:
  const TaskRunner* before_;
};

/// Runs tasks one after the other on the thread that calls.
class OneByOne final : public TaskRunner {
 public:
  std::size_t threads() const override { return 1; }
  void run(std::size_t count, const std::function<void(std::size_t)>& task) const override {
    for (std::size_t i = 0; i < count; ++i) task(i);
  }
};

/// Calls task(number), a task on a lent thread, whose own loops are not divided again.
inline void run_undivided(const std::function<void(std::size_t)>& task, std::size_t number) {
  static const OneByOne one_by_one;
  const TaskRunnerScope scope(&one_by_one);
  task(number);
}

}  // namespace burin
