#pragma once
#include <burin/base/error.h>
#include <burin/base/task_runner.h>
#include <burin/host/c/burin.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <mutex>

namespace burin::c {

/// Runs tasks on the threads of an application. Within tasks loops are not divided again, so that a pool
/// need not run tasks of tasks.
class LentThreads final : public TaskRunner {
 public:
  LentThreads(burin_run_tasks run_tasks, void* user, std::uint32_t threads)
      : run_(run_tasks), user_(user), threads_(std::max(threads, 1U)) {}

  std::size_t threads() const override { return threads_; }

  void run(std::size_t count, const std::function<void(std::size_t)>& task) const override {
    if (count <= 1) return OneByOne().run(count, task);
    Tasks tasks(task);
    run_(user_, run_one, &tasks, count);
    if (tasks.failure) std::rethrow_exception(tasks.failure);
    if (tasks.done != count) throw Error("the application has not run all tasks");
  }

 private:
  struct Tasks {
    explicit Tasks(const std::function<void(std::size_t)>& one) : task(one) {}

    const std::function<void(std::size_t)>& task;
    std::atomic<std::size_t> done = 0;
    std::mutex failing;
    std::exception_ptr failure;
  };

  static void BURIN_CALL run_one(void* all, std::uint64_t number) {
    auto& tasks = *static_cast<Tasks*>(all);
    try {
      run_undivided(tasks.task, number);
    } catch (...) {
      const std::lock_guard lock(tasks.failing);
      tasks.failure = std::current_exception();
    }
    ++tasks.done;
  }

  burin_run_tasks run_;
  void* user_;
  std::size_t threads_;
};

}  // namespace burin::c
