#include <burin/deform/evaluate/plugin_call.h>
#include <gtest/gtest.h>

#include <string>
#include <thread>

namespace burin {
namespace {

/// "KIND NAME" of the plugin whose code this thread runs; empty if none.
std::string running() {
  const RunningPlugin plugin = PluginCall::running();
  return plugin.name ? std::string(plugin.kind) + " " + plugin.name : "";
}

TEST(PluginCall, NamesWhoseCodeTheThreadRuns) {
  EXPECT_EQ(running(), "");
  {
    const PluginCall outer("plugin", "a.burin");
    EXPECT_EQ(running(), "plugin a.burin");
    {
      const PluginCall inner("brush", "org.example.a");
      EXPECT_EQ(running(), "brush org.example.a");
      std::thread([] { EXPECT_EQ(running(), "") << "another thread"; }).join();
    }
    EXPECT_EQ(running(), "plugin a.burin");
  }
  EXPECT_EQ(running(), "");
}

}  // namespace
}  // namespace burin
