// Brushes in processes of their own: the same bits, and what a brush that goes wrong costs. The brush
// modules/failing.c really crashes, hangs, exits and lies.
#include <burin/abi/brush.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/wait.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <random>
#include <thread>

#include "host/stock_brush_uses.h"
#include "sanitizers/sanitized.h"
#include "support/shared_data.h"

namespace burin {
namespace {

namespace fs = std::filesystem;
using test::BrushUse;
using test::error_of;

/// The brushes of test::brushes() in processes of their own.
const BrushLibrary& isolated_brushes() {
  static const auto library = [] {
    auto loaded = std::make_unique<BrushLibrary>(nullptr, Isolation());
    loaded->load_folder(test::brushes_folder);
    loaded->load(test::test_brushes_folder / "curve_filters.burin");
    loaded->load(test::test_brushes_folder / "every_input.burin");
    return loaded;
  }();
  return *library;
}

/// What a stroke with dynamics, a curved pen and a mirror image does, a rough number for everything that it
/// made: vertices, paint and voxels.
std::vector<std::uint64_t> result(const BrushLibrary& library, const BrushUse& use, bool mirrored) {
  Session session(make_surface(test::sphere(4, 0.2, 6)), library);
  StrokeSettings settings = test::settings(use.id, 0.3);
  settings.params = use.params;
  settings.symmetry.mirror_x = mirrored;
  test::draw(session, settings, test::wave_on_sphere(12));
  std::vector<std::uint64_t> bits = {session.result_hash()};
  for (const StrokeSolid& part : session.parts())
    for (const VoxelBlock& block : part.blocks())
      for (const float value : block.values) bits.push_back(std::bit_cast<std::uint32_t>(value));
  return bits;
}

class IsolatedStockBrushes : public testing::TestWithParam<BrushUse> {};

std::vector<BrushUse> all_uses() {
  std::vector<BrushUse> uses = test::stock_brush_uses;
  uses.insert(uses.end(), test::solid_brush_uses.begin(), test::solid_brush_uses.end());
  for (const char* id :
       {"org.burin.test.every-input", "org.burin.test.smoothed-curve", "org.burin.test.arch"})
    uses.push_back({id, {}});
  return uses;
}

std::string name_of(const testing::TestParamInfo<BrushUse>& use) {
  std::string name = test::name_of_use(use);
  std::ranges::replace(name, '.', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(All, IsolatedStockBrushes, testing::ValuesIn(all_uses()), name_of);

TEST_P(IsolatedStockBrushes, GiveTheSameBits) {
  const bool makes_solids = std::ranges::any_of(
      test::solid_brush_uses, [](const BrushUse& use) { return std::string_view(use.id) == GetParam().id; });
  const auto here = result(test::brushes(), GetParam(), !makes_solids);
  EXPECT_EQ(here.size() > 1, makes_solids);
  EXPECT_EQ(result(isolated_brushes(), GetParam(), !makes_solids), here);
}

TEST(IsolatedLibrary, HasTheDescriptorsOfTheModules) {
  const auto &here = test::brushes().brushes(), &there = isolated_brushes().brushes();
  ASSERT_GE(there.size(), 25u);
  for (const BrushEntry& brush : there) {
    const burin_brush_descriptor &told = *brush.descriptor,
                                 &known = *test::brushes().find(told.id).descriptor;
    EXPECT_NE(&told, &known);
    EXPECT_STREQ(told.help, known.help);
    EXPECT_EQ(told.inputs_read, known.inputs_read);
    EXPECT_EQ(told.rim_slope, known.rim_slope);
    ASSERT_EQ(told.param_count, known.param_count);
    for (std::uint32_t i = 0; i < told.param_count; ++i) {
      EXPECT_STREQ(told.params[i]->id, known.params[i]->id);
      EXPECT_EQ(told.params[i]->default_number, known.params[i]->default_number);
      EXPECT_EQ(told.params[i]->default_knot_count, known.params[i]->default_knot_count);
    }
  }
  EXPECT_GT(here.size(), there.size());
}

/// The processes that this one has started and not waited for, zombies included.
std::vector<pid_t> children() {
  std::vector<pid_t> numbers;
  for (const auto& task : fs::directory_iterator("/proc/self/task")) {
    std::ifstream list(task.path() / "children");
    for (pid_t number = 0; list >> number;) numbers.push_back(number);
  }
  return numbers;
}

std::size_t open_files() {
  return static_cast<std::size_t>(
      std::distance(fs::directory_iterator("/proc/self/fd"), fs::directory_iterator()));
}

/// How often memory that is shared with brushes is mapped.
std::size_t shared_mappings() {
  std::ifstream maps("/proc/self/maps");
  std::size_t count = 0;
  for (std::string line; std::getline(maps, line);) count += line.find("burin-brush") != std::string::npos;
  return count;
}

/// A session with the failing brush, and what must not have changed when all is over.
class FailingBrush : public testing::Test {
 protected:
  FailingBrush() {
    // What stays for the whole program is there before.
    isolated_brushes();
    files_ = open_files();
    mappings_ = shared_mappings();
    children_ = children();
  }
  ~FailingBrush() override {
    session_.reset();
    library_.reset();
    unsetenv("BURIN_TEST_FAULT");
    EXPECT_EQ(open_files(), files_);
    EXPECT_EQ(shared_mappings(), mappings_);
    EXPECT_EQ(children(), children_) << "no process is left, nor a zombie";
  }

  /// With bounds that a busy machine keeps to, unless others are given.
  void load(const Isolation& isolation = {.batch_seconds = 20}) {
    library_.emplace(
        [this](int severity, std::string_view line) { log_.push_back(fmt::format("{} {}", severity, line)); },
        isolation);
    library_->load(module_);
    session_.emplace(make_surface(test::plane(1, 0.02, 4)), *library_);
  }

  static StrokeSettings with(const std::string& fault) {
    StrokeSettings settings = test::settings("org.burin.test.failing");
    settings.params = {{"text", fault}};
    return settings;
  }

  /// Draws a stroke that must fail, and returns why. The surface must be as before, and drawing go on.
  std::string failure(const std::string& fault) {
    const test::Snapshot before(*session_);
    std::string error = error_of([&] { test::draw(*session_, with(fault), test::wave(6)); });
    EXPECT_TRUE(test::Snapshot(*session_) == before) << fault;
    draw_well();
    return error;
  }

  /// Draws a stroke without a fault, and undoes it.
  void draw_well() {
    const test::Snapshot before(*session_);
    test::draw(*session_, with(""), test::wave(6));
    EXPECT_FALSE(test::Snapshot(*session_) == before);
    EXPECT_TRUE(session_->undo());
    EXPECT_TRUE(test::Snapshot(*session_) == before);
  }

  fs::path module_ = fs::path(BURIN_FAILING_BRUSHES) / "failing.burin";
  std::vector<std::string> log_;
  std::optional<BrushLibrary> library_;
  std::optional<Session> session_;

 private:
  std::size_t files_, mappings_;
  std::vector<pid_t> children_;
};

/// `error` must begin with the brush and go on like this.
void expect_failure(const std::string& error, const std::string& what) {
  EXPECT_EQ(error.find("org.burin.test.failing: " + what), 0u) << error;
}

TEST_F(FailingBrush, CostsItsStrokeAndTellsWhereItCrashed) {
  load();
  expect_failure(failure("evaluate:crash"),
                 "crashed: segmentation fault at address 0x40 in crash_here, failing.burin+0x");
  expect_failure(failure("begin:crash"), "crashed: segmentation fault at address 0x40 in crash_here, ");
  expect_failure(failure("filter:abort"), "crashed: abort in abort_here, failing.burin+0x");
  expect_failure(failure("evaluate:overflow"), "crashed: segmentation fault at address 0x");
  expect_failure(failure("evaluate:exit"), "called exit(3) in exit_here, failing.burin+0x");
  expect_failure(failure("begin:end"), "its process exited with status 4");
  expect_failure(failure("evaluate:kill"), "its process was killed by signal 9");
  EXPECT_TRUE(log_.empty()) << log_[0];
}

TEST_F(FailingBrush, MayTakeSoLongOnly) {
  load({.call_seconds = 0.9, .batch_seconds = 0.8});
  expect_failure(failure("evaluate:hang"), "took more than 0.8 s in hang_here, failing.burin+0x");
  expect_failure(failure("begin:hang"), "took more than 0.9 s in hang_here, failing.burin+0x");
}

TEST_F(FailingBrush, MayTakeSoMuchMemoryOnly) {
  if (test::sanitized) GTEST_SKIP() << "the sanitizer has memory of its own";
  load({.batch_seconds = 20, .memory = std::uint64_t{100} << 20});
  expect_failure(failure("evaluate:allocate"),
                 "crashed: segmentation fault at address 0x0 in allocate_here, ");
  expect_failure(failure("evaluate:leak"), "has no memory at t = ");
}

TEST_F(FailingBrush, ReportsItsErrorsAsInThisProcess) {
  load();
  expect_failure(failure("evaluate:nan"), "returned a displacement that is not finite at t = ");
  expect_failure(failure("evaluate:say"), "says no  at t = ");
  expect_failure(failure("begin:passes"), "asked for 4294967295 passes");
}

TEST_F(FailingBrush, CannotHarmTheHostThroughWhatTheyShare) {
  load({.call_seconds = 0.8, .batch_seconds = 0.8});
  for (const char* place : {"begin", "evaluate", "filter", "end"})
    for (const char* kind : {"scribble", "lie", "stutter", "shrink"}) {
      const std::string error =
          error_of([&] { test::draw(*session_, with(fmt::format("{}:{}", place, kind)), test::wave(6)); });
      while (session_->undo()) {
      }
      draw_well();
    }
}

TEST_F(FailingBrush, HasDrawnItsStrokeWhenItsEndFails) {
  load();
  test::draw(*session_, with("end:crash"), test::wave(6));
  EXPECT_TRUE(session_->undo());
  ASSERT_EQ(log_.size(), 1u);
  EXPECT_EQ(log_[0].find("3 org.burin.test.failing: crashed: segmentation fault"), 0u) << log_[0];
  draw_well();
}

TEST_F(FailingBrush, KeepsTheStateOfItsLastWholeStroke) {
  load();
  const auto height = [&](const std::string& fault) {
    float most = 0;
    if (error_of([&] { test::draw(*session_, with(fault), test::wave(6)); }) != "none") return 0.F;
    for (const Vec3f& position : session_->positions()) most = std::max(most, position.z());
    session_->undo();
    return most;
  };
  const float first = height(""), second = height("");
  EXPECT_NEAR(second, first * 8 / 7, 1e-6F);
  EXPECT_EQ(height("evaluate:crash"), 0.F);
  EXPECT_NEAR(height(""), first * 9 / 7, 1e-6F);
}

TEST_F(FailingBrush, IsPassedOverWhenItCannotBeLoaded) {
  const test::TemporaryFolder folder;
  fs::copy(module_, folder.path());
  fs::copy(test::brushes_folder / "groove.burin", folder.path());
  fs::copy(test::brushes_folder / "bead.burin", folder.path());
  for (const auto& [fault, why] : std::vector<std::pair<const char*, const char*>>{
           {"load:exit", "called exit(3) in exit_here, failing.burin+0x"},
           {"load:end", "its process exited with status 4"},
           {"load:crash", "crashed: segmentation fault at address 0x40 in crash_here, failing.burin+0x"},
           {"init:abort", "crashed: abort in abort_here, failing.burin+0x"},
           {"load:hang", "took more than 0.9 s in hang_here, failing.burin+0x"}}) {
    setenv("BURIN_TEST_FAULT", fault, 1);
    const bool hangs = std::string_view(fault) == "load:hang";
    BrushLibrary library(nullptr, Isolation{.load_seconds = hangs ? 0.9 : 20});
    library.load_folder(folder.path());
    EXPECT_EQ(library.brushes().size(), 2u);
    ASSERT_EQ(library.refused().size(), 1u);
    const std::string begin = (folder.path() / "failing.burin").string() + ": " + why;
    EXPECT_EQ(library.refused()[0].find(begin), 0u) << library.refused()[0];
  }
}

TEST_F(FailingBrush, IsALineWhenItCannotBeCreated) {
  setenv("BURIN_TEST_FAULT", "create:abort", 1);
  load();
  const std::string error = error_of([&] { session_->begin_stroke(with("")); });
  EXPECT_NE(
      error.find(
          "failing.burin: brush org.burin.test.failing cannot be created: crashed: abort in abort_here"),
      std::string::npos)
      << error;
  unsetenv("BURIN_TEST_FAULT");
  draw_well();
}

TEST_F(FailingBrush, NeedsItsProgramAndTime) {
  EXPECT_EQ(error_of([] { BrushLibrary(nullptr, Isolation{.batch_seconds = 0}); }),
            "the time of a brush's batch must be above 0, not 0");
  const std::string error = error_of([&] { load({.program = "/nowhere/burin-brush-process"}); });
  EXPECT_EQ(error, "/nowhere/burin-brush-process: cannot be started: No such file or directory");
}

/// Kills the processes that this one starts beyond those that were there, one after the other.
class Killer {
 public:
  explicit Killer(std::vector<pid_t> spared) : spared_(std::move(spared)) {}

  /// Kills a process that is there, or comes within a second, after this time.
  void kill_after(std::chrono::microseconds time) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(1);
    while (std::chrono::steady_clock::now() < end && !stop_) {
      for (const pid_t process : children())
        if (std::ranges::find(spared_, process) == spared_.end()) {
          std::this_thread::sleep_for(time);
          ::kill(process, SIGKILL);
          return;
        }
    }
  }
  void stop() { stop_ = true; }

 private:
  std::vector<pid_t> spared_;
  std::atomic<bool> stop_ = false;
};

/// Bytes that this process has in memory.
std::size_t resident() {
  std::size_t whole = 0, pages = 0;
  std::ifstream("/proc/self/statm") >> whole >> pages;
  return pages * 4096;
}

/// 40 times, or as often as BURIN_TEST_KILLS says, for a long test by hand. Moments are spread over the start
/// of a process, its stroke and what follows.
TEST_F(FailingBrush, LeavesTheSurfaceAsItWasWheneverItIsKilled) {
  const char* wanted = std::getenv("BURIN_TEST_KILLS");
  const int kills = wanted ? std::atoi(wanted) : 40;
  const unsigned seed = std::random_device{}();
  std::mt19937 engine(seed);
  const std::vector<pid_t> spared = children();
  load({});
  const test::Snapshot before(*session_);
  const auto draw = [&] { test::draw(*session_, with(""), test::wave(8)); };
  using Microseconds = std::chrono::microseconds;
  const auto begun = std::chrono::steady_clock::now();
  draw();
  const auto whole_time = std::chrono::duration_cast<Microseconds>(std::chrono::steady_clock::now() - begun);
  session_->undo();
  const std::size_t resident_before = resident();
  int failed = 0, whole = 0;
  for (int i = 0; i < kills; ++i) {
    const Microseconds time(std::uniform_int_distribution<long>(0, whole_time.count() * 5 / 4)(engine));
    Killer killer(spared);
    std::thread thread([&] { killer.kill_after(time); });
    const std::string error = error_of(draw);
    killer.stop();
    thread.join();
    (error == "none" ? whole : failed) += 1;
    if (error == "none")
      EXPECT_TRUE(session_->undo());
    else
      EXPECT_NE(error.find("its process was killed by signal 9"), std::string::npos) << error;
    ASSERT_TRUE(test::Snapshot(*session_) == before) << "seed " << seed << ", kill " << i;
  }
  std::cout << fmt::format("seed {}: {} strokes of {:.3g} ms failed, {} were whole, {} kB more in memory\n",
                           seed, failed, static_cast<double>(whole_time.count()) / 1000, whole,
                           (static_cast<long>(resident()) - static_cast<long>(resident_before)) / 1024);
  EXPECT_GT(failed, kills / 4) << "representative";
  if (!test::sanitized) EXPECT_LT(resident(), resident_before + (std::size_t{64} << 20));
  // The last process may have been killed after its stroke, and still be ending when the next one begins.
  if (error_of(draw) == "none") EXPECT_TRUE(session_->undo());
  draw_well();
}

}  // namespace
}  // namespace burin
