#include <burin/base/file.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "support/process.h"
#include "support/shared_data.h"

namespace burin::test {
namespace {

namespace fs = std::filesystem;

const fs::path source_folder = BURIN_SOURCE_FOLDER;

/// A checkout whose `./dev` meets programs that only note how they are called.
class NotingMachine {
 public:
  /// `installed`: a pattern of the shell, the packages that are there.
  explicit NotingMachine(const std::string& installed) {
    fs::create_directories(folder_.path() / "cmake");
    fs::copy(source_folder / "dev", folder_.path() / "dev");
    fs::copy(source_folder / "cmake/Dependencies.cmake", folder_.path() / "cmake/Dependencies.cmake");
    write("programs/dpkg-query", "case \"$4\" in " + installed + ") echo 'install ok installed' ;; esac");
    write("programs/sudo", "exec \"$@\"");
    write("programs/nproc", "echo 7");
    for (const char* name :
         {"programs/apt-get", "programs/cmake", "programs/ctest", "programs/npm", "build/release/bin/burin"})
      write(name, note());
    write("build/fuzz/bin/burin_fuzz", note());
    write("build/fuzz/bin/burin_fuzz_seeds", "[ $# = 2 ] || printf 'one\\ntwo\\n'");
  }

  /// The calls that the command of `./dev` makes, a line each.
  std::string calls_of(const std::string& command) const {
    run(command);
    return read_file(calls());
  }

  /// What the command of `./dev` says; it must make no calls.
  ProcessResult idle_result_of(const std::string& command) const {
    const ProcessResult result = run(command);
    EXPECT_EQ(read_file(calls()), "") << command;
    return result;
  }

 private:
  ProcessResult run(const std::string& command) const {
    write_file_whole(calls(), [](std::ostream&) {});
    const std::string path = "PATH=" + (folder_.path() / "programs").string() + ":/usr/bin:/bin";
    return run_process(
        {"/usr/bin/env", path, "bash", "-c", (folder_.path() / "dev").string() + " " + command});
  }

  std::string calls() const { return folder_.path() / "calls"; }

  /// A script that notes its call.
  std::string note() const { return "echo \"${0##*/} $*\" >>'" + calls() + "'"; }

  void write(const fs::path& name, const std::string& script) const {
    const fs::path path = folder_.path() / name;
    fs::create_directories(path.parent_path());
    write_file_whole(path, [&](std::ostream& out) { out << "#!/bin/sh\n" << script << "\n"; });
    fs::permissions(path, fs::perms::owner_all);
  }

