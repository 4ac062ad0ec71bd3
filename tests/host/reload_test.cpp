// Loads modules anew, BrushLibrary::reload(), while sessions draw with their brushes.
#include <burin/abi/brush.h>
#include <malloc.h>

#include <fstream>

#include "sanitizers/sanitized.h"
#include "sessions.h"
#include "support/shared_data.h"

namespace burin {
namespace {

namespace fs = std::filesystem;
using test::error_of;

class Reload : public ::testing::Test {
 protected:
  Reload() { put(1); }

  /// Overwrites the module's file with this version, in place.
  void put(int revision) {
    fs::copy_file(fs::path(BURIN_RELOADED_BRUSHES) / ("reloaded_" + std::to_string(revision) + ".burin"),
                  module_, fs::copy_options::overwrite_existing);
  }

  /// Loads the module, from a copy from the start, since its file is going to be overwritten.
  void load() {
    brushes_.load(module_);
    brushes_.reload(module_);
  }

  Session session() { return Session(make_surface(test::plane(1, 0.02, 4)), brushes_); }

  /// Draws a stroke, undoes it, and returns how high it was.
  static double height(Session& session) {
    StrokeSettings settings = test::settings("org.burin.test.reloaded");
    settings.params = {{"height", 0.5}};
    test::draw(session, settings, test::wave());
    float most = 0;
    for (const Vec3f& position : session.positions()) most = std::max(most, position.z());
    session.undo();
    return static_cast<double>(most);
  }

  test::TemporaryFolder folder_;
  fs::path module_ = folder_.path() / "reloaded.burin";
  BrushLibrary brushes_;
};

TEST_F(Reload, DrawsTheNextStrokeWithTheNewModule) {
  load();
  Session drawn = session();
  const double before = height(drawn);
  EXPECT_NEAR(before, 0.5 * 0.15, 0.01);
  put(2);
  brushes_.reload(module_);
  Session fresh = session();
  EXPECT_NEAR(height(fresh), 2 * before, 1e-6);
  EXPECT_STREQ(brushes_.brushes()[0].descriptor->params[1]->id, "amount");
}

TEST_F(Reload, CarriesTheStateOver) {
  load();
  Session drawn = session();
  const double first = height(drawn), second = height(drawn);
  EXPECT_NEAR(second, first * 8 / 7, 1e-6);
  put(2);
  brushes_.reload(module_);
  EXPECT_NEAR(height(drawn), 2 * first * 9 / 7, 1e-6);
  EXPECT_TRUE(drawn.warnings().empty());
}

TEST_F(Reload, SaysWhichStateIsLost) {
  load();
  Session drawn = session();
  const double first = height(drawn);
  put(3);
  brushes_.reload(module_);
  EXPECT_NEAR(height(drawn), 2 * first, 1e-6);
  ASSERT_EQ(drawn.warnings().size(), 1u);
  EXPECT_EQ(drawn.warnings()[0], "org.burin.test.reloaded: its state is lost: written by another version");
}

TEST_F(Reload, LeavesAnOpenStrokeToTheOldModule) {
  load();
  Session plain = session(), interrupted = session();
  const StrokeSettings settings = test::settings("org.burin.test.reloaded");
  test::draw(plain, settings, test::wave());
  interrupted.begin_stroke(settings);
  const std::vector<Sample> samples = test::wave();
  test::add(interrupted, {samples.begin(), samples.begin() + 20});
  put(2);
  brushes_.reload(module_);
  test::add(interrupted, {samples.begin() + 20, samples.end()});
  interrupted.end_stroke();
  EXPECT_EQ(interrupted.result_hash(), plain.result_hash());
}

TEST_F(Reload, KeepsTheOldModuleWhereTheNewOneDoesNotLoad) {
  load();
  Session drawn = session();
  const double first = height(drawn);
  std::ofstream(module_) << "not a library";
  EXPECT_EQ(error_of([&] { brushes_.reload(module_); }), module_.string() + ": file too short");
  EXPECT_NEAR(height(drawn), first * 8 / 7, 1e-6);
}

TEST_F(Reload, RefusesWhatWasNeverLoaded) {
  EXPECT_EQ(error_of([&] { brushes_.reload(module_); }), module_.string() + ": is no module that was loaded");
}

/// Parts of the process that come from files that are gone, as the copies of modules are.
std::size_t loaded_parts() {
  std::ifstream maps("/proc/self/maps");
  std::size_t count = 0;
  for (std::string line; std::getline(maps, line);) count += line.ends_with("(deleted)");
  return count;
}

TEST_F(Reload, LeavesNothingBehind) {
  load();
  Session drawn = session();
  const auto reload = [&](int times) {
    for (int i = 0; i < times; ++i) {
      put(1 + i % 2);
      brushes_.reload(module_);
      if (i % 5 == 4) height(drawn);
    }
    return mallinfo2().uordblks;
  };
  const std::size_t before = reload(10), parts = loaded_parts();
  const std::size_t after = reload(200);
  EXPECT_EQ(loaded_parts(), parts);
  EXPECT_GT(parts, 0u);
  if (!test::sanitized) EXPECT_LT(after, before + 20000);
}

}  // namespace
}  // namespace burin
