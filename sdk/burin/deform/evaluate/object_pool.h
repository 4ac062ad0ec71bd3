#pragma once
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace burin {

/// Unused objects that calls of a brush take while they run, such as batches. They are not thread-local,
/// since a brush that runs parallel loops of its own may make a thread start a second call in the middle of
/// the first. Any thread, concurrent.
template <class Object>
class ObjectPool {
 public:
  std::unique_ptr<Object> take() {
    const std::lock_guard lock(mutex_);
    if (free_.empty()) return std::make_unique<Object>();
    std::unique_ptr<Object> object = std::move(free_.back());
    free_.pop_back();
    return object;
  }

  void give_back(std::unique_ptr<Object> object) {
    const std::lock_guard lock(mutex_);
    free_.push_back(std::move(object));
  }

 private:
  std::mutex mutex_;
  std::vector<std::unique_ptr<Object>> free_;
};

}  // namespace burin
