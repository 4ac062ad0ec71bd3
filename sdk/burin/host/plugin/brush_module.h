#pragma once
#include <burin/abi/plugin.h>

#include <filesystem>
#include <span>

namespace burin {

/// Whether all functions of a brush are there.
inline bool is_whole(const burin_brush& brush) {
  return BURIN_HAS(&brush, burin_brush, end) && brush.destroy && brush.get_extension && brush.begin &&
         brush.evaluate && brush.end;
}

/// A module whose brushes can be created. All functions are to be called on the main thread.
class BrushModule {
 public:
  BrushModule() = default;
  BrushModule(const BrushModule&) = delete;
  BrushModule& operator=(const BrushModule&) = delete;
  virtual ~BrushModule() = default;

  virtual const std::filesystem::path& path() const = 0;

  /// Whether its brushes are in the application's own code, so that path() is a name and no file.
  virtual bool is_of_application() const { return false; }

  /// Checked descriptors, valid as long as the object.
  virtual std::span<const burin_brush_descriptor* const> brushes() const = 0;

  /// Creates one of its brushes, as burin_brush_factory.create. In a process of its own the brush has that
  /// process's services instead of the host's.
  virtual const burin_brush* create(const burin_host* host, const char* brush_id,
                                    burin_text* error) const = 0;
};

}  // namespace burin
