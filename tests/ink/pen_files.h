#pragma once
#include <burin/base/error.h>
#include <burin/base/file.h>
#include <burin/ink/pen_file.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>
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

/// What is stated of a file: its kind, the unit of positions, and counts.
struct StatedCounts {
  const char* file;
  const char* kind;
  const char* unit;
  std::size_t samples, strokes, shortest, longest;
};

inline void expect_counts(const PenFile& file, const StatedCounts& expected) {
  EXPECT_EQ(file.kind, expected.kind);
  EXPECT_EQ(file.unit, expected.unit);
  std::multiset<std::size_t> lengths;
  std::size_t samples = 0;
  for (const PenStroke& stroke : file.strokes) samples += *lengths.insert(stroke.samples.size());
  EXPECT_EQ(samples, expected.samples);
  ASSERT_EQ(lengths.size(), expected.strokes);
  if (lengths.empty()) return;
  EXPECT_EQ(*lengths.begin(), expected.shortest);
  EXPECT_EQ(*lengths.rbegin(), expected.longest);
}

/// The range of a value over samples.
struct Range {
  double least = std::numeric_limits<double>::infinity(), most = -least;
  void extend(double value) {
    least = std::min(least, value);
    most = std::max(most, value);
  }
};

/// Over all samples of strokes that have the field.
template <class Value>
Range range_of(const PenFile& file, bool PenFields::*field, const Value& value) {
  Range range;
  for (const PenStroke& stroke : file.strokes)
    if (stroke.fields.*field)
      for (const Sample& sample : stroke.samples) range.extend(value(sample));
  return range;
}

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
