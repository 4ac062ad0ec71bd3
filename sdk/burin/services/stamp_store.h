#pragma once
#include <burin/services/handle_store.h>
#include <burin/stamp/files/stamp_file.h>
#include <burin/stamp/mip_pyramid.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <utility>

namespace burin {

/// Owns the open stamps, each with its mip pyramid (4/3 of the texels), and maps handles to them, as
/// HandleStore does. A file that is opened several times with the same options is held once.
class StampStore {
 public:
  /// The result of open().
  struct Opened {
    std::uint64_t handle = 0;  ///< never 0
    std::size_t filled = 0;    ///< number of values that were not finite; 0 if the file was open already
  };

  /// Opens a file. Throws the errors of read_stamp(), and Error if `capacity` stamps are open already.
  Opened open(const std::filesystem::path& path, const StampOptions& options = {});

  /// Adds an image that is not from a file, and returns its handle, never 0. Throws Error if `capacity`
  /// stamps are open already.
  std::uint64_t add(StampImage image);

  /// Closes a handle that open() or add() returned. Ignores a handle that is not open.
  void close(std::uint64_t handle) { stamps_.close(handle); }

  /// The pyramid of a stamp, or null for a handle that is not open.
  const MipPyramid* find(std::uint64_t handle) const { return stamps_.find(handle); }

 private:
  using Stamps = HandleStore<std::pair<std::filesystem::path, StampOptions>, MipPyramid>;  ///< canonical path
  Stamps stamps_{"stamps"};

 public:
  static constexpr std::size_t capacity = Stamps::capacity;
};

}  // namespace burin
