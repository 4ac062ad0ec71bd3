#pragma once
#include <sys/mman.h>

#include <new>
#include <type_traits>

#include "validate/probe/check.h"

namespace burin::validate {

/// A value in memory that this process shares with the copies that it forks. What a copy writes is seen here,
/// even if the copy may make no system calls any more.
template <class Value>
class Shared {
  static_assert(std::is_trivially_destructible_v<Value>);

 public:
  Shared()
      : memory_(mmap(nullptr, sizeof(Value), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0)) {
    require(memory_ != MAP_FAILED, "no memory can be shared with another process");
    value_ = new (memory_) Value{};
  }
  Shared(const Shared&) = delete;
  Shared& operator=(const Shared&) = delete;
  ~Shared() { munmap(memory_, sizeof(Value)); }

  [[nodiscard]] Value& operator*() const { return *value_; }
  [[nodiscard]] Value* operator->() const { return value_; }

 private:
  void* memory_;
  Value* value_ = nullptr;
};

}  // namespace burin::validate
