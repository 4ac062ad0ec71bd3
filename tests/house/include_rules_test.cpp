#include "include_rules.h"

#include <gtest/gtest.h>

#include "plant.h"
#include "support/shared_data.h"

namespace burin::test {
namespace {

using Faults = std::vector<std::string>;

TEST(IncludeRules, HoldInTheRepository) {
  EXPECT_GT(count_includes(BURIN_SOURCE_FOLDER), 100u);
  EXPECT_EQ(wrong_includes(BURIN_SOURCE_FOLDER), Faults());
}

TEST(IncludeRules, AllowWhatANamedFolderMayInclude) {
  TemporaryFolder folder;
  plant(folder.path() / "sdk/burin/chart/a.cpp", "#include <burin/base/vector.h>\n#include \"front.h\"\n");
  plant(folder.path() / "sdk/burin/abi/ext/a.h", "#include \"../base.h\"\n#include <stdint.h>\n");
  plant(folder.path() / "host_stub/a.cpp", "#include <burin/chart/chart.h>\n#include <burin/abi/brush.h>\n");
  EXPECT_EQ(count_includes(folder.path()), 6u);
  EXPECT_EQ(wrong_includes(folder.path()), Faults());
}

TEST(IncludeRules, CatchAnIncludeAgainstTheFlow) {
  TemporaryFolder folder;
  plant(folder.path() / "sdk/burin/chart/a.cpp", "#include <vector>\n#include <burin/abi/brush.h>\n");
  plant(folder.path() / "sdk/burin/surface/b.h", "  # include \"../chart/chart.h\"\n");
  plant(folder.path() / "brushes/c.cpp",
        "#include <burin/plugin/brush.h>\n#include <burin/surface/surface.h>\n");
  EXPECT_EQ(wrong_includes(folder.path()),
            Faults({"brushes/c.cpp:2: brushes must not include burin/surface/surface.h",
                    "sdk/burin/chart/a.cpp:2: chart must not include burin/abi/brush.h",
                    "sdk/burin/surface/b.h:1: surface must not include ../chart/chart.h"}));
}

TEST(IncludeRules, KeepThirdPartyHeadersInTheirFolder) {
  TemporaryFolder folder;
  plant(folder.path() / "sdk/burin/surface/a.cpp",
        "#include <nanoflann.hpp>\n#include <opensubdiv/far/x.h>\n");
  plant(folder.path() / "sdk/burin/abi/b.h", "#include <stdbool.h>\n");
  plant(folder.path() / "sdk/burin/chart/c.cpp", "#include <boost/heap/x.hpp>\n#include <CGAL/x.h>\n");
  EXPECT_EQ(wrong_includes(folder.path()),
            Faults({"sdk/burin/abi/b.h:1: abi must not include stdbool.h",
                    "sdk/burin/chart/c.cpp:1: no rule names boost/heap/x.hpp",
                    "sdk/burin/chart/c.cpp:2: chart must not include CGAL/x.h",
                    "sdk/burin/surface/a.cpp:2: surface must not include opensubdiv/far/x.h"}));
}

TEST(IncludeRules, CatchAFolderOutsideTheHouse) {
  TemporaryFolder folder;
  plant(folder.path() / "sdk/burin/util/a.h", "#include <vector>\n");
  EXPECT_EQ(wrong_includes(folder.path()), Faults({"sdk/burin/util/a.h:1: no rule names the folder util"}));
}

}  // namespace
}  // namespace burin::test
