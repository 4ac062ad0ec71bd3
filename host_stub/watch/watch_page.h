#pragma once
#include <burin/stamp/files/picture.h>

#include <cstdint>
#include <string>

namespace burin {

/// A stroke that was drawn by a version of a module.
struct WatchedStroke {
  std::string brush;                ///< its id
  double seconds = 0;               ///< wall time of all its events
  double nanoseconds_per_node = 0;  ///< of the brush, inputs included
  std::uint64_t hash = 0;           ///< of the surface after it
  Picture picture;                  ///< empty if nobody asked for one
};

/// "0.123 s, 45 ns a node, hash 0123456789abcdef".
std::string stroke_text(const WatchedStroke& stroke);

/// Writes watch_before.png, watch_after.png and watch.html, which shows them side by side and reads itself
/// anew every second, to an existing folder. Throws FileError.
void write_watch_page(const std::string& folder, const WatchedStroke& before, const WatchedStroke& after);

}  // namespace burin
