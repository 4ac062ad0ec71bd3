#include <burin/base/file.h>
#include <burin/stamp/files/stamp_file.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>

#include "support/process.h"
#include "support/processors.h"
#include "support/shared_data.h"

namespace burin {
namespace {

namespace fs = std::filesystem;

const fs::path committed = BURIN_SAMPLES;

/// The output of the generator, written once for all tests of this process.
const fs::path& generated() {
  static const test::TemporaryFolder folder;
  static const int status = std::system((BURIN_SAMPLE_GENERATOR " '" + folder.path().string() + "'").c_str());
  EXPECT_EQ(status, 0);
  return folder.path();
}

/// The sample files of a folder by relative path.
std::map<std::string, fs::path> sample_files(const fs::path& root) {
  std::map<std::string, fs::path> files;
  for (const char* kind : {"meshes", "strokes", "recordings", "stamps"})
    for (const auto& entry : fs::recursive_directory_iterator(root / kind))
      if (entry.is_regular_file()) files[fs::relative(entry.path(), root).string()] = entry.path();
  return files;
}

TEST(Generator, WritesTheCommittedFilesAndNoOthers) {
  const auto expected = sample_files(committed), written = sample_files(generated());
  ASSERT_EQ(expected.size(), 31u);
  for (const auto& [name, path] : expected) EXPECT_TRUE(written.contains(name)) << name;
  EXPECT_EQ(written.size(), expected.size());
}

TEST(Generator, WritesTheCommittedText) {
  for (const auto& [name, path] : sample_files(committed)) {
    if (path.extension() == ".exr") continue;
    EXPECT_TRUE(read_file(path) == read_file(generated() / name)) << name << " differs";
  }
}

TEST(Generator, WritesTheCommittedTexels) {
  int compared = 0;
  for (const auto& [name, path] : sample_files(committed)) {
    if (path.extension() != ".exr") continue;
    const StampImage expected = read_stamp(path), written = read_stamp(generated() / name);
    EXPECT_EQ(written.width, expected.width) << name;
    EXPECT_EQ(written.channels, expected.channels) << name;
    EXPECT_TRUE(written.texels == expected.texels) << name;
    ++compared;
  }
  EXPECT_EQ(compared, 5);
}

/// Files of text and texels alike: the same program writes them, so their headers agree too.
TEST(Generator, WritesTheSameFilesOnEveryProcessor) {
  for (const test::Processor& processor : test::processors()) {
    test::TemporaryFolder folder;
    const auto run = test::run_process(processor.command({BURIN_SAMPLE_GENERATOR, folder.path().string()}),
                                       processor.environment);
    ASSERT_EQ(run.exit_code, 0) << processor.name << ": " << run.err;
    for (const auto& [name, path] : sample_files(generated()))
      EXPECT_TRUE(read_file(path) == read_file(folder.path() / name)) << processor.name << ": " << name;
  }
}

TEST(Generator, KeepsTheSamplesSmall) {
  std::uintmax_t bytes = 0;
  for (const auto& [name, path] : sample_files(committed)) bytes += fs::file_size(path);
  EXPECT_LT(bytes, 1'000'000u);
  EXPECT_LT(fs::file_size(committed / "meshes/ewer.obj"), 40'000u);
}

TEST(Generator, RefusesAFolderThatItCannotMake) {
  test::TemporaryFolder folder;
  write_file_whole(folder.path() / "file", [](std::ostream& out) { out << "in the way"; });
  const std::string command =
      BURIN_SAMPLE_GENERATOR " '" + (folder.path() / "file/below").string() + "' 2>/dev/null";
  EXPECT_NE(std::system(command.c_str()), 0);
}

}  // namespace
}  // namespace burin
