// Tests where results are written: full, closed and special outputs.

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <thread>

#include "host_stub/bench/bench_suite.h"
#include "run_command.h"

namespace burin::test {
namespace {

/// `burin ARGUMENTS` by a shell.
ProcessResult shell(const std::string& arguments) {
  return run_process({"sh", "-c", std::string(BURIN_COMMAND) + " " + arguments}, {"BURIN_PLUGIN_PATH="});
}

TEST(Outputs, FailInOneWayWhereTheStandardOutputIsFullOrClosed) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP();
  const CommandFolder folder;
  const std::string mesh = folder.write("cube.obj", cube_obj()),
                    stroke = folder.write("a.stroke", equator_stroke(0, 0.5, 5, "\"radius\":0.2"));
  for (const std::string& command :
       {std::string("--help"), std::string("replay --help"), std::string("list"), std::string("list --json"),
        "chart " + stroke + " --mesh " + mesh + " --subdivide 3",
        "replay " + stroke + " --mesh " + mesh + " --subdivide 3 --brush org.burin.groove --json"})
    for (const char* output : {" > /dev/full", " >&-"}) {
      const ProcessResult result = shell(command + output);
      EXPECT_EQ(result.exit_code, 2) << command << output;
      EXPECT_EQ(result.err, "burin: standard output: writing failed\n") << command << output;
    }
}

TEST(Outputs, AreWrittenWhereTheStandardInputIsClosed) {
  const BenchFolder folder;
  const std::string suite = folder.write_suite({BenchFolder::bench_case("a"), BenchFolder::bench_case("b")});
  const ProcessResult result = shell("bench " + suite + " --repeat 1 --json <&-");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(result.out.find("\"cases\""), result.out.npos);
}

TEST(Outputs, LeaveDevicesAndLinksInPlace) {
  const CommandFolder folder;
  const std::string mesh = folder.write("cube.obj", cube_obj());
  EXPECT_EQ(shell("render --mesh " + mesh + " --png /dev/null").exit_code, 0);
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
  const std::string file = folder.write("secret.png", "");
  chmod(file.c_str(), 0600);
  std::filesystem::create_symlink("secret.png", folder.path("link.png"));
  EXPECT_EQ(shell("render --mesh " + mesh + " --png " + folder.path("link.png")).exit_code, 0);
  EXPECT_TRUE(std::filesystem::is_symlink(folder.path("link.png")));
  struct stat status {};
  ASSERT_EQ(stat(file.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0600u);
  EXPECT_GT(status.st_size, 100);
  const ProcessResult through =
      shell("render --mesh " + mesh + " --png /dev/stdout | cat > " + folder.path("out.png"));
  EXPECT_EQ(through.exit_code, 0);
  EXPECT_GT(std::filesystem::file_size(folder.path("out.png")), 100u);
}

/// Processes whose command line holds the text.
std::size_t count_processes(const std::string& text) {
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    std::ifstream in(entry.path() / "cmdline", std::ios::binary);
    const std::string line((std::istreambuf_iterator<char>(in)), {});
    count += line.find(text) != line.npos;
  }
  return count;
}

bool within_seconds(int seconds, const std::function<bool()>& done) {
  for (int i = 0; i < 50 * seconds; ++i) {
    if (done()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return false;
}

TEST(Outputs, LeaveNoChildOfBenchBehind) {
  const BenchFolder folder;
  const std::string suite = folder.write_suite({BenchFolder::bench_case("a"), BenchFolder::bench_case("b")});
  for (const int signal : {SIGTERM, SIGKILL}) {
    const pid_t bench = fork();
    if (bench == 0) {
      execl(BURIN_COMMAND, "burin", "bench", suite.c_str(), "--repeat", "1000", nullptr);
      _exit(127);
    }
    EXPECT_TRUE(within_seconds(30, [&] { return count_processes(suite) >= 2; }));
    kill(bench, signal);
    waitpid(bench, nullptr, 0);
    EXPECT_TRUE(within_seconds(10, [&] { return count_processes(suite) == 0; }));
  }
}

}  // namespace
}  // namespace burin::test
