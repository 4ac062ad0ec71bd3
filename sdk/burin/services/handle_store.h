#pragma once
#include <burin/base/error.h>

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

namespace burin {

/// Owns open values and maps handles to them. A value that is opened several times with an equal key is held
/// once, until its last close. Any thread; find() is lock-free, but must not run concurrently with the close
/// of the same handle. A handle contains the number of its slot's use, so a closed handle is never mistaken
/// for a new one.
template <class Key, class Value>
class HandleStore {
 public:
  static constexpr std::size_t capacity = 256;

  /// `what`: the values, for messages, such as "stamps".
  explicit HandleStore(std::string what) : what_(std::move(what)) {}

  /// Opens the value that make() returns, unless there is one of an equal key. Returns the handle, never 0.
  /// Throws Error if `capacity` values are open already, and what make() throws.
  template <class Make>
  std::uint64_t open(const Key& key, const Make& make) {
    const std::lock_guard lock(mutex_);
    for (Slot& slot : slots_)
      if (slot.handle != 0 && slot.key == key) {
        ++slot.users;
        return slot.handle;
      }
    Slot& slot = free_slot();
    slot.value = make();
    slot.key = key;
    return publish(slot);
  }

  /// Adds a value of its own, likewise.
  std::uint64_t add(Value value) {
    const std::lock_guard lock(mutex_);
    Slot& slot = free_slot();
    slot.value = std::move(value);
    slot.key.reset();
    return publish(slot);
  }

  /// Closes a handle that open() or add() returned. Ignores a handle that is not open.
  void close(std::uint64_t handle) {
    const std::lock_guard lock(mutex_);
    Slot& slot = slots_[handle % capacity];
    if (handle == 0 || slot.handle != handle || --slot.users > 0) return;
    slot.handle = 0;
    slot.value = {};
  }

  /// The value, or null for a handle that is not open.
  const Value* find(std::uint64_t handle) const {
    const Slot& slot = slots_[handle % capacity];
    const bool open = handle != 0 && slot.handle.load(std::memory_order_acquire) == handle;
    return open ? &slot.value : nullptr;
  }

 private:
  struct Slot {
    std::atomic<std::uint64_t> handle{
        0};  ///< 0 = free; else number of the use * capacity + index of the slot
    std::optional<Key> key;
    std::size_t users = 0;
    Value value;
  };

  Slot& free_slot() {
    for (Slot& slot : slots_)
      if (slot.handle == 0) return slot;
    throw Error("more than " + std::to_string(capacity) + " " + what_ + " open at once");
  }

  std::uint64_t publish(Slot& slot) {
    slot.users = 1;
    const auto index = static_cast<std::uint64_t>(&slot - slots_.data());
    slot.handle.store(++uses_ * capacity + index, std::memory_order_release);
    return slot.handle;
  }

  std::string what_;
  std::mutex mutex_;
  std::array<Slot, capacity> slots_;
  std::uint64_t uses_ = 0;
};

}  // namespace burin
