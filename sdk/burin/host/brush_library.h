#pragma once
#include <burin/host/host_extensions.h>

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

/// Of burin/abi/plugin.h.
struct burin_brush;
struct burin_brush_descriptor;

namespace burin {

/// A brush that a module lists. The descriptor lives as long as the library.
struct BrushEntry {
  const burin_brush_descriptor* descriptor;
  std::filesystem::path module;
};

struct BrushDeleter {
  const char* id = nullptr;
  void operator()(const burin_brush* brush) const;
};
using BrushPtr = std::unique_ptr<const burin_brush, BrushDeleter>;

/// The plugin modules of a process and their brushes. Main thread.
class BrushLibrary {
 public:
  /// Takes the lines that brushes and the library have to say; severities are those of abi/ext/log.h. Must
  /// not throw. Any thread, concurrent.
  using Log = void (*)(int severity, std::string_view line);

  /// Starts empty. Plugins get the log (to `log`, or nowhere) and these extensions; null: none.
  explicit BrushLibrary(Log log = nullptr, std::unique_ptr<HostExtensions> extensions = nullptr);
  ~BrushLibrary();
  BrushLibrary(const BrushLibrary&) = delete;
  BrushLibrary& operator=(const BrushLibrary&) = delete;

  /// Loads one module; once, also by several names. Throws FileError naming the file and what is wrong:
  /// unreadable, no symbol, another version, a descriptor that breaks the contract, a brush id already there.
  void load(const std::filesystem::path& module);

  /// Loads all `*.burin` files of a folder, by name. One that load() would refuse is a warning to the log,
  /// and an error only of who asks for its brushes.
  void load_folder(const std::filesystem::path& folder);

  /// Loads the folders of BURIN_PLUGIN_PATH (colon-separated; semicolons on Windows), then `own_folder`,
  /// which may be missing. A folder that the variable names must exist.
  void load_search_path(const std::filesystem::path& own_folder);

  const std::vector<BrushEntry>& brushes() const;

  /// Throws Error naming the brushes there are when there is none of this id, and the modules that could not
  /// be loaded; or when one of these offers this id, too.
  const BrushEntry& find(std::string_view id) const;

  /// A new instance; it must be gone before the library. Throws Error: creation failed, or the brush reads
  /// an input or writes an output that this host does not offer (named).
  BrushPtr create(const BrushEntry& entry) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace burin
