#include <burin/base/error.h>
#include <burin/base/file.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

namespace burin {
namespace fs = std::filesystem;

namespace {

/// Removes the file at the end of its life unless told to keep it.
class Scratch {
 public:
  explicit Scratch(fs::path path) : path_(std::move(path)) {}
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  ~Scratch() {
    std::error_code ignored;
    if (!kept_) fs::remove(path_, ignored);
  }
  const fs::path& path() const { return path_; }
  void keep() { kept_ = true; }

 private:
  fs::path path_;
  bool kept_ = false;
};

}  // namespace

std::string read_file(const fs::path& path) {
  std::error_code error;
  if (fs::is_directory(path, error)) throw FileError(path.string(), "is a folder, not a file");
  std::ifstream in(path, std::ios::binary);
  if (!in) throw FileError(path.string(), std::strerror(errno));
  std::ostringstream bytes;
  bytes << in.rdbuf();
  if (in.bad()) throw FileError(path.string(), "reading failed");
  return std::move(bytes).str();
}

void replace_file(const fs::path& path, const std::function<void(const fs::path&)>& write) {
  Scratch scratch(path.string() + ".partial");
  write(scratch.path());
  std::error_code error;
  fs::rename(scratch.path(), path, error);
  if (error) throw FileError(path.string(), error.message());
  scratch.keep();
}

void write_file_whole(const fs::path& path, const std::function<void(std::ostream&)>& write) {
  replace_file(path, [&](const fs::path& partial) {
    std::ofstream out(partial, std::ios::binary | std::ios::trunc);
    if (!out) throw FileError(path.string(), std::strerror(errno));
    write(out);
    out.close();
    if (!out) throw FileError(path.string(), "writing failed");
  });
}

}  // namespace burin
