#include "sanitizers/sanitized.h"
#include "sessions.h"
#include "support/shared_data.h"

#include <burin/host/replay.h>
#include <burin/host/stroke_pieces.h>
#include <burin/host/stroke_recorder.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <iostream>
#include <random>

namespace burin {
namespace {

using test::error_of;

constexpr PenFields tablet{.time = true, .pressure = true, .tilt = true, .twist = false, .barrel = true};

/// A brush with random numbers, so that the seed matters, and dynamics.
GivenSettings bark() {
  GivenSettings settings;
  settings[&StrokeSettings::brush] = "org.burin.bark";
  settings[&StrokeSettings::radius] = 0.12;
  settings[&StrokeSettings::dynamics] = {{"strength", PenSource::pressure, {0, 0, 1, 1}},
                                         {"radius", PenSource::speed, {0, 0.4, 10, 1}}};
  return settings;
}

/// Looks down on the plane [-1, 1]^2 at an angle.
Camera camera() { return framing_camera({-1, -1, 0}, {1, 1, 0}, {0.2, 0.3, -1}, {0, 1, 0}, 640, 480, 0.6); }

/// Draws and records strokes as an application does. `at` makes of a position what the session takes.
template <class At>
void draw(Session& session, StrokeRecorder& recorder, const std::vector<Sample>& samples, const At& at) {
  const ReplaySettings settings = recorder.begin(bark(), tablet, {"pen", true});
  StrokePieces stroke(session, settings, settings.closure);
  for (const Sample& sample : samples) {
    recorder.add(sample);
    stroke.add(at(sample), sample.time, sample.pen);
  }
  stroke.end();
  recorder.end();
}

std::uint64_t hash_of_replay(const std::filesystem::path& path) {
  Session session = test::plane_session();
  return replay(session, read_strokes(path)).hash;
}

TEST(StrokeRecorder, RecordsWhatReplaysToTheSameHash) {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "a.stroke";
  Session session = test::plane_session();
  StrokeRecorder recorder(path, StrokeSpace::object, {}, "Intuos Pro M");
  std::vector<Sample> off = test::wave(60);
  for (std::size_t i = 20; i < 30; ++i) off[i].position.z() = 9;  // the pen leaves the surface
  for (std::size_t i = 0; i < off.size(); i += 7) off[i].barrel = true;
  for (const auto& samples : {test::wave(), off, test::wave(15)})
    draw(session, recorder, samples, [](const Sample& sample) { return sample.position; });
  EXPECT_EQ(hash_of_replay(path), session.result_hash());
  EXPECT_EQ(read_strokes(path).device, "Intuos Pro M");
  const Recording read = read_strokes(path);
  ASSERT_EQ(read.strokes.size(), 3u);
  EXPECT_EQ(read.strokes[1].drawn_by, (DrawnBy{"pen", true}));
  for (std::size_t i = 0; i < off.size(); ++i) EXPECT_EQ(read.strokes[1].samples.at(i).barrel, i % 7 == 0);
}

TEST(StrokeRecorder, RecordsPixelsOfACamera) {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "a.stroke";
  Session session = test::plane_session();
  StrokeRecorder recorder(path, StrokeSpace::screen, camera());
  std::vector<Sample> pixels = test::wave();
  for (Sample& sample : pixels)
    sample.position = {320 + 230 * sample.position.x(), 240 + 230 * sample.position.y(), 0};
  draw(session, recorder, pixels,
       [](const Sample& sample) { return pixel_ray(camera(), sample.position.x(), sample.position.y()); });
  EXPECT_GT(session.chart().size(), 100u);
  EXPECT_EQ(hash_of_replay(path), session.result_hash());
}

TEST(StrokeRecorder, ReturnsWhatIsRecordedOfTheSettings) {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "a.stroke";
  StrokeRecorder recorder(path, StrokeSpace::object);
  GivenSettings settings = bark();
  settings[&StrokeSettings::cap] = Cap::butt;
  settings[&StrokeSettings::seed] = 77;
  settings[&ReplaySettings::closure] = Closure::automatic;
  recorder.begin(settings, tablet);
  recorder.end();
  const ReplaySettings second = recorder.begin(settings, tablet);
  recorder.end();
  EXPECT_EQ(second.cap, Cap::round) << "recordings do not keep it";
  EXPECT_EQ(second.seed, 1u);
  EXPECT_EQ(second.closure, Closure::automatic);
  EXPECT_EQ(second.fields, tablet);
  EXPECT_EQ(second.brush, "org.burin.bark");
  EXPECT_EQ(read_strokes(path).strokes.at(1).settings.complete().closure, Closure::automatic);
}

TEST(StrokeRecorder, RefusesWithoutWriting) {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "a.stroke";
  StrokeRecorder recorder(path, StrokeSpace::object);
  EXPECT_EQ(error_of([&] { recorder.begin({}, tablet); }), "stroke 1 names no brush");
  EXPECT_EQ(error_of([&] { recorder.add({}); }), "stroke file: a sample outside a stroke");
  recorder.begin(bark(), tablet);
  EXPECT_EQ(error_of([&] { recorder.begin(bark(), tablet); }), "stroke file: begin within a stroke");
  recorder.add({.time = 2, .pen = {}});
  EXPECT_EQ(error_of([&] { recorder.add({.time = 1, .pen = {}}); }), "stroke file: time falls");
  recorder.end();
  EXPECT_EQ(recorder.begin(bark(), tablet).seed, 1u) << "what was refused is no stroke";
  EXPECT_EQ(read_strokes(path).strokes.at(0).samples.size(), 1u);
  EXPECT_THROW(StrokeRecorder(path, StrokeSpace::screen), ContractError);
}

Sample numbered_sample(std::size_t number) {
  const double x = static_cast<double>(number);
  return {x / 125, {x / 3, -x / 7, std::sqrt(x)}, {static_cast<float>(1 / (1 + x)), 0, 0, 0}};
}

/// Records until it is killed, 100 samples a stroke; tells the pipe of every sample that add() took.
[[noreturn]] void record_for_ever(const std::filesystem::path& path, int pipe) {
  StrokeRecorder recorder(path, StrokeSpace::object, {}, "tablet");
  for (std::size_t i = 0;; ++i) {
    if (i % 100 == 0) recorder.begin(bark(), tablet);
    recorder.add(numbered_sample(i));
    if (write(pipe, "", 1) != 1) _exit(1);
    if (i % 100 == 99) recorder.end();
  }
}

/// How many samples a process that records had handed over when it was killed after this time.
std::size_t handed_over_until_killed(const std::filesystem::path& path, useconds_t microseconds) {
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("pipe");
  const pid_t child = fork();
  if (child == 0) record_for_ever(path, ends[1]);
  close(ends[1]);
  std::size_t count = 0;
  const auto end = std::chrono::steady_clock::now() + std::chrono::microseconds(microseconds);
  char bytes[4096];
  const auto receive = [&] {
    const ssize_t got = read(ends[0], bytes, sizeof bytes);
    count += static_cast<std::size_t>(std::max<ssize_t>(got, 0));
    return got > 0;
  };
  while (receive() && std::chrono::steady_clock::now() < end) {
  }
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  while (receive()) {
  }
  close(ends[0]);
  return count;
}

TEST(StrokeRecorder, LosesAtMostTheLineInFlightWhenItsProcessIsKilled) {
  const unsigned seed = std::random_device{}();
  std::cout << "seed " << seed << "\n";
  std::mt19937 random(seed);
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "a.stroke";
  std::size_t most = 0;
  for (int run = 0; run < 20; ++run) {
    const std::size_t handed_over =
        handed_over_until_killed(path, static_cast<useconds_t>(500 + random() % 20000));
    std::size_t read_back = 0;
    for (const RecordedStroke& stroke : read_strokes(path).strokes)
      for (const Sample& sample : stroke.samples) {
        ASSERT_EQ(sample.position, numbered_sample(read_back).position) << read_back;
        ++read_back;
      }
    EXPECT_GE(read_back, handed_over);
    EXPECT_LE(read_back, handed_over + 1);
    most = std::max(most, read_back);
  }
  EXPECT_GT(most, 300u) << "killed before there was anything to lose";
}

TEST(StrokeRecorder, TakesAFewMicrosecondsASample) {
  const test::TemporaryFolder folder;
  StrokeRecorder recorder(folder.path() / "a.stroke", StrokeSpace::object);
  recorder.begin(bark(), tablet);
  std::vector<double> microseconds(20000);
  for (std::size_t i = 0; i < microseconds.size(); ++i) {
    const Sample sample = numbered_sample(i);
    const auto start = std::chrono::steady_clock::now();
    recorder.add(sample);
    microseconds[i] =
        std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count();
  }
  std::ranges::sort(microseconds);
  const double median = microseconds[microseconds.size() / 2];
  std::cout << "median " << median << " us, 99 of 100 within " << microseconds[microseconds.size() / 100 * 99]
            << " us\n";
  if (!test::sanitized) EXPECT_LT(median, 20) << "1.5 when little else runs";
}

}  // namespace
}  // namespace burin
