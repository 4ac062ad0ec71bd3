// Stores stamps in a fixed array of slots, so that handles can be looked up without a lock. A handle contains
// the number of the slot's use, so a closed handle is never mistaken for a new one.
#include <burin/base/error.h>
#include <burin/services/stamp_store.h>
#include <fmt/format.h>

#include <system_error>
#include <utility>

namespace burin {

StampStore::Opened StampStore::open(const std::filesystem::path& path, const StampOptions& options) {
  const std::lock_guard lock(mutex_);
  std::error_code unknown;  // ignored, since read_stamp() reports what is wrong with the path
  const std::filesystem::path canonical = std::filesystem::weakly_canonical(path, unknown);
  if (Slot* slot = slot_of(canonical, options)) {
    ++slot->users;
    return {slot->handle};
  }
  Slot& slot = free_slot();
  StampFile file;
  slot.pyramid = make_mip_pyramid(read_stamp(path, options, &file));
  slot.path = canonical;
  slot.options = options;
  return {publish(slot), file.not_finite};
}

std::uint64_t StampStore::add(StampImage image) {
  const std::lock_guard lock(mutex_);
  Slot& slot = free_slot();
  slot.pyramid = make_mip_pyramid(std::move(image));
  slot.path.clear();
  return publish(slot);
}

void StampStore::close(std::uint64_t handle) {
  const std::lock_guard lock(mutex_);
  Slot& slot = slots_[handle % capacity];
  if (handle == 0 || slot.handle != handle || --slot.users > 0) return;
  slot.handle = 0;
  slot.pyramid = {};
}

const MipPyramid* StampStore::find(std::uint64_t handle) const {
  const Slot& slot = slots_[handle % capacity];
  const bool open = handle != 0 && slot.handle.load(std::memory_order_acquire) == handle;
  return open ? &slot.pyramid : nullptr;
}

StampStore::Slot* StampStore::slot_of(const std::filesystem::path& path, const StampOptions& options) {
  if (path.empty()) return nullptr;
  for (Slot& slot : slots_)
    if (slot.handle != 0 && slot.path == path && slot.options == options) return &slot;
  return nullptr;
}

StampStore::Slot& StampStore::free_slot() {
  for (Slot& slot : slots_)
    if (slot.handle == 0) return slot;
  throw Error(fmt::format("more than {} stamps open at once", capacity));
}

std::uint64_t StampStore::publish(Slot& slot) {
  slot.users = 1;
  const auto index = static_cast<std::uint64_t>(&slot - slots_.data());
  slot.handle.store(++uses_ * capacity + index, std::memory_order_release);
  return slot.handle;
}

}  // namespace burin
