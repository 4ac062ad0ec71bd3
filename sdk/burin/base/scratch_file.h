#pragma once
#include <filesystem>

namespace burin {

/// A new empty file that is to replace another: beside it, under a name that no file has, and removed at the
/// end of its life unless it did.
class ScratchFile {
 public:
  /// `target`: what it is to replace, `shown`: the name of that in messages. Who may read the target may read
  /// this, and nobody else. Throws FileError.
  ScratchFile(std::filesystem::path target, std::filesystem::path shown);
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;
  ~ScratchFile();

  const std::filesystem::path& path() const { return path_; }

  /// Takes the target's place, and its mode where there is one. Throws FileError.
  void replace_target();

 private:
  std::filesystem::path target_, shown_, path_;
};

}  // namespace burin
