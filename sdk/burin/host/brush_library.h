#pragma once
#include <burin/host/host_extensions.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

/// Types of burin/abi/plugin.h.
struct burin_brush;
struct burin_brush_descriptor;
struct burin_brush_factory;

namespace burin {

class BrushModule;

/// A brush of a loaded module. The descriptor is valid as long as the library, or until its module is loaded
/// anew and no brush of the old one is left.
struct BrushEntry {
  const burin_brush_descriptor* descriptor;
  std::filesystem::path module;  ///< or the name of the application's brushes, see BrushLibrary::add()
};

/// Destroys a brush, and keeps its module loaded until then.
struct BrushDeleter {
  const char* id = nullptr;
  std::shared_ptr<const BrushModule> module;
  void operator()(const burin_brush* brush) const;  ///< destroys the brush
};
using BrushPtr = std::unique_ptr<const burin_brush, BrushDeleter>;

/// How a BrushLibrary runs brushes in processes of their own, so that one that crashes, hangs or allocates
/// without end costs a stroke and nothing else. Linux only. docs/isolation.md describes what follows.
///
/// Seconds are of wall-clock time, above 0; infinity waits for ever, as for a debugger.
struct Isolation {
  /// The program that runs a brush, burin-brush-process. Empty: the one beside the file that Burin's code is
  /// in, be it a program or a shared library, else in lib/burin beside its folder, where it is installed.
  std::filesystem::path program = {};

  /// What starting the program, loading a module and creating a brush may take.
  double load_seconds = 20;

  /// What any other call may take that is not made for a batch: begin and end of a stroke, state, curves.
  double call_seconds = 20;

  /// What the evaluation of one batch of at most 1024 nodes may take.
  double batch_seconds = 5;

  /// Address space that a brush may take beyond what its process needs without it, bytes; 0: no bound.
  /// Contents of stamps and fonts count.
  std::uint64_t memory = std::uint64_t{4} << 30;
};

/// The plugin modules of a process and their brushes. All functions are to be called on the main thread.
class BrushLibrary {
 public:
  /// Receives log lines of brushes and of the library; severities are those of abi/ext/log.h. It must not
  /// throw, and it is called on any thread, also on several at once.
  using Log = std::function<void(int severity, std::string_view line)>;

  /// Starts empty. Plugins are given the log, which is discarded if `log` is empty, and these extensions, if
  /// any.
  explicit BrushLibrary(Log log = nullptr, std::unique_ptr<HostExtensions> extensions = nullptr);

  /// Starts empty. No code of plugins ever runs in this process: each brush that is created has a process of
  /// its own, which has Burin's own services (stamps, lettering and, where Burin is built with OpenVDB,
  /// grids) and results of the same bits. A brush that crashes, hangs or takes too much memory makes its
  /// stroke fail as one that reports an error does, with a line that tells where; the next stroke starts
  /// another process. Throws Error on other systems than Linux, and ContractError where a time is not above
  /// 0.
  BrushLibrary(Log log, const Isolation& isolation);
  ~BrushLibrary();
  BrushLibrary(const BrushLibrary&) = delete;
  BrushLibrary& operator=(const BrushLibrary&) = delete;

  /// Loads one module. A module that is loaded already, perhaps by another name of the file, is skipped.
  /// Throws FileError, which gives the file and the reason, if the file is unreadable, does not export the
  /// entry symbol, has another ABI version or an invalid descriptor, or has a brush id that another module
  /// has.
  void load(const std::filesystem::path& module);

  /// Loads all `*.burin` files of a folder, in the order of their names. A module that load() would refuse
  /// causes a warning in the log, and an error only when one of its brushes is requested. A plugin that is
  /// named otherwise, `*.so`, causes a warning, too. Throws FileError if the folder cannot be read.
  void load_folder(const std::filesystem::path& folder);

  /// Loads the folders in the environment variable BURIN_PLUGIN_PATH (separated by colons, on Windows by
  /// semicolons), which must exist, then `own_folder`, which may be missing.
  void load_search_path(const std::filesystem::path& own_folder);

  /// Loads a module that is there anew, from its file as it is now; a copy of it, so that the file may be
  /// overwritten from then on. Sessions draw their next stroke with the new module's brushes, and take over
  /// the state of the old ones (abi/ext/state.h); the old module is unloaded with its last brush. Throws as
  /// load(), and Error if the module was never loaded; then the old one stays. With brushes in processes of
  /// their own there is no copy: a file that is overwritten in place may crash the brush.
  void reload(const std::filesystem::path& module);

  /// Adds brushes that the application itself has, without a module. `name` stands in error messages where
  /// others have the path of their module. If there are brushes of this name the new ones take their place,
  /// as those of a module that is loaded anew; their descriptors must have other addresses. Factories and
  /// descriptors must live until the library and all brushes are destroyed. Throws as load() does, and
  /// FileError for the path of a module; then nothing changes.
  void add(const std::string& name, const burin_brush_factory& factory);

  /// Valid until something is loaded, as are references into it.
  const std::vector<BrushEntry>& brushes() const;

  /// Why modules of folders were passed over, in the order of loading: lines that name the module.
  std::vector<std::string> refused() const;

  /// Finds a brush by its id. Throws Error, which lists the known brushes and the modules that could not be
  /// loaded, if there is none; also if a module that could not be loaded has this id.
  const BrushEntry& find(std::string_view id) const;

  /// Creates an instance of a brush, which must be destroyed before the library. Throws Error if creation
  /// fails, or if the brush reads an input or writes an output that this host does not support. With brushes
  /// in processes of their own this starts the process.
  BrushPtr create(const BrushEntry& entry) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace burin
