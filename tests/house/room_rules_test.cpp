// Folders of the house have rooms where they would hold too many files: small ones, with includes in one
// direction, and tests that are found where their sources are.
#include "room_rules.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "plant.h"
#include "support/shared_data.h"

namespace burin::test {
namespace {

namespace fs = std::filesystem;
using Faults = std::vector<std::string>;

TEST(RoomRules, HoldInTheRepository) {
  EXPECT_EQ(wrong_room_includes(BURIN_SOURCE_FOLDER), Faults());
  EXPECT_EQ(rooms_in_circles(), Faults());
  EXPECT_EQ(crowded_folders(BURIN_SOURCE_FOLDER), Faults());
  EXPECT_EQ(misplaced_tests(BURIN_SOURCE_FOLDER), Faults());
}

TEST(RoomRules, AllowTheTopRoomsBelowAndOtherFolders) {
  const TemporaryFolder folder;
  plant(folder.path() / "sdk/burin/chart/chart.h", "#include <burin/chart/chart_frame.h>\n");
  plant(folder.path() / "sdk/burin/chart/chart.cpp", "#include <burin/chart/front/front.h>\n");
  plant(folder.path() / "sdk/burin/chart/front/front.h",
        "#include <burin/chart/chart.h>\n#include <burin/chart/path/visit.h>\n"
        "#include <burin/surface/base_surface/base_surface.h>\n#include \"front_part.h\"\n");
  plant(folder.path() / "host_stub/options/view.h",
        "#include \"cli_fwd.h\"\n#include \"system/console.h\"\n");
  EXPECT_EQ(wrong_room_includes(folder.path()), Faults());
}

TEST(RoomRules, CatchAnIncludeAgainstTheFlow) {
  const TemporaryFolder folder;
  plant(folder.path() / "sdk/burin/chart/path/visit.cpp",
        "#include <vector>\n#include <burin/chart/front/front.h>\n");
  plant(folder.path() / "sdk/burin/chart/attic/a.h", "#include <vector>\n");
  plant(folder.path() / "host_stub/system/console.cpp", "#include \"options/view.h\"\n");
  EXPECT_EQ(wrong_room_includes(folder.path()),
            Faults({"host_stub/system/console.cpp:1: host_stub/system must not include host_stub/options",
                    "sdk/burin/chart/attic/a.h:1: no rule names the room chart/attic",
                    "sdk/burin/chart/path/visit.cpp:2: chart/path must not include chart/front"}));
}

TEST(RoomRules, CatchAHeaderOfTheTopThatLeadsBack) {
  const TemporaryFolder folder;
  plant(folder.path() / "sdk/burin/chart/builder.h", "#include <burin/chart/parts.h>\n");
  plant(folder.path() / "sdk/burin/chart/parts.h", "#include <burin/chart/joins/joins.h>\n");
  plant(folder.path() / "sdk/burin/chart/joins/joins.h", "#include <burin/chart/builder.h>\n");
  plant(folder.path() / "sdk/burin/chart/path/visit.h", "#include <burin/chart/parts.h>\n");
  EXPECT_EQ(wrong_room_includes(folder.path()),
            Faults({"sdk/burin/chart/joins/joins.h:1: chart/joins must not include chart/joins",
                    "sdk/burin/chart/path/visit.h:1: chart/path must not include chart/joins"}));
}

TEST(RoomRules, CountAHeaderItsSourceAndItsTestOnce) {
  const TemporaryFolder folder;
  for (int i = 0; i < 20; ++i)
    for (const char* end : {".h", ".cpp", "_test.cpp"})
      plant(folder.path() / ("tests/bench/a" + std::to_string(i) + end), "");
  EXPECT_EQ(crowded_folders(folder.path()), Faults());
  plant(folder.path() / "tests/bench/b.h", "");
  plant(folder.path() / "tests/bench/room/c.h", "");
  EXPECT_EQ(crowded_folders(folder.path()), Faults({"tests/bench: 21"}));
}

TEST(RoomRules, CatchATestInAnotherRoomThanItsSource) {
  const TemporaryFolder folder;
  plant(folder.path() / "sdk/burin/chart/front/front.h", "");
  plant(folder.path() / "sdk/burin/chart/chart.h", "");
  plant(folder.path() / "host_stub/bench/suite.cpp", "");
  for (const char* test :
       {"chart/front/front_test.cpp", "chart/chart_test.cpp", "chart/accuracy/shooting_test.cpp",
        "host_stub/bench/suite_test.cpp", "deform/front_test.cpp"})
    plant(folder.path() / "tests" / test, "");
  EXPECT_EQ(misplaced_tests(folder.path()), Faults());
  plant(folder.path() / "tests/chart/front_test.cpp", "");
  plant(folder.path() / "tests/chart/front/chart_test.cpp", "");
  EXPECT_EQ(misplaced_tests(folder.path()),
            Faults({"tests/chart/front/chart_test.cpp", "tests/chart/front_test.cpp"}));
}

}  // namespace
}  // namespace burin::test
