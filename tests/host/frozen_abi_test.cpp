// Draws with a module that was built with the headers of ABI 1.0, tests/abi/frozen.
#include <burin/abi/brush.h>
#include <burin/base/file.h>
#include <burin/base/hash.h>
#include <burin/deform/overlap.h>

#include "sessions.h"

namespace burin {
namespace {

const std::filesystem::path frozen = BURIN_FROZEN_ABI "/ridge.burin";

class FrozenAbi : public ::testing::Test {
 protected:
  void SetUp() override {
#if !defined(__x86_64__) || !defined(__linux__)
    GTEST_SKIP() << "the module is for x86-64 Linux";
#endif
  }
};

TEST_F(FrozenAbi, IsTheModuleThatWasBuiltThen) {
  const std::string bytes = read_file(frozen);
  EXPECT_EQ(hash_text(hash_bytes(bytes.data(), bytes.size())), "068d5802d8e1521d");
}

TEST_F(FrozenAbi, TakesWhatItsDescriptorDoesNotHaveAsTheDefault) {
  BrushLibrary brushes;
  brushes.load(frozen);
  const burin_brush_descriptor& ridge = *brushes.find("org.burin.frozen.ridge").descriptor;
  EXPECT_FALSE(BURIN_HAS(&ridge, burin_brush_descriptor, overlap));
  EXPECT_EQ(overlap_of(ridge), Overlap::strongest);
}

TEST_F(FrozenAbi, DrawsTheSameStrokeForEver) {
  BrushLibrary brushes;
  brushes.load(frozen);
  Session session(make_surface(test::plane(1, 0.02, 4)), brushes);
  StrokeSettings settings = test::settings("org.burin.frozen.ridge");
  settings.params = {{"height", 0.5}};
  test::draw(session, settings, test::wave());
  EXPECT_EQ(hash_text(session.result_hash()), "d6f9b7035aabb7ca");
}

}  // namespace
}  // namespace burin
