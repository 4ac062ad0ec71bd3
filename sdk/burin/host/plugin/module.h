#pragma once
#include <filesystem>

namespace burin {

/// A shared module in memory; its symbols stay private to it. Unloaded at the end of its life.
class Module {
 public:
  /// Throws FileError with the system's reason.
  explicit Module(const std::filesystem::path& path);
  ~Module();
  Module(const Module&) = delete;
  Module& operator=(const Module&) = delete;

  /// Address of an exported object, or null.
  const void* symbol(const char* name) const;

 private:
  void* handle_;
};

}  // namespace burin
