#pragma once
#include <filesystem>

namespace burin {

/// A new empty temporary file that is going to replace another file. It is in the same folder under a random
/// name. The destructor removes it unless replace_target() was called.
class ScratchFile {
 public:
  /// `target`: the file to replace; `shown`: its name in messages. If the target exists, the temporary file
  /// gets its permissions, and the owner's permission to write. Throws FileError.
  ScratchFile(std::filesystem::path target, std::filesystem::path shown);
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;
  ~ScratchFile();

  const std::filesystem::path& path() const { return path_; }

  /// Renames the temporary file to the target and keeps the target's mode, if it exists. Throws FileError.
  void replace_target();

 private:
  std::filesystem::path target_, shown_, path_;
};

}  // namespace burin
