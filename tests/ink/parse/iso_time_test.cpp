#include <burin/ink/parse/iso_time.h>
#include <gtest/gtest.h>

namespace burin {
namespace {

TEST(IsoTime, HasTheSecondsSince1970) {
  EXPECT_EQ(iso_time("1970-01-01T00:00:00Z"), 0);
  EXPECT_EQ(iso_time("1970-01-02 00:01:02.5"), 86462.5);
  EXPECT_EQ(iso_time("1970-01-01T01:30+01:30"), 0);
  EXPECT_EQ(iso_time("1970-01-01T00:00:00-0100"), 3600);
  EXPECT_EQ(iso_time("2024-02-29T00:00:00"), 1709164800);
}

TEST(IsoTime, KnowsNoOtherText) {
  for (const char* text :
       {"", "2024", "2024-01-01", "2024-13-01T00:00", "2023-02-29T00:00", "2024-01-01T1:00",
        "-024-01-01T00:00", "2024-01-01T00:00:00 or so", "2024-01-01T00:00:00+1", "2024-01-01T00:00:"})
    EXPECT_EQ(iso_time(text), std::nullopt) << text;
}

}  // namespace
}  // namespace burin
