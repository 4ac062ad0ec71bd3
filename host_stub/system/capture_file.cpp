// Keeps a program's output in a temporary file.
#include "system/capture_file.h"

#include <burin/base/error.h>

#include <array>

namespace burin {

CaptureFile::CaptureFile() : stream_(std::tmpfile()) {
  if (!stream_) throw Error("no temporary file can be made");
}

std::string CaptureFile::text() const {
  std::rewind(stream_.get());
  std::string text;
  std::array<char, 4096> block;
  while (const std::size_t read = std::fread(block.data(), 1, block.size(), stream_.get()))
    text.append(block.data(), read);
  return text;
}

}  // namespace burin
