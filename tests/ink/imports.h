#pragma once
#include <burin/base/error.h>
#include <burin/base/file.h>
#include <burin/ink/import_pen_file.h>
#include <burin/stroke/stroke_file.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "stroke/recordings.h"
#include "support/shared_data.h"

namespace burin::test {

inline Camera import_camera(int width, int height) {
  Camera camera;
  camera.view.topRightCorner<3, 1>() << 0.1, -1 / 3.0, -4;
  camera.width = width;
  camera.height = height;
  return camera;
}

/// A file of this kind, in front of a camera that sees no surface.
inline Import imported(const std::filesystem::path& path, std::string_view kind, const Camera& camera) {
  return import_pen_file(path, read_pen_file(open_pen_file(path), kind), {}, camera, Surface());
}

/// All strokes together touch two opposite margins of 10 % and keep clear of the other two evenly.
inline void expect_fits(const Recording& recording) {
  Eigen::Array2d low(1e9, 1e9), high(-1e9, -1e9);
  for (const RecordedStroke& stroke : recording.strokes)
    for (const Sample& sample : stroke.samples) {
      low = low.min(sample.position.head<2>().array());
      high = high.max(sample.position.head<2>().array());
    }
  const Eigen::Array2d viewport(recording.camera->width, recording.camera->height);
  EXPECT_LT((low + high - viewport).abs().maxCoeff(), 1e-9);
  EXPECT_NEAR((low / viewport).minCoeff(), 0.1, 1e-12);
}

/// Written as a `.stroke` file and read back, a recording is the same to the last bit.
inline void expect_survives_a_file(const Recording& recording) {
  TemporaryFolder folder;
  const auto path = folder.path() / "imported.stroke";
  {
    StrokeWriter writer(path, recording.space, recording.camera);
    for (const RecordedStroke& stroke : recording.strokes) {
      writer.begin(stroke);
      for (const Sample& sample : stroke.samples) writer.add(sample);
      writer.end();
    }
  }
  EXPECT_TRUE(same_bits(read_strokes(path), recording));
}

/// Imports texts as if they were files of one kind.
class ImportedText : public ::testing::Test {
 protected:
  explicit ImportedText(std::string_view kind) : kind_(kind) {}

  Import whole_import(const std::string& text) {
    write_file_whole(path_, [&](std::ostream& out) { out << text; });
    return imported(path_, kind_, import_camera(100, 100));
  }
  Recording import(const std::string& text) { return whole_import(text).recording; }

  /// The error message for a text, without the name of the file.
  std::string complaint(const std::string& text) {
    try {
      import(text);
    } catch (const FileError& error) {
      return std::string(error.what()).substr(path_.string().size() + 1);
    }
    return "accepted";
  }

  TemporaryFolder folder_;
  const std::string_view kind_;
  const std::filesystem::path path_ = folder_.path() / "recording";
};

}  // namespace burin::test