  TemporaryFolder folder_;
};

/// The first of the lines that begins so, or nothing.
std::string line_with(const std::string& start, const std::string& lines) {
  std::istringstream in(lines);
  for (std::string line; std::getline(in, line);)
    if (line.starts_with(start)) return line;
  return "";
}

std::set<std::string> words_of(const std::string& line) {
  std::istringstream in(line);
  return {std::istream_iterator<std::string>(in), {}};
}

const char* const of_the_command[] = {"g++", "cmake", "ninja-build", "libeigen3-dev", "fonts-dejavu-core"};
const char* const of_the_tests[] = {"libgtest-dev", "libcgal-dev", "libbenchmark-dev",
                                    "xz-utils",     "qemu-user",   "g++-mingw-w64-x86-64-posix"};

TEST(Dev, DemoOnABareMachineBuildsAndInstallsWhatItNeeds) {
  const std::string calls = NotingMachine("none").calls_of("demo");
  const auto installed = words_of(line_with("apt-get install", calls));
  for (const char* package : of_the_command) EXPECT_TRUE(installed.contains(package)) << package;
  for (const char* package : of_the_tests) EXPECT_FALSE(installed.contains(package)) << package;
  EXPECT_TRUE(words_of(line_with("cmake --preset", calls)).contains("-DBURIN_TESTS=OFF")) << calls;
  EXPECT_TRUE(line_with("cmake --build", calls).ends_with(" --target burin")) << calls;
  EXPECT_NE(line_with("burin replay", calls), "") << calls;
}

TEST(Dev, TestInstallsAndBuildsAll) {
  const std::string calls = NotingMachine("none").calls_of("test");
  const auto installed = words_of(line_with("apt-get install", calls));
  for (const char* package : of_the_command) EXPECT_TRUE(installed.contains(package)) << package;
  for (const char* package : of_the_tests) EXPECT_TRUE(installed.contains(package)) << package;
  EXPECT_TRUE(words_of(line_with("cmake --preset", calls)).contains("-DBURIN_TESTS=ON")) << calls;
  EXPECT_FALSE(words_of(line_with("cmake --build", calls)).contains("--target")) << calls;
  EXPECT_TRUE(line_with("ctest --preset release", calls).starts_with("ctest --preset release -j 7 "))
      << calls;
  EXPECT_NE(line_with("cmake --build", calls).find(" --parallel 7"), std::string::npos) << calls;
}

/// The words between the brackets of the line that begins with `key`.
std::set<std::string> yaml_list(const std::string& key, const std::string& text) {
  const std::string line = text.substr(std::min(text.find(key + ": ["), text.size()));
  std::istringstream in(line.substr(key.size() + 3, line.find(']') - key.size() - 3));
  std::set<std::string> words;
  for (std::string word; std::getline(in >> std::ws, word, ',');) words.insert(word);
  return words;
}

TEST(Dev, IsWhatContinuousIntegrationRuns) {
  const std::string workflow = read_file(source_folder / ".github/workflows/ci.yml");
  EXPECT_NE(workflow.find("run: ./dev ${{ matrix.command }}\n"), std::string::npos);
  const auto commands = yaml_list("command", workflow);
  EXPECT_EQ(commands, (std::set<std::string>{"test", "test address", "test thread", "format check", "tidy"}));
  const std::string usage = run_process({(source_folder / "dev").string()}).out;
  for (const std::string& command : commands)
    EXPECT_NE(usage.find("\n  " + command.substr(0, command.find(' ')) + " "), std::string::npos) << command;
}

TEST(Dev, FuzzBuildsWithClangAndTriesEveryReaderOrOne) {
  const NotingMachine machine("none");
  const std::string calls = machine.calls_of("fuzz");
  const auto installed = words_of(line_with("apt-get install", calls));
  for (const char* package : {"clang-16", "libclang-rt-16-dev", "libopenimageio-dev"})
    EXPECT_TRUE(installed.contains(package)) << package;
  EXPECT_TRUE(
      line_with("cmake --build --preset fuzz", calls).ends_with(" --target burin_fuzz burin_fuzz_seeds"));
  EXPECT_NE(calls.find("burin_fuzz build/fuzz/corpus/one -max_total_time=60 "), std::string::npos) << calls;
  EXPECT_NE(calls.find("burin_fuzz build/fuzz/corpus/two "), std::string::npos) << calls;
  const std::string of_one = machine.calls_of("fuzz two --minutes 7");
  EXPECT_EQ(of_one.find("corpus/one"), std::string::npos) << of_one;
  EXPECT_NE(of_one.find("burin_fuzz build/fuzz/corpus/two -max_total_time=420 "), std::string::npos)
      << of_one;
  EXPECT_EQ(machine.calls_of("fuzz three").find("max_total_time"), std::string::npos);
  EXPECT_EQ(machine.calls_of("fuzz --minutes x"), "");
}

/// The commands that the usage lists.
std::vector<std::string> listed_commands(const std::string& usage) {
  static const std::regex command("\n  ([a-z-]+)");
  return {std::sregex_token_iterator(usage.begin(), usage.end(), command, 1), {}};
}

TEST(Dev, TellsOfEachCommandAndStartsNothing) {
  const NotingMachine machine("none");
  const std::string usage = machine.idle_result_of("help").out;
  const std::vector<std::string> commands = listed_commands(usage);
  EXPECT_GT(commands.size(), 10u);
  for (const std::string& command : commands)
    for (const char* option : {" --help", " -h", " some --help"}) {
      const ProcessResult result = machine.idle_result_of(command + option);
      EXPECT_EQ(result.exit_code, 0) << command;
      EXPECT_TRUE(result.out.starts_with("  " + command + " ")) << result.out;
      EXPECT_EQ(listed_commands("\n" + result.out).size(), 1u) << result.out;
      EXPECT_NE(usage.find(result.out), usage.npos) << result.out;
    }
  EXPECT_EQ(machine.idle_result_of("glow --help").exit_code, 1);
}

TEST(Dev, RefusesWhatACommandDoesNotTakeBeforeAnythingStarts) {
  const NotingMachine machine("*");
  const auto refusal = [&](const std::string& command) {
    const ProcessResult result = machine.idle_result_of(command);
    EXPECT_EQ(result.exit_code, 1) << command;
    return result.err;
  };
  EXPECT_EQ(refusal("fuzz --minute 3"), "dev: no option '--minute': ./dev fuzz --help\n");
  EXPECT_EQ(refusal("fuzz --minutes"), "dev: --minutes takes a value: ./dev fuzz --help\n");
  EXPECT_EQ(refusal("fuzz obj ply"), "dev: 'ply' is too much: ./dev fuzz --help\n");
  EXPECT_EQ(refusal("mutate --number=3"), "dev: no option '--number': ./dev mutate --help\n");
  for (const std::string& command : listed_commands(machine.idle_result_of("help").out))
    EXPECT_EQ(refusal(command + " --glow"), "dev: no option '--glow': ./dev " + command + " --help\n");
}

TEST(Dev, TakesValuesOfOptionsEitherWay) {
  const NotingMachine machine("*");
  EXPECT_EQ(machine.calls_of("fuzz two --minutes=7"), machine.calls_of("fuzz two --minutes 7"));
  EXPECT_NE(machine.calls_of("fuzz two --minutes=7").find("-max_total_time=420 "), std::string::npos);
}

TEST(Dev, ProgramsAreInstalledForTheTestsThatNeedThem) {
  const std::string calls = NotingMachine("none").calls_of("programs");
  const auto installed = words_of(line_with("apt-get install", calls));
  for (const char* package :
       {"blender", "python3-numpy", "python3-openvdb", "meshlab", "xvfb", "xauth", "assimp-utils",
        "python3-wheel", "mypy", "python3-ipykernel", "python3-matplotlib"})
    EXPECT_TRUE(installed.contains(package)) << package;
  EXPECT_TRUE(line_with("npm ci", calls).starts_with("npm ci --prefix tests/host_stub/programs ")) << calls;
}

TEST(Dev, DemoLeavesTheTestsInTheBuildTreeOfADeveloper) {
  const std::string calls = NotingMachine("*").calls_of("demo");
  EXPECT_EQ(line_with("apt-get", calls), "") << calls;
  EXPECT_TRUE(words_of(line_with("cmake --preset", calls)).contains("-DBURIN_TESTS=ON")) << calls;
  EXPECT_TRUE(line_with("cmake --build", calls).ends_with(" --target burin")) << calls;
}

TEST(Dev, TheCommandIsBuiltFromNothingBelowTests) {
  const ProcessResult inputs = run_process({BURIN_NINJA, "-C", BURIN_BUILD_FOLDER, "-t", "inputs", "burin"});
  ASSERT_EQ(inputs.exit_code, 0) << inputs.err;
  std::istringstream in(inputs.out);
  std::size_t sources = 0;  // of CMake too, which include up to eight
  const std::string root = source_folder.string() + "/";
  for (std::string line; std::getline(in, line);) {
    EXPECT_FALSE(line.starts_with("tests/") || line.starts_with(root + "tests/")) << line;
    EXPECT_FALSE(line.starts_with(root + "samples/")) << line;
    sources += line.ends_with(".cpp") || line.ends_with("_cxx.cxx");
  }
  EXPECT_GT(sources, 60u) << "sources of the SDK, the brushes and the command";
}

}  // namespace
}  // namespace burin::test
