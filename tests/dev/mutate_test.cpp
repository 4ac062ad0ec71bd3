#include <burin/base/file.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "support/process.h"
#include "support/shared_data.h"

namespace burin::test {
namespace {

namespace fs = std::filesystem;

/// A project of one folder with two operators, of which its test looks at the first only, and a room with
/// another.
class TwoOperators {
 public:
  TwoOperators() {
    write("CMakeLists.txt",
          "cmake_minimum_required(VERSION 3.20)\n"
          "project(two LANGUAGES CXX)\n"
          "set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)\n"
          "add_executable(two_test tests/two/two_test.cpp sdk/burin/two/two.cpp)\n"
          "add_executable(host_test tests/host/host_test.cpp)\n");
    write("sdk/burin/two/CMakeLists.txt", "");
    write("sdk/burin/two/two.cpp",
          "// Sums a + b.\nint sum(int a, int b) { return a + b; }\n"
          "bool less(int a, int b) { return a < b; }\n");
    write("sdk/burin/two/room/room.h",
          "// Takes b from a.\ninline int take(int a, int b) { return a - b; }\n");
    write("tests/two/two_test.cpp",
          "#include \"../../sdk/burin/two/room/room.h\"\nint sum(int, int);\n"
          "int main() { return sum(1, 2) == 3 && take(2, 1) == 1 ? 0 : 1; }\n");
    write("tests/host/host_test.cpp", "int main() {}\n");
    fs::create_directories(folder_.path() / "tests/mutate");
    fs::copy(fs::path(BURIN_SOURCE_FOLDER) / "tests/mutate/mutate.py", script());
    for (const std::vector<std::string>& command :
         {std::vector<std::string>{"init", "-q"},
          {"add", "."},
          {"-c", "user.name=a", "-c", "user.email=a@b", "commit", "-q", "-m", "Add"}})
      git(command);
  }

  ProcessResult mutate(const std::vector<std::string>& options) const {
    std::vector<std::string> command{"python3", script().string()};
    command.insert(command.end(), options.begin(), options.end());
    return run_process(command);
  }

 private:
  fs::path script() const { return folder_.path() / "tests/mutate/mutate.py"; }

  void write(const fs::path& name, const std::string& text) const {
    const fs::path path = folder_.path() / name;
    fs::create_directories(path.parent_path());
    write_file_whole(path, [&](std::ostream& out) { out << text; });
  }

  void git(const std::vector<std::string>& arguments) const {
    std::vector<std::string> command{"git", "-C", folder_.path().string()};
    command.insert(command.end(), arguments.begin(), arguments.end());
    const ProcessResult done = run_process(command);
    EXPECT_EQ(done.exit_code, 0) << done.err;
  }

  TemporaryFolder folder_;
};

TEST(Mutate, TellsWhichChangeOfAnOperatorNoTestNotices) {
  if (run_process({"/bin/sh", "-c", "command -v python3 && command -v git"}).exit_code != 0)
    GTEST_SKIP() << "needs Python and Git";
  const TwoOperators project;
  const ProcessResult both = project.mutate({"two", "--count", "5"});
  EXPECT_EQ(both.exit_code, 1) << both.err;
  EXPECT_NE(("\n" + both.out).find("\ncaught sdk/burin/two/two.cpp:2: '+' as '-'"), std::string::npos)
      << both.out;
  EXPECT_NE(("\n" + both.out).find("\nNOT CAUGHT sdk/burin/two/two.cpp:3: '<' as '<='"), std::string::npos)
      << both.out;
  EXPECT_NE(both.out.find("seed 1: 2 of 3 changes were caught"), std::string::npos) << both.out;
  EXPECT_EQ(project.mutate({"three"}).exit_code, 2);
  const ProcessResult room = project.mutate({"two/room"});
  EXPECT_EQ(room.exit_code, 0) << room.err;
  EXPECT_EQ(room.out,
            "caught sdk/burin/two/room/room.h:2: '-' as '+'\n"
            "seed 1: 1 of 1 changes were caught\n");
  EXPECT_EQ(project.mutate({"two/attic"}).exit_code, 2);
}

}  // namespace
}  // namespace burin::test
