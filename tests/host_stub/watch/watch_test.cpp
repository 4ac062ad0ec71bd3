// `burin replay --watch` and `burin try --watch`, with a module that the test writes anew.
#include <burin/base/file.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <thread>

#include "../run_command.h"

namespace burin::test {
namespace {

namespace fs = std::filesystem;

std::string version(int number) {
  return read_file(fs::path(BURIN_RELOADED_BRUSHES) / ("reloaded_" + std::to_string(number) + ".burin"));
}

const std::string small_pictures = "--width 200 --height 150 ";

std::size_t count_of(const std::string& part, const std::string& text) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++count;
  return count;
}

class Watch : public ::testing::Test {
 protected:
  Watch() { write(version(1)); }
  ~Watch() override {
    if (running_.joinable()) running_.join();
  }

  void write(const std::string& bytes) { std::ofstream(module_, std::ios::binary) << bytes; }

  /// Starts the command, which ends after so many changes, and waits until it watches.
  void start(int changes, const std::string& options = "") {
    const std::string stroke = folder_.write("a.stroke", strokes_);
    const std::string mesh = folder_.write("cube.obj", cube_obj());
    start_command("replay " + stroke + " --mesh " + mesh + " --target-triangles 20000" + brush_ +
                  " --watch=" + std::to_string(changes) + " " + options);
  }

  void start_command(const std::string& arguments) {
    const std::string command =
        std::string("exec ") + BURIN_COMMAND + " " + arguments + " >" + out_ + " 2>" + err_;
    running_ = std::thread([this, command] {
      exit_code_ =
          run_process({"/bin/sh", "-c", command}, {"BURIN_PLUGIN_PATH=" + module_.parent_path().string()})
              .exit_code;
    });
    wait_for(out_, "watching " + module_.string() + "\n");
  }

  /// Waits until a file has a text, two minutes at most.
  static void wait_for(const std::string& file, const std::string& text) {
    for (int tenth = 0; tenth < 1200; ++tenth) {
      if (fs::exists(file) && read_file(file).find(text) != std::string::npos) return;
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    FAIL() << "no '" << text << "' in " << file;
  }

  /// Waits for the end of the command.
  void finish() {
    running_.join();
    EXPECT_EQ(exit_code_, 0) << read_file(err_);
  }

  CommandFolder folder_;
  fs::path module_ = folder_.path("reloaded.burin");
  std::string strokes_ = equator_stroke(-0.6, 0.6, 20, R"("radius":0.2)"),
              brush_ = " --brush org.burin.test.reloaded";
  std::string out_ = folder_.path("out.txt"), err_ = folder_.path("err.txt");
  std::thread running_;
  int exit_code_ = -1;
};

TEST_F(Watch, DrawsTheLastStrokeAgainWithTheNewModule) {
  start(1, small_pictures + "--report " + folder_.path("report"));
  write(version(2));
  finish();
  const std::string out = read_file(out_);
  EXPECT_EQ(count_of("\nbefore  ", out), 1u) << out;
  EXPECT_EQ(count_of("\nafter   ", out), 1u) << out;
  EXPECT_EQ(read_file(err_), "");
  const std::string page = read_file(folder_.path("report/watch.html"));
  EXPECT_NE(page.find("watch_before.png"), page.npos);
  EXPECT_NE(read_file(folder_.path("report/watch_before.png")),
            read_file(folder_.path("report/watch_after.png")));
}

// The solid is of the first stroke, which another brush draws.
TEST_F(Watch, ShowsSolidsBesideTheSurface) {
  brush_ = "";
  strokes_ = equator_stroke(-0.6, 0.6, 20, R"("radius":0.2,"brush":"org.burin.tube")") +
             equator_stroke_lines(-0.6, 0.6, 20, R"("radius":0.2,"brush":"org.burin.test.reloaded")");
  std::set<std::string> pictures;
  for (const char* solid : {"none", "separate"}) {
    write(version(1));
    out_ = folder_.path(std::string(solid) + ".txt");
    start(1, small_pictures + "--solid " + solid + " --report " + folder_.path(solid));
    write(version(2));
    finish();
    pictures.insert(read_file(folder_.path(solid + std::string("/watch_after.png"))));
  }
  EXPECT_EQ(pictures.size(), 2u);
}

TEST_F(Watch, GoesOnWithTheOldModuleWhereTheNewOneDoesNotLoad) {
  start(2);
  write("not a library, but long enough to be taken for a whole file by its first bytes.........");
  wait_for(err_, "burin: warning: " + module_.string() + ": ");
  write(version(2));
  finish();
  EXPECT_EQ(count_of("\nafter   ", read_file(out_)), 1u);
}

TEST_F(Watch, WaitsForTheEndOfAModuleThatIsBeingWritten) {
  start(1);
  const std::string whole = version(2);
  write(whole.substr(0, whole.size() / 2));
  std::this_thread::sleep_for(std::chrono::seconds(1));
  EXPECT_EQ(count_of("\nafter   ", read_file(out_)), 0u);
  write(whole);
  finish();
  EXPECT_EQ(read_file(err_), "");
  EXPECT_EQ(count_of("\nafter   ", read_file(out_)), 1u);
}

TEST_F(Watch, LeavesOutParametersThatAreGone) {
  start(1, "--param count=4");
  write(version(2));
  finish();
  EXPECT_EQ(read_file(err_), "burin: warning: org.burin.test.reloaded has no parameter 'count' any more\n");
  EXPECT_EQ(count_of("\nafter   ", read_file(out_)), 1u);
}

TEST_F(Watch, SaysWhichStateIsLost) {
  start(1);
  write(version(3));
  finish();
  EXPECT_EQ(read_file(err_),
            "burin: warning: org.burin.test.reloaded: its state is lost: written by another version\n");
}

TEST_F(Watch, DrawsThePictureOfATryAgain) {
  const std::string picture = folder_.path("try.png");
  start_command("try " + module_.string() + " --png " + picture + " --watch=1");
  const std::string before = read_file(picture);
  write(version(2));
  finish();
  EXPECT_EQ(read_file(err_), "");
  EXPECT_EQ(count_of("\nafter   ", read_file(out_)), 1u);
  EXPECT_NE(read_file(picture), before);
}

TEST_F(Watch, IsNotBegunUnlessAskedFor) {
  const std::string stroke = folder_.write("a.stroke", equator_stroke(-0.6, 0.6, 20, R"("radius":0.2)"));
  const std::string out = burin_output({"replay", stroke, "--mesh", folder_.write("cube.obj", cube_obj()),
                                        "--target-triangles", "2000", "--brush", "org.burin.groove"});
  EXPECT_EQ(out.find("watching"), out.npos) << out;
}

TEST_F(Watch, RefusesAStrokeThatMeetsNoSurface) {
  const std::string stroke = folder_.write("a.stroke", equator_stroke(0.3, 0.6, 20, R"("radius":0.01)"));
  const ProcessResult result = burin({"replay", stroke, "--mesh", folder_.write("cube.obj", cube_obj()),
                                      "--brush", "org.burin.groove", "--watch=1"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_NE(result.err.find("the last stroke does not meet the surface"), std::string::npos) << result.err;
}

}  // namespace
}  // namespace burin::test
