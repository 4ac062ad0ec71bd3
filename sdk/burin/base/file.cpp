// Reads whole files, and writes files so that a reader sees the old or the new content, never a part: into a
// temporary file, which a rename then puts in place.
#include <burin/base/error.h>
#include <burin/base/file.h>
#include <burin/base/scratch_file.h>
#include <burin/base/text/quoted_word.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>

namespace burin {
namespace fs = std::filesystem;

namespace {

/// The folder in which Linux shows the open files of processes, pipes and devices included, as symbolic
/// links.
constexpr std::string_view open_files = "/proc/";

/// The path after following symbolic links; its last component need not exist. Links below /proc/ are not
/// followed.
fs::path follow_links(const fs::path& path) {
  constexpr int most_links = 40;
  fs::path at = path;
  std::error_code error;
  for (int i = 0; i < most_links; ++i) {
    if (at.string().starts_with(open_files) || !fs::is_symlink(fs::symlink_status(at, error))) return at;
    const fs::path target = fs::read_symlink(at, error);
    if (error) throw FileError(path.string(), error.message());
    at = at.parent_path() / target;  // operator/ returns the target alone if that is absolute
  }
  throw FileError(path.string(), "too many links");
}

/// Whether the path is a pipe, character device or open file, which is written to instead of being replaced.
/// Throws FileError for folders, block devices and sockets.
bool is_stream(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  switch (status.type()) {
    case fs::file_type::directory:
      throw FileError(path.string(), "is a folder, not a file");
    case fs::file_type::block:
    case fs::file_type::socket:
      throw FileError(path.string(), "is a disk or a socket, not a file");
    case fs::file_type::character:
    case fs::file_type::fifo:
      return true;
    default:
      return path.string().starts_with(open_files);
  }
}

/// `to`: the path to open; `shown`: the path for messages.
void write_stream(const fs::path& to, const fs::path& shown,
                  const std::function<void(std::ostream&)>& write) {
  std::ofstream out(to, std::ios::binary | std::ios::trunc);
  if (!out) throw FileError(shown.string(), std::strerror(errno));
  write(out);
  out.close();
  if (!out) throw FileError(shown.string(), "writing failed");
}

void copy_to_stream(const fs::path& from, const fs::path& to) {
  std::ifstream in(from, std::ios::binary);
  write_stream(to, to, [&](std::ostream& out) { out << in.rdbuf(); });
}

}  // namespace

std::string read_file(const fs::path& path, std::uintmax_t most) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::is_directory(status)) throw FileError(path.string(), "is a folder, not a file");
  if (fs::is_character_file(status) || fs::is_block_file(status))
    throw FileError(path.string(), "is a device, not a file");
  std::ifstream in(path, std::ios::binary);
  if (!in) throw FileError(path.string(), std::strerror(errno));
  std::string bytes;
  if (const std::uintmax_t size = fs::is_regular_file(status) ? fs::file_size(path, error) : 0; size <= most)
    bytes.reserve(size);
  std::array<char, 65536> block{};
  while (in.read(block.data(), block.size()), in.gcount() > 0) {
    bytes.append(block.data(), static_cast<std::size_t>(in.gcount()));
    if (bytes.size() > most)
      throw FileError(path.string(), "holds more than " + std::to_string(most) + " bytes");
  }
  if (in.bad()) throw FileError(path.string(), "reading failed");
  return bytes;
}

void check_output(const fs::path& path) {
  const fs::path target = follow_links(path), folder = fs::absolute(target).parent_path();
  std::error_code error;
  if (!is_stream(target) && !fs::is_directory(folder, error))
    throw FileError(path.string(), "there is no folder " + printable(folder.string()));
}

void replace_file(const fs::path& path, const std::function<void(const fs::path&)>& write) {
  const fs::path target = follow_links(path);
  const bool stream = is_stream(target);
  ScratchFile scratch(stream ? fs::temp_directory_path() / "stream" : target, path);
  write(scratch.path());
  if (stream)
    copy_to_stream(scratch.path(), target);
  else
    scratch.replace_target();
}

void write_file_whole(const fs::path& path, const std::function<void(std::ostream&)>& write) {
  const fs::path target = follow_links(path);
  if (is_stream(target)) return write_stream(target, path, write);
  ScratchFile scratch(target, path);
  write_stream(scratch.path(), path, write);
  scratch.replace_target();
}

}  // namespace burin
