#pragma once
#include <burin/host/brush_library.h>
#include <burin/host/plugin/brush_module.h>

#include <memory>

namespace burin::isolate {

/// Opens modules whose code runs in processes of their own. One thread at a time.
class IsolatedModules {
 public:
  virtual ~IsolatedModules() = default;

  /// Throws FileError with the reason if the module cannot be loaded.
  virtual std::shared_ptr<const BrushModule> open(const std::filesystem::path& module) = 0;

  /// Ends the process that has read descriptors; the next open() starts another.
  virtual void rest() = 0;
};

/// Makes them. `log` receives what brushes log, and must outlive the modules' brushes. Throws Error on other
/// systems than Linux.
std::unique_ptr<IsolatedModules> isolated_modules(const Isolation& isolation, BrushLibrary::Log log);

}  // namespace burin::isolate
