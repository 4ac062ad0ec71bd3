// Creates a temporary file exclusively, and renames it over the target.
#include <burin/base/error.h>
#include <burin/base/scratch_file.h>
#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <random>

namespace burin {
namespace fs = std::filesystem;

namespace {

/// A short name, so that the longest file name that the system allows can be the target.
std::string random_name() {
  std::random_device random;
  return fmt::format(".burin-{:08x}{:08x}.partial", random(), random());
}

}  // namespace

ScratchFile::ScratchFile(fs::path target, fs::path shown)
    : target_(std::move(target)), shown_(std::move(shown)) {
  for (;;) {
    path_ = target_.parent_path() / random_name();
    // Mode "x" fails if a file of this name exists.
    if (std::FILE* made = std::fopen(path_.string().c_str(), "wbx")) {
      std::fclose(made);
      break;
    }
    if (errno != EEXIST) throw FileError(shown_.string(), std::strerror(errno));
  }
  std::error_code error;
  const fs::file_status before = fs::status(target_, error);
  if (fs::is_regular_file(before))
    fs::permissions(path_, before.permissions() | fs::perms::owner_write, error);
}

ScratchFile::~ScratchFile() {
  std::error_code ignored;
  if (!path_.empty()) fs::remove(path_, ignored);
}

void ScratchFile::replace_target() {
  std::error_code error;
  const fs::file_status before = fs::status(target_, error);
  if (fs::is_regular_file(before)) fs::permissions(path_, before.permissions(), error);
  fs::rename(path_, target_, error);
  if (error) throw FileError(shown_.string(), error.message());
  path_.clear();
}

}  // namespace burin
