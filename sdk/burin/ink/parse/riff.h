#pragma once
#include <burin/ink/parse/byte_reader.h>

#include <filesystem>
#include <string_view>

namespace burin {

/// Whether a file is a RIFF of this form, four letters.
bool is_riff(std::string_view bytes, std::string_view form);

/// A chunk of a RIFF file.
struct RiffChunk {
  std::string_view name;  ///< four letters
  ByteReader content;
};

/// The chunks of a RIFF file, which is_riff() has recognised.
class RiffChunks {
 public:
  RiffChunks(std::string_view bytes, const std::filesystem::path& path);
  bool empty() const { return rest_.empty(); }
  /// Throws FileError for one that reaches beyond the file.
  RiffChunk next();

 private:
  ByteReader rest_;
};

}  // namespace burin
