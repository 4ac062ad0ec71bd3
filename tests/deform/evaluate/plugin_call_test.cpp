#include <burin/deform/evaluate/plugin_call.h>
#include <gtest/gtest.h>

#include <thread>

namespace burin {
namespace {

TEST(PluginCall, NamesWhoseCodeTheThreadRuns) {
  EXPECT_EQ(PluginCall::running(), "");
  {
    const PluginCall outer("plugin", "a.burin");
    EXPECT_EQ(PluginCall::running(), "plugin a.burin");
    {
      const PluginCall inner("brush", "org.example.a");
      EXPECT_EQ(PluginCall::running(), "brush org.example.a");
      std::thread([] { EXPECT_EQ(PluginCall::running(), "") << "another thread"; }).join();
    }
    EXPECT_EQ(PluginCall::running(), "plugin a.burin");
  }
  EXPECT_EQ(PluginCall::running(), "");
}

}  // namespace
}  // namespace burin
