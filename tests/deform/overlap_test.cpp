#include <burin/abi/brush.h>
#include <burin/deform/overlap.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <set>

namespace burin {
namespace {

TEST(Overlap, IsWhatTheDescriptorSays) {
  burin_brush_descriptor brush{};
  brush.struct_size = sizeof brush;
  std::set<Overlap> all;
  for (burin_overlap said = BURIN_OVERLAP_STRONGEST; said <= BURIN_OVERLAP_AVERAGE; ++said) {
    brush.overlap = said;
    all.insert(overlap_of(brush));
  }
  EXPECT_EQ(all.size(), named_overlaps.size());
  brush.overlap = BURIN_OVERLAP_LATEST;
  EXPECT_EQ(overlap_of(brush), Overlap::latest);
}

TEST(Overlap, IsStrongestForBrushesThatDoNotSay) {
  burin_brush_descriptor brush{};
  brush.struct_size = sizeof brush;
  EXPECT_EQ(overlap_of(brush), Overlap::strongest);
  brush.struct_size = offsetof(burin_brush_descriptor, overlap);
  brush.overlap = BURIN_OVERLAP_LATEST;  // beyond what a plugin of version 1.0 has
  EXPECT_EQ(overlap_of(brush), Overlap::strongest);
}

TEST(Overlap, DoesNotAddUpOverPasses) {
  EXPECT_EQ(over_passes(Overlap::add, 1), Overlap::add);
  EXPECT_EQ(over_passes(Overlap::add, 2), Overlap::strongest);
  EXPECT_EQ(over_passes(Overlap::average, 2), Overlap::average);
}

TEST(Overlap, HasNames) {
  for (const auto& [name, overlap] : named_overlaps) EXPECT_EQ(name_of(named_overlaps, overlap), name);
  EXPECT_EQ(name_of(named_overlaps, Overlap::latest), "latest");
}

}  // namespace
}  // namespace burin
