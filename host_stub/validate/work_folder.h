#pragma once
#include <cstdint>
#include <filesystem>

#include "validate/probe/check.h"

namespace burin::validate {

/// A folder for the files of checks, with an image for brushes that need a file. Removed at the end.
class WorkFolder {
 public:
  /// Throws FileError.
  WorkFolder();
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;
  ~WorkFolder();

  std::filesystem::path stamp() const { return path_ / "stamp.png"; }

  /// Adds a solid for brushes that take no image. In a process of its own, whose threads end with it: those
  /// that are copied later must have none. Throws Error.
  void add_solid() const;

  /// A module with this folder and its files.
  Subject subject(const std::filesystem::path& module, std::uint64_t seed) const;

 private:
  std::filesystem::path path_;
};

}  // namespace burin::validate
