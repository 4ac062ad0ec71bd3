#pragma once
#include <filesystem>

namespace burin {

/// A loaded shared library, whose symbols are not visible to other libraries. The destructor unloads it.
class Module {
 public:
  /// Loads the library. Throws FileError with the system's reason; it names the file, or instead of a copy
  /// the one that is `shown`.
  explicit Module(const std::filesystem::path& path) : Module(path, path) {}
  Module(const std::filesystem::path& path, const std::filesystem::path& shown);
  ~Module();
  Module(const Module&) = delete;
  Module& operator=(const Module&) = delete;

  /// The address of an exported object, or null.
  const void* symbol(const char* name) const;

 private:
  void* handle_;
};

}  // namespace burin
