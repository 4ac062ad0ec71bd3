#include <burin/base/error.h>
#include <burin/base/file.h>
#include <burin/stroke/stroke_file.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cmath>
#include <csignal>
#include <iostream>
#include <limits>
#include <random>

#include "stroke/recordings.h"
#include "support/shared_data.h"

namespace burin {
namespace {

void write(const std::filesystem::path& path, const Recording& recording) {
  StrokeWriter writer(path, recording.space, recording.camera, recording.device);
  for (const RecordedStroke& stroke : recording.strokes) {
    writer.begin(stroke);
    for (const Sample& sample : stroke.samples) writer.add(sample);
    writer.end();
  }
}

/// A finite number of any size, drawn by its bits.
template <class Number, class Bits>
Number any_number(std::mt19937_64& random) {
  for (;;) {
    const auto number = std::bit_cast<Number>(static_cast<Bits>(random()));
    if (std::isfinite(number)) return number;
  }
}

Sample any_sample(std::mt19937_64& random, double time) {
  const auto coordinate = [&] { return double{any_number<float, std::uint32_t>(random)} * (1 - 0x1p-40); };
  const auto angle = [&] { return any_number<float, std::uint32_t>(random); };
  const auto pressure = std::abs(std::remainder(any_number<float, std::uint32_t>(random), 1.0f));
  return {time, {coordinate(), coordinate(), coordinate()}, {pressure, angle(), angle(), angle()}};
}

Recording any_recording(std::mt19937_64& random) {
  Recording recording;
  recording.camera = Camera();
  recording.camera->view.topRightCorner<3, 1>() << 1 / 3.0, -1e-300, 1e7;
  recording.camera->width = 1920;
  recording.camera->height = 1080;
  recording.device = "Tablet \"M\", pen 2";
  std::vector<double> times(3000);
  for (double& time : times) time = any_number<double, std::uint64_t>(random);
  std::sort(times.begin(), times.end());
  RecordedStroke& stroke = recording.strokes.emplace_back();
  stroke.settings[&StrokeSettings::brush] = "org.burin.\"röck\"\n";
  stroke.settings[&StrokeSettings::radius] = 0.1;
  stroke.settings[&StrokeSettings::strength] = -1 / 3.0;
  stroke.settings[&StrokeSettings::follow] = 0.1;
  stroke.settings[&ReplaySettings::closure] = Closure::closed;
  stroke.settings[&StrokeSettings::params] = {
      {"a", true}, {"b", 1 / 7.0}, {"c", "\\x"}, {"d", std::vector<double>{1, 1e-320, -0.5}}};
  stroke.settings[&StrokeSettings::dynamics] = {
      {"radius", PenSource::tilt_direction, {-1 / 3.0, 1e-320, 0, 2}},
      {"r\"ö", PenSource::random, {0.1, -0.5}}};
  stroke.fields = {true, true, true, true};
  for (const double time : times) stroke.samples.push_back(any_sample(random, time));
  stroke.samples.back().position = {-0.0, 100, 1e20};
  stroke.samples.back().pen = {std::bit_cast<float>(0x15ae43fdu), -0.0f, -std::bit_cast<float>(0x15ae43fdu),
                               5};
  return recording;
}

TEST(StrokeWriter, WritesNumbersThatAreReadBackBitForBit) {
  const std::uint64_t seed = std::random_device{}();
  std::cout << "seed " << seed << "\n";
  std::mt19937_64 random(seed);
  test::TemporaryFolder folder;
  const Recording recording = any_recording(random);
  write(folder.path() / "a.stroke", recording);
  EXPECT_TRUE(test::same_bits(read_strokes(folder.path() / "a.stroke"), recording));
}

TEST(StrokeWriter, WritesOnlyTheFieldsThatAreThere) {
  test::TemporaryFolder folder;
  Recording recording;
  recording.strokes.resize(1);
  recording.strokes[0].samples.resize(2);
  recording.strokes[0].samples[1].position = {0.5, 1, 2};
  write(folder.path() / "a.stroke", recording);
  EXPECT_EQ(read_file(folder.path() / "a.stroke"),
            "{\"burin_stroke\":1,\"space\":\"object\"}\n"
            "{\"begin\":{},\"fields\":[\"x\",\"y\",\"z\"]}\n"
            "[0,0,0]\n[0.5,1,2]\n{\"end\":true}\n");
  EXPECT_TRUE(test::same_bits(read_strokes(folder.path() / "a.stroke"), recording));
}

TEST(StrokeWriter, WritesToolEraserAndTheButtonAtThePensSide) {
  const test::TemporaryFolder folder;
  Recording recording;
  RecordedStroke& stroke = recording.strokes.emplace_back();
  stroke.fields.barrel = stroke.drawn_by.eraser = true;
  stroke.drawn_by.tool = "pen";
  stroke.samples.resize(2);
  stroke.samples[1].barrel = true;
  recording.strokes.emplace_back().samples.resize(1);
  write(folder.path() / "a.stroke", recording);
  EXPECT_EQ(read_file(folder.path() / "a.stroke"),
            "{\"burin_stroke\":1,\"space\":\"object\"}\n"
            "{\"begin\":{},\"fields\":[\"x\",\"y\",\"z\",\"barrel\"],\"tool\":\"pen\",\"eraser\":true}\n"
            "[0,0,0,0]\n[0,0,0,1]\n{\"end\":true}\n"
            "{\"begin\":{},\"fields\":[\"x\",\"y\",\"z\"]}\n[0,0,0]\n{\"end\":true}\n");
  EXPECT_TRUE(test::same_bits(read_strokes(folder.path() / "a.stroke"), recording));
}

TEST(StrokeWriter, HasEveryLineOnDiskBeforeItReturns) {
  test::TemporaryFolder folder;
  const auto path = folder.path() / "a.stroke";
  StrokeWriter writer(path, StrokeSpace::object, {});
  EXPECT_TRUE(read_strokes(path).strokes.empty());
  writer.begin({});
  for (std::size_t i = 1; i < 5; ++i) {
    writer.add({});
    EXPECT_EQ(read_strokes(path).strokes.at(0).samples.size(), i);
    EXPECT_TRUE(read_strokes(path).cut_off_at);
  }
  writer.end();
  EXPECT_FALSE(read_strokes(path).cut_off_at);
}

TEST(StrokeWriter, WritesTheSameInBlocks) {
  test::TemporaryFolder folder;
  const auto once = folder.path() / "a.stroke", blocks = folder.path() / "b.stroke";
  {
    StrokeWriter at_once(once, StrokeSpace::object, {});
    StrokeWriter in_blocks(blocks, StrokeSpace::object, {}, {}, PassLines::in_blocks);
    for (StrokeWriter* writer : {&at_once, &in_blocks}) {
      writer->begin({});
      writer->add({});
      writer->end();
    }
    EXPECT_EQ(read_file(blocks), "");
    in_blocks.flush();
    EXPECT_EQ(read_file(blocks), read_file(once));
  }
  if (!std::filesystem::exists("/dev/full")) return;
  StrokeWriter full("/dev/full", StrokeSpace::object, {}, {}, PassLines::in_blocks);
  EXPECT_THROW(full.flush(), FileError);
}

TEST(StrokeWriter, RefusesWhatTheReaderWouldRefuse) {
  test::TemporaryFolder folder;
  const auto path = folder.path() / "a.stroke";
  EXPECT_THROW(StrokeWriter(path, StrokeSpace::screen, {}), ContractError);
  EXPECT_THROW(StrokeWriter(path, StrokeSpace::screen, Camera{}), ContractError) << "viewport of no pixels";
  EXPECT_THROW(StrokeWriter(path, StrokeSpace::object, {}, "\xff"), ContractError);
  EXPECT_FALSE(std::filesystem::exists(path));

  StrokeWriter writer(path, StrokeSpace::object, {});
  EXPECT_THROW(writer.add({}), ContractError);
  EXPECT_THROW(writer.end(), ContractError);
  RecordedStroke stroke;
  stroke.settings[&StrokeSettings::radius] = -1;
  EXPECT_THROW(writer.begin(stroke), ContractError);
  stroke.settings[&StrokeSettings::radius] = 1;
  stroke.settings[&StrokeSettings::brush] = "\xff";
  EXPECT_THROW(writer.begin(stroke), ContractError);
  stroke.settings.erase(&StrokeSettings::brush);
  stroke.settings[&StrokeSettings::params] = {{"curve", std::vector<double>{0, std::nan("")}}};
  EXPECT_THROW(writer.begin(stroke), ContractError);
  stroke.settings.erase(&StrokeSettings::params);
  stroke.settings[&StrokeSettings::dynamics] = {{"strength", PenSource::pressure, {0}}};
  EXPECT_THROW(writer.begin(stroke), ContractError);
  stroke.settings.erase(&StrokeSettings::dynamics);
  stroke.fields.time = true;
  writer.begin(stroke);
  EXPECT_THROW(writer.begin(stroke), ContractError);
  writer.add({1, Vec3d::Zero(), {}});
  EXPECT_THROW(writer.add({0.5, Vec3d::Zero(), {}}), ContractError);
  EXPECT_THROW(writer.add({2, Vec3d(0, std::nan(""), 0), {}}), ContractError);
  EXPECT_THROW(writer.add({2, Vec3d::Zero(), {.pressure = 1.5f}}), ContractError);
  writer.end();
  EXPECT_EQ(read_strokes(path).strokes.at(0).samples.size(), 1u);
}

TEST(StrokeWriter, NamesAPlaceThatCannotBeWritten) {
  EXPECT_THROW(StrokeWriter("/nowhere/at/all.stroke", StrokeSpace::object, {}), FileError);
  if (!std::filesystem::exists("/dev/full")) return;
  EXPECT_THROW(StrokeWriter("/dev/full", StrokeSpace::object, {}), FileError);
}

Sample numbered_sample(std::size_t number) {
  const double x = static_cast<double>(number);
  return {x / 125, {x / 3, -x / 7, std::sqrt(x)}, {static_cast<float>(1 / (1 + x)), 0, 0, 0}};
}

using Count = std::atomic<std::size_t>;

/// Writes samples until it is killed; `written` counts those whose add() has returned.
[[noreturn]] void write_for_ever(const std::filesystem::path& path, Count& written) {
  StrokeWriter writer(path, StrokeSpace::object, {});
  RecordedStroke stroke;
  stroke.fields.time = stroke.fields.pressure = true;
  writer.begin(stroke);
  for (std::size_t i = 0;; ++i) {
    writer.add(numbered_sample(i));
    written.store(i + 1);
  }
}

/// Memory that a child process shares.
class SharedCount {
 public:
  SharedCount()
      : memory_(mmap(nullptr, sizeof(Count), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0)),
        count_(new (memory_) Count(0)) {}
  SharedCount(const SharedCount&) = delete;
  SharedCount& operator=(const SharedCount&) = delete;
  ~SharedCount() { munmap(memory_, sizeof(Count)); }
  Count& operator*() { return *count_; }

 private:
  void* memory_;
  Count* count_;
};

TEST(StrokeWriter, LosesAtMostTheSampleBeingWrittenWhenKilled) {
  const unsigned seed = std::random_device{}();
  std::cout << "seed " << seed << "\n";
  std::mt19937 random(seed);
  test::TemporaryFolder folder;
  const auto path = folder.path() / "a.stroke";
  std::size_t most = 0;
  for (int run = 0; run < 30; ++run) {
    SharedCount written;
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) write_for_ever(path, *written);
    while (*written == 0) usleep(100);
    usleep(static_cast<useconds_t>(random() % 20000));
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);

    const Recording recording = read_strokes(path);
    EXPECT_TRUE(recording.cut_off_at);
    const std::vector<Sample>& samples = recording.strokes.at(0).samples;
    EXPECT_GE(samples.size(), *written);
    EXPECT_LE(samples.size(), *written + 1);
    for (std::size_t i = 0; i < samples.size(); ++i)
      ASSERT_TRUE(test::same_bits(samples[i], numbered_sample(i))) << i;
    most = std::max(most, samples.size());
  }
  EXPECT_GT(most, 100u) << "killed before there was anything to lose";
}

}  // namespace
}  // namespace burin
