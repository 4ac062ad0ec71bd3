#pragma once
#include <burin/base/error.h>
#include <burin/base/file.h>
#include <burin/ink/pen_file.h>
#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "support/shared_data.h"

namespace burin::test {

/// Writes texts as files and reads them as pen files.
class PenFileFolder {
 public:
  std::filesystem::path write(const std::string& name, std::string_view text) const {
    const std::filesystem::path path = folder_.path() / name;
    write_file_whole(path, [&](std::ostream& out) { out << text; });
    return path;
  }

  PenFile read(std::string_view text) const { return read_pen_file(write("file", text)); }

  /// The message for a text, without the path of the file, or "accepted".
  std::string complaint(std::string_view text) const {
    const std::filesystem::path path = write("file", text);
    try {
      read_pen_file(path);
    } catch (const FileError& error) {
      const std::string message = error.what();
      EXPECT_TRUE(message.starts_with(path.string() + ":")) << message;
      EXPECT_EQ(message.find('\n'), message.npos) << message;
      return message.substr(path.string().size() + 1);
    }
    return "accepted";
  }

 private:
  TemporaryFolder folder_;
};

/// Positions of a stroke as text, "1 2, 3 4".
inline std::string places(const PenStroke& stroke) {
  std::string text;
  for (const Sample& sample : stroke.samples) {
    char one[100];
    std::snprintf(one, sizeof one, "%s%g %g", text.empty() ? "" : ", ", sample.position.x(),
                  sample.position.y());
    text += one;
  }
  return text;
}

}  // namespace burin::test
