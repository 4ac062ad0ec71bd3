#pragma once
#include <burin/base/error.h>
#include <burin/base/file.h>
#include <burin/surface/mesh_file.h>

#include <filesystem>
#include <string>

#include "support/shared_data.h"

namespace burin::test {

/// A file of this content in a folder of its own.
class MeshFile {
 public:
  MeshFile(const std::string& name, const std::string& content) : path_(folder_.path() / name) {
    write_file_whole(path_, [&](std::ostream& out) { out << content; });
  }
  const std::filesystem::path& path() const { return path_; }
  /// The error message of read_mesh(), without the folder.
  std::string message() const {
    try {
      read_mesh(path_);
    } catch (const FileError& error) {
      return std::string(error.what()).substr(folder_.path().string().size() + 1);
    }
    return "no error";
  }

 private:
  test::TemporaryFolder folder_;
  std::filesystem::path path_;
};

}  // namespace burin::test
