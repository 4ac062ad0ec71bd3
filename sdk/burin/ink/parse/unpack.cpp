// Unpacks gzip, xz and zip by libarchive.
#include <archive.h>
#include <archive_entry.h>
#include <burin/base/error.h>
#include <burin/base/file.h>
#include <burin/ink/parse/unpack.h>
#include <fmt/format.h>

#include <array>
#include <fstream>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

namespace burin {
namespace {

/// Reads a packed file in memory.
class Archive {
 public:
  Archive(const std::filesystem::path& path, std::string_view bytes) : path_(path) {
    archive_read_support_filter_gzip(archive_.get());
    archive_read_support_filter_xz(archive_.get());
    archive_read_support_format_zip(archive_.get());
    archive_read_support_format_raw(archive_.get());
    expect_ok(archive_read_open_memory(archive_.get(), bytes.data(), bytes.size()));
  }

  /// Goes to the only content, or to the first member of a zip whose name is one that `fits`. Returns false
  /// if there is none.
  template <class Fits>
  bool find_content(const Fits& fits) {
    archive_entry* entry = nullptr;
    for (;;) {
      const int result = archive_read_next_header(archive_.get(), &entry);
      if (result == ARCHIVE_EOF) return false;
      expect_ok(result);
      const char* name = archive_entry_pathname(entry);
      const bool zip = (archive_format(archive_.get()) & ARCHIVE_FORMAT_BASE_MASK) == ARCHIVE_FORMAT_ZIP;
      if (zip && !(name && fits(std::string_view(name)))) continue;
      name_ = zip ? name : "";
      return true;
    }
  }

  /// The name of the member of a zip that find_content() found last.
  const std::string& name() const { return name_; }

  /// Calls `take` with the content, block by block, and adds its bytes to `unpacked`.
  template <class Take>
  void read_content(std::size_t& unpacked, const Take& take) {
    std::array<char, 1 << 16> block{};
    for (;;) {
      const la_ssize_t got = archive_read_data(archive_.get(), block.data(), block.size());
      if (got < 0) fail();
      if (got == 0) return;
      unpacked += static_cast<std::size_t>(got);
      // Of the bytes so far, so that what unpacks to too much is found before all of it is unpacked.
      const auto taken = static_cast<std::size_t>(archive_filter_bytes(archive_.get(), -1));
      if (const std::size_t most = most_unpacked_bytes(taken); unpacked > most)
        throw FileError(path_.string(), fmt::format("unpacks to more than {} MB", most / 1'000'000));
      take(std::string_view(block.data(), static_cast<std::size_t>(got)));
    }
  }

 private:
  void expect_ok(int result) {
    if (result < ARCHIVE_WARN) fail();
  }
  [[noreturn]] void fail() {
    const char* what = archive_error_string(archive_.get());
    throw FileError(path_.string(), fmt::format("cannot be unpacked: {}", what ? what : "damaged"));
  }

  std::filesystem::path path_;
  std::string name_;
  std::unique_ptr<archive, int (*)(archive*)> archive_{archive_read_new(), archive_read_free};
};

/// Whether a member of a zip is a list of paths of WILL, of which documents have one for each page or layer.
bool holds_paths(std::string_view name) { return name.ends_with(".protobuf"); }

/// Whether a member of a zip is what holds the strokes: of Xournal++, of WILL, of a folder of Tilt Brush.
bool holds_strokes(std::string_view name) {
  return name == "content.xml" || name.ends_with(".will") || holds_paths(name) ||
         name.ends_with(sketch_member);
}

/// Calls `take` with the blocks of the members that `fit`: the first one, and all lists of paths of WILL,
/// which make one list when they stand one behind the other. Returns their bytes, or nothing if no member
/// fits.
template <class Fits, class Take>
std::optional<std::size_t> read_members(const std::filesystem::path& path, std::string_view bytes,
                                        const Fits& fits, const Take& take) {
  Archive archive(path, bytes);
  if (!archive.find_content(fits)) return std::nullopt;
  std::size_t unpacked = 0;
  archive.read_content(unpacked, take);
  while (holds_paths(archive.name()) && archive.find_content(holds_paths))
    archive.read_content(unpacked, take);
  return unpacked;
}

/// The members that `fit`. They are unpacked twice, the first time without being kept: what unpacks to too
/// much is refused before it takes memory.
template <class Fits>
std::optional<std::string> unpacked_members(const std::filesystem::path& path, std::string_view bytes,
                                            const Fits& fits) {
  const auto size = read_members(path, bytes, fits, [](std::string_view) {});
  if (!size) return std::nullopt;
  std::string text;
  text.reserve(*size);
  read_members(path, bytes, fits, [&](std::string_view block) { text += block; });
  return text;
}

/// Refuses XML, JSON and UTF-16 that are too long, by their first character.
void check_length(const std::filesystem::path& path) {
  std::error_code none;
  if (!std::filesystem::is_regular_file(path, none)) return;
  if (std::filesystem::file_size(path, none) <= most_parsed_bytes || none) return;
  constexpr int byte_order_mark = 0xEF, mark_bytes = 3;
  std::ifstream in(path);
  const int first_byte = in.peek();
  if (first_byte == byte_order_mark) in.ignore(mark_bytes);
  char first = 0;
  in >> first;
  const bool utf16 = first_byte == 0xFE || first_byte == 0xFF;
  if (utf16 || first == '<' || first == '{' || first == '[')
    throw FileError(path.string(), first == '{' || first == '['
                                       ? "more than 60 MB of JSON that cannot be read stroke by stroke"
                                       : "more than 60 MB of XML or UTF-16");
}

}  // namespace

bool is_packed(std::string_view bytes) {
  return bytes.starts_with("\x1f\x8b") || bytes.starts_with(std::string_view("\xfd\x37zXZ\0", 6)) ||
         bytes.starts_with("PK\x03\x04");
}

std::string zip_member(const std::filesystem::path& path, std::string_view bytes, std::string_view name) {
  auto member = unpacked_members(path, bytes, [&](std::string_view one) { return one == name; });
  if (!is_packed(bytes) || !member) throw FileError(path.string(), fmt::format("a zip without {}", name));
  return std::move(*member);
}

std::string unpacked_pen_file(const std::filesystem::path& path) {
  std::error_code none;
  if (const auto member = path / sketch_member; std::filesystem::is_regular_file(member, none))
    return read_file(member);
  check_length(path);
  std::string bytes = read_file(path);
  if (!is_packed(bytes)) return bytes;
  auto text = unpacked_members(path, bytes, holds_strokes);
  if (!text) throw FileError(path.string(), "a zip without content.xml, .will, .protobuf or data.sketch");
  return std::move(*text);
}

}  // namespace burin
