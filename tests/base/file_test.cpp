#include <burin/base/error.h>
#include <burin/base/file.h>
#include <gtest/gtest.h>

#include "support/shared_data.h"

namespace burin {
namespace {

TEST(WriteFileWhole, WritesEverything) {
  test::TemporaryFolder folder;
  const auto path = folder.path() / "a.txt";
  write_file_whole(path, [](std::ostream& out) { out << "one\ntwo"; });
  EXPECT_EQ(read_file(path), "one\ntwo");
}

TEST(WriteFileWhole, LeavesTheOldFileWhenWritingThrows) {
  test::TemporaryFolder folder;
  const auto path = folder.path() / "a.txt";
  write_file_whole(path, [](std::ostream& out) { out << "old"; });
  EXPECT_THROW(write_file_whole(path,
                                [](std::ostream& out) {
                                  out << "new";
                                  throw Error("stop");
                                }),
               Error);
  EXPECT_EQ(read_file(path), "old");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST(ReadFile, NamesTheMissingFile) {
  try {
    read_file("/nowhere/at/all.obj");
    FAIL();
  } catch (const FileError& error) {
    EXPECT_STREQ(error.what(), "/nowhere/at/all.obj: No such file or directory");
  }
}

}  // namespace
}  // namespace burin
