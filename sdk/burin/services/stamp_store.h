#pragma once
#include <burin/stamp/files/stamp_file.h>
#include <burin/stamp/mip_pyramid.h>

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <mutex>

namespace burin {

/// Owns the open stamps, each with its mip pyramid (4/3 of the texels), and maps handles to them. A file that
/// is opened several times with the same options is held once, until its last close. Any thread; find() is
/// lock-free, but must not run concurrently with the close of the same handle.
class StampStore {
 public:
  /// The result of open().
  struct Opened {
    std::uint64_t handle;    ///< never 0
    std::size_t filled = 0;  ///< number of values that were not finite; 0 if the file was open already
  };

  /// Opens a file. Throws the errors of read_stamp(), and Error if `capacity` stamps are open already.
  Opened open(const std::filesystem::path& path, const StampOptions& options = {});

  /// Adds an image that is not from a file, and returns its handle, never 0. Throws Error if `capacity`
  /// stamps are open already.
  std::uint64_t add(StampImage image);

  /// Closes a handle that open() or add() returned. Ignores a handle that is not open.
  void close(std::uint64_t handle);

  /// The pyramid of a stamp, or null for a handle that is not open.
  const MipPyramid* find(std::uint64_t handle) const;

  static constexpr std::size_t capacity = 256;

 private:
  struct Slot {
    std::atomic<std::uint64_t> handle{
        0};                      ///< 0 = free; else number of the use * capacity + index of the slot
    std::filesystem::path path;  ///< canonical path; empty for an image that is not from a file
    StampOptions options;
    std::size_t users = 0;
    MipPyramid pyramid;
  };
  Slot* slot_of(const std::filesystem::path& path, const StampOptions& options);
  Slot& free_slot();
  std::uint64_t publish(Slot& slot);

  std::mutex mutex_;
  std::array<Slot, capacity> slots_;
  std::uint64_t uses_ = 0;
};

}  // namespace burin
