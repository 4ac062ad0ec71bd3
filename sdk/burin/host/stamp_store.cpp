#include <burin/base/error.h>
#include <burin/host/stamp_store.h>
#include <fmt/format.h>

#include <system_error>

namespace burin {

std::uint64_t StampStore::open(const std::filesystem::path& path) {
  const std::lock_guard lock(mutex_);
  std::error_code unknown;  // left to read_stamp to explain
  const std::filesystem::path canonical = std::filesystem::weakly_canonical(path, unknown);
  if (Slot* slot = slot_of(canonical)) {
    ++slot->users;
    return slot->handle;
  }
  Slot& slot = free_slot();
  slot.image = read_stamp(path);
  slot.path = canonical;
  slot.users = 1;
  const auto index = static_cast<std::uint64_t>(&slot - slots_.data());
  slot.handle.store(++uses_ * capacity + index, std::memory_order_release);
  return slot.handle;
}

void StampStore::close(std::uint64_t handle) {
  const std::lock_guard lock(mutex_);
  Slot& slot = slots_[handle % capacity];
  if (handle == 0 || slot.handle != handle || --slot.users > 0) return;
  slot.handle = 0;
  slot.image = {};
}

const StampImage* StampStore::find(std::uint64_t handle) const {
  const Slot& slot = slots_[handle % capacity];
  const bool open = handle != 0 && slot.handle.load(std::memory_order_acquire) == handle;
  return open ? &slot.image : nullptr;
}

StampStore::Slot* StampStore::slot_of(const std::filesystem::path& path) {
  for (Slot& slot : slots_)
    if (slot.handle != 0 && slot.path == path) return &slot;
  return nullptr;
}

StampStore::Slot& StampStore::free_slot() {
  for (Slot& slot : slots_)
    if (slot.handle == 0) return slot;
  throw Error(fmt::format("more than {} stamps open at once", capacity));
}

}  // namespace burin
