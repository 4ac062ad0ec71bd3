#pragma once
#include <burin/stamp/stamp_image.h>

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <mutex>

namespace burin {

/// Stamp images by handle. A file that is opened several times is held once, until its last close.
/// Any thread; find takes no lock, but must not run beside the close of the same handle.
class StampStore {
 public:
  /// Handle of the file's image, never 0. Throws FileError as read_stamp, Error when `capacity` files are
  /// open already.
  std::uint64_t open(const std::filesystem::path& path);

  /// Gives back what open returned. A handle that is not open is ignored.
  void close(std::uint64_t handle);

  /// Null for a handle that is not open.
  const StampImage* find(std::uint64_t handle) const;

  static constexpr std::size_t capacity = 256;

 private:
  struct Slot {
    std::atomic<std::uint64_t> handle{0};  ///< 0 = free; else times used * capacity + index of the slot
    std::filesystem::path path;            ///< canonical
    std::size_t users = 0;
    StampImage image;
  };
  Slot* slot_of(const std::filesystem::path& path);
  Slot& free_slot();

  std::mutex mutex_;
  std::array<Slot, capacity> slots_;
  std::uint64_t uses_ = 0;
};

}  // namespace burin
