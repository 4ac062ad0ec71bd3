#include <burin/plugin/log.h>
#include <burin/plugin/stamps.h>
#include <gtest/gtest.h>

#include <utility>

#include "driver.h"

namespace burin {
namespace {

using Line = std::pair<burin_log_severity, std::string>;

TEST(Log, ReachesTheHost) {
  test::TestHost host;
  const plugin::Log log{plugin::Host(&host.abi)};
  log.debug("a");
  log.info("b");
  log.warning("c");
  log.error("d");
  EXPECT_EQ(
      host.lines,
      (std::vector<Line>{
          {BURIN_LOG_DEBUG, "a"}, {BURIN_LOG_INFO, "b"}, {BURIN_LOG_WARNING, "c"}, {BURIN_LOG_ERROR, "d"}}));
}

TEST(Log, IsSilentWhereTheHostKeepsNone) {
  test::TestHost host;
  host.withholds_services = true;
  plugin::Log{plugin::Host(&host.abi)}.info("a");
  host.withholds_services = false;
  host.log_struct_size = offsetof(burin_log, write);
  plugin::Log{plugin::Host(&host.abi)}.info("a");
  host.abi.struct_size = offsetof(burin_host, get_extension);
  plugin::Log{plugin::Host(&host.abi)}.info("a");
  EXPECT_TRUE(host.lines.empty());
}

TEST(Stamp, IsClosedOnceThoughMoved) {
  test::TestHost host;
  {
    plugin::Stamp first(plugin::Host(&host.abi), "ramp.exr");
    const plugin::Stamp second(std::move(first));
    EXPECT_EQ(second.info().width, 64u);
    EXPECT_EQ(host.open_stamps, 1);
  }
  EXPECT_EQ(host.open_stamps, 0);
}

TEST(Stamp, SamplesAnyNumberOfPlaces) {
  test::TestHost host;
  const plugin::Stamp stamp(plugin::Host(&host.abi), "ramp.exr");
  const auto u = [](std::size_t i) { return static_cast<float>(i) / 1000 + 3; };
  for (const std::size_t count : {1u, 255u, 256u, 257u, 600u}) {
    std::vector<float> values(2 * count + 2, -1);
    stamp.sample(count,
                 [&](std::size_t i) {
                   return plugin::StampArea{{u(i), 0.25f}, {}, {}};
                 },
                 {values.data(), 2});
    for (std::size_t i = 0; i < count; ++i) ASSERT_EQ(values[2 * i], test::TestHost::ramp(u(i), 0.25)) << i;
    EXPECT_EQ(values[2 * count], -1);
  }
}

TEST(Stamp, ThrowsWhenTheHostRefusesToSample) {
  test::TestHost host;
  const plugin::Stamp stamp(plugin::Host(&host.abi), "ramp.exr");
  float value = 0;
  const auto corner = [](std::size_t) { return plugin::StampArea{}; };
  EXPECT_THROW(stamp.sample(1, corner, {&value, 1}, 5), plugin::Error);
}

}  // namespace
}  // namespace burin
