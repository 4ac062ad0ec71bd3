// Measures the reading of large files, in a process of its own.
#include <fmt/format.h>
#include <malloc.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <iostream>

#include "ink/pen_files.h"
#include "sanitizers/processor_seconds.h"
#include "sanitizers/sanitized.h"
#include "support/process.h"

namespace burin {
namespace {

constexpr std::size_t most_samples = 1'000'000;

Sample numbered(std::size_t number) {
  const double x = static_cast<double>(number);
  return {x / 200, {x / 64 - 1000, 500 - x / 128, 0}, {static_cast<float>(number % 1024) / 1024}};
}

std::string csv_text() {
  std::string text = "stroke,x,y,time,pressure\n";
  for (std::size_t i = 0; i < most_samples; ++i) {
    const Sample s = numbered(i);
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{}\n", i / 1000, s.position.x(), s.position.y(),
                   s.time, s.pen.pressure);
  }
  return text;
}

std::string inkml_text() {
  std::string text =
      "<ink><traceFormat><channel name=\"X\"/><channel name=\"Y\"/><channel name=\"T\" units=\"s\"/>"
      "<channel name=\"F\" max=\"1\"/></traceFormat>";
  for (std::size_t i = 0; i < most_samples; ++i) {
    const Sample s = numbered(i);
    if (i % 1000 == 0) text += "<trace>";
    fmt::format_to(std::back_inserter(text), "{} {} {} {}", s.position.x(), s.position.y(), s.time,
                   s.pen.pressure);
    text += i % 1000 == 999 ? "</trace>\n" : ",";
  }
  return text + "</ink>";
}

std::string pointers_text() {
  std::string text = "[";
  for (std::size_t i = 0; i < most_samples; ++i) {
    const Sample s = numbered(i);
    if (i % 1000 == 0) text += R"({"pointers":[)";
    fmt::format_to(std::back_inserter(text), R"({{"x":{},"y":{},"t":{}}})", s.position.x(), s.position.y(),
                   5 * i);
    text += i % 1000 < 999 ? "," : i + 1 < most_samples ? "]}," : "]}]";
  }
  return text;
}

struct Cost {
  double seconds = 0, megabytes = 0;
  bool right = false;
};

bool is_million(const PenFile& file) {
  const Sample &last = file.strokes.back().samples.back(), expected = numbered(most_samples - 1);
  return file.strokes.size() == 1000 && last.position == expected.position && last.time == expected.time;
}

/// Calls `read_right`, which returns whether all went right, in a child process, whose memory is all its own.
template <class ReadRight>
Cost cost_of(const ReadRight& read_right) {
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("pipe");
  const pid_t child = fork();
  if (child == 0) {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const long before = usage.ru_maxrss;
    Cost cost;
    cost.seconds = test::processor_seconds([&] { cost.right = read_right(); });
    getrusage(RUSAGE_SELF, &usage);
    cost.megabytes = static_cast<double>(usage.ru_maxrss - before) / 1024;
    const bool told = write(ends[1], &cost, sizeof cost) == sizeof cost;
    _exit(told ? 0 : 1);
  }
  Cost cost;
  close(ends[1]);  // so that the end of a child that failed is seen
  EXPECT_EQ(read(ends[0], &cost, sizeof cost), static_cast<ssize_t>(sizeof cost));
  waitpid(child, nullptr, 0);
  close(ends[0]);
  return cost;
}

/// The text is gone before the file is read, so that its memory does not hide that of the reading.
void expect_cheap(std::string (*text)()) {
  const test::PenFileFolder folder;
  const std::filesystem::path path = folder.write("million", text());
  malloc_trim(0);
  const Cost cost = cost_of([&] { return is_million(read_pen_file(path)); });
  std::cout << cost.seconds << " s, " << cost.megabytes << " MB\n";
  EXPECT_TRUE(cost.right);
  if (test::sanitized) return;
  EXPECT_LT(cost.seconds, 2) << "below 1 when nothing else runs";
  EXPECT_LT(cost.megabytes, 150) << "the samples are 56 MB";
}

TEST(PenFileCost, OfWhatUnpacksToTooMuchIsTiny) {
  const test::PenFileFolder folder;
  const auto path = folder.write("a.xopp", "<xournal>" + std::string(300'000'000, ' '));
  ASSERT_EQ(test::run_process({"gzip", "-1", path.string()}).exit_code, 0);
  malloc_trim(0);
  const Cost cost = cost_of([&] {
    try {
      read_pen_file(path.string() + ".gz");
      return false;
    } catch (const FileError&) {
      return true;
    }
  });
  EXPECT_TRUE(cost.right);
  if (test::sanitized) return;
  EXPECT_LT(cost.seconds, 1);
  EXPECT_LT(cost.megabytes, 20) << "of what is unpacked nothing is kept";
}

TEST(PenFileCost, OfAMillionSamplesOfCsvIsSmall) { expect_cheap(csv_text); }
TEST(PenFileCost, OfAMillionSamplesOfInkmlIsSmall) { expect_cheap(inkml_text); }
TEST(PenFileCost, OfAMillionSamplesOfWebPointersIsSmall) { expect_cheap(pointers_text); }

}  // namespace
}  // namespace burin
