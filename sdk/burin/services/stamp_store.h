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

/// Stamps by handle, each with its pyramid, 4/3 of its texels. A file that is opened several times with the
/// same options is held once, until its last close. Any thread; find takes no lock, but must not run beside
/// the close of the same handle.
class StampStore {
 public:
  /// What open found out.
  struct Opened {
    std::uint64_t handle;    ///< never 0
    std::size_t filled = 0;  ///< values of the file that were not finite; 0 where it is held already
  };

  /// Throws FileError as read_stamp, Error when `capacity` stamps are open already.
  Opened open(const std::filesystem::path& path, const StampOptions& options = {});

  /// Handle of an image that comes from no file, never 0. Throws Error when `capacity` stamps are open
  /// already.
  std::uint64_t add(StampImage image);

  /// Gives back what open or add returned. A handle that is not open is ignored.
  void close(std::uint64_t handle);

  /// Null for a handle that is not open.
  const MipPyramid* find(std::uint64_t handle) const;

  static constexpr std::size_t capacity = 256;

 private:
  struct Slot {
    std::atomic<std::uint64_t> handle{0};  ///< 0 = free; else times used * capacity + index of the slot
    std::filesystem::path path;            ///< canonical; empty of what comes from no file
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
