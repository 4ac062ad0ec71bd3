#include <burin/base/error.h>
#include <burin/base/file.h>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <fstream>
#include <thread>

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

namespace fs = std::filesystem;

void write_text(const fs::path& path, const std::string& text) {
  write_file_whole(path, [&](std::ostream& out) { out << text; });
}

/// The error message of writing to the path, without the path.
std::string complaint(const fs::path& path) {
  try {
    write_text(path, "text");
  } catch (const FileError& error) {
    EXPECT_EQ(std::string(error.what()).rfind(path.string(), 0), 0u) << error.what();
    return std::string(error.what()).substr(path.string().size());
  }
  return "written";
}

std::ptrdiff_t count_files(const fs::path& folder) {
  return std::distance(fs::directory_iterator(folder), {});
}

TEST(WriteFileWhole, FollowsLinksAndKeepsThem) {
  const test::TemporaryFolder folder;
  fs::create_directory(folder.path() / "in");
  write_text(folder.path() / "in/file", "old");
  fs::create_symlink("in/file", folder.path() / "link");
  fs::create_symlink("link", folder.path() / "second");
  fs::create_symlink("in/later", folder.path() / "dangling");
  write_text(folder.path() / "second", "new");
  write_text(folder.path() / "dangling", "first");
  EXPECT_TRUE(fs::is_symlink(folder.path() / "link"));
  EXPECT_TRUE(fs::is_symlink(folder.path() / "second"));
  EXPECT_TRUE(fs::is_symlink(folder.path() / "dangling"));
  EXPECT_EQ(read_file(folder.path() / "in/file"), "new");
  EXPECT_EQ(read_file(folder.path() / "in/later"), "first");
  fs::create_symlink("loop", folder.path() / "loop");
  EXPECT_EQ(complaint(folder.path() / "loop"), ": too many links");
  EXPECT_EQ(count_files(folder.path()), 5);
}

TEST(WriteFileWhole, KeepsTheMode) {
  const test::TemporaryFolder folder;
  const auto mode = [&](const char* name) {
    struct stat status {};
    stat((folder.path() / name).c_str(), &status);
    return status.st_mode & 07777;
  };
  const mode_t before = umask(022);
  write_text(folder.path() / "new", "text");
  EXPECT_EQ(mode("new"), 0644u);
  for (const mode_t kept : {0600u, 0640u, 0444u, 0755u}) {
    chmod((folder.path() / "new").c_str(), kept);
    write_file_whole(folder.path() / "new", [&](std::ostream& out) {
      out << "text";
      // Nobody else may read it while it is written either.
      for (const auto& entry : fs::directory_iterator(folder.path()))
        EXPECT_EQ(static_cast<mode_t>(entry.status().permissions()) & ~kept & 0077u, 0u);
    });
    EXPECT_EQ(mode("new"), kept);
  }
  umask(before);
}

TEST(WriteFileWhole, LeavesAFileOfTheNameThatItWroteToBeforeAlone) {
  const test::TemporaryFolder folder;
  write_text(folder.path() / "a.partial", "the user's");
  write_text(folder.path() / "a", "text");
  EXPECT_EQ(read_file(folder.path() / "a.partial"), "the user's");
}

TEST(WriteFileWhole, TakesTheLongestNames) {
  const test::TemporaryFolder folder;
  const fs::path path = folder.path() / std::string(255, 'n');
  write_text(path, "text");
  EXPECT_EQ(read_file(path), "text");
}

TEST(WriteFileWhole, GivesEveryReaderTheWholeOfOneOfTwoWriters) {
  const test::TemporaryFolder folder;
  const fs::path path = folder.path() / "a";
  const std::string texts[2] = {std::string(100000, 'a'), std::string(200000, 'b')};
  write_text(path, texts[0]);
  std::atomic<int> running = 2;
  const auto write = [&](const std::string& text) {
    for (int i = 0; i < 50; ++i) write_text(path, text);
    --running;
  };
  std::thread one(write, texts[0]), two(write, texts[1]);
  while (running > 0) {
    const std::string text = read_file(path);
    EXPECT_TRUE(text == texts[0] || text == texts[1]) << text.size();
  }
  one.join();
  two.join();
  EXPECT_EQ(count_files(folder.path()), 1);
}

TEST(WriteFileWhole, WritesToPipesAndDevicesAsTheyAre) {
  const test::TemporaryFolder folder;
  const fs::path pipe = folder.path() / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  for (const bool by_name : {false, true}) {
    std::string read;
    std::thread reader([&] { read = read_file(pipe); });
    if (by_name)
      replace_file(pipe, [](const fs::path& partial) { std::ofstream(partial) << "through"; });
    else
      write_text(pipe, "through");
    reader.join();
    EXPECT_EQ(read, "through");
  }
  EXPECT_TRUE(fs::is_fifo(pipe));
  EXPECT_EQ(complaint("/dev/null"), "written");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  if (!fs::exists("/dev/full")) return;
  EXPECT_EQ(complaint("/dev/full"), ": writing failed");
}

TEST(WriteFileWhole, RefusesSocketsFoldersAndMissingFolders) {
  const test::TemporaryFolder folder;
  const fs::path path = folder.path() / "socket";
  const int socket = ::socket(AF_UNIX, SOCK_STREAM, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  path.string().copy(address.sun_path, sizeof address.sun_path - 1);
  ASSERT_EQ(bind(socket, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
  EXPECT_EQ(complaint(path), ": is a disk or a socket, not a file");
  EXPECT_TRUE(fs::is_socket(path));
  close(socket);
  EXPECT_EQ(complaint(folder.path()), ": is a folder, not a file");
  EXPECT_EQ(complaint(folder.path() / "none/a"), ": No such file or directory");
  EXPECT_THROW(check_output(path), FileError);
  EXPECT_THROW(check_output(folder.path()), FileError);
  EXPECT_THROW(check_output(folder.path() / "none/a"), FileError);
  EXPECT_NO_THROW(check_output(folder.path() / "a"));
  EXPECT_NO_THROW(check_output("/dev/null"));
}

TEST(ReadFile, EndsWhereThereIsNoEnd) {
  const auto complaint_of = [](const fs::path& path, std::uintmax_t most) {
    try {
      read_file(path, most);
    } catch (const FileError& error) {
      return std::string(error.what()).substr(path.string().size());
    }
    return std::string("read");
  };
  EXPECT_EQ(complaint_of("/dev/zero", 10), ": is a device, not a file");
  const test::TemporaryFolder folder;
  write_text(folder.path() / "a", "0123456789");
  EXPECT_EQ(complaint_of(folder.path() / "a", 10), "read");
  EXPECT_EQ(complaint_of(folder.path() / "a", 9), ": holds more than 9 bytes");
  const fs::path pipe = folder.path() / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  std::thread writer([&] {
    const int out = open(pipe.c_str(), O_WRONLY);
    const std::string block(1000, 'x');
    std::signal(SIGPIPE, SIG_IGN);
    while (write(out, block.data(), block.size()) > 0) {
    }
    close(out);
  });
  EXPECT_EQ(complaint_of(pipe, 100000), ": holds more than 100000 bytes");
  writer.join();
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
